package troupe.app.help;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import troupe.app.look.Look;
import troupe.app.look.widget.FlatButton;
import troupe.paint.Tone;
import troupe.run.file.RunFile;

/** Says what the program is, in which version, and on which Java it runs. */
public final class AboutPanel extends JPanel {

    /** Makes the panel. */
    public AboutPanel(Look look) {
        super(new BorderLayout(0, 12));
        setName("about.panel");
        setOpaque(false);
        String program = RunFile.program();
        String version = look.texts()
                .format(
                        "about.version",
                        look.texts().get("about." + program, program),
                        System.getProperty("java.version"),
                        System.getProperty("java.vendor"),
                        System.getProperty("os.name"));
        JTextArea text =
                new JTextArea(look.text("about.text") + "\n\n" + version + "\n\n" + look.text("about.licence"));
        text.setName("about.text");
        text.setFont(look.font(12.5f));
        text.setForeground(look.color(Tone.TEXT));
        text.setBackground(look.color(Tone.PANEL));
        text.setEditable(false);
        text.setLineWrap(true);
        text.setWrapStyleWord(true);
        text.setBorder(null);
        text.getAccessibleContext().setAccessibleName(look.text("about.title"));
        add(text, BorderLayout.CENTER);
        FlatButton copy = new FlatButton(look, FlatButton.Style.PILL);
        copy.setText(look.text("about.copy"));
        copy.setName("about.copy");
        copy.addActionListener(e -> {
            copy.setSelected(false);
            Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(version), null);
        });
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.RIGHT, 0, 0));
        buttons.setOpaque(false);
        buttons.add(copy);
        add(buttons, BorderLayout.SOUTH);
    }
}
