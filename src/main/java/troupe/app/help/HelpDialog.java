package troupe.app.help;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.WindowConstants;
import troupe.app.look.Look;
import troupe.app.look.Scaling;
import troupe.paint.Tone;

/** Shows help in a window of its own beside the scene, which can be worked meanwhile; Escape closes it. */
public final class HelpDialog {
    private HelpDialog() {}

    /**
     * Opens a window, or brings the one of that name to the front.
     *
     * @param name the word for it; the title is the text of {@code name.title}
     * @param size in pixels at 100 %; the screen's where that is smaller
     */
    public static void open(JFrame over, Look look, String name, JComponent content, Dimension size) {
        close(over, name);
        JDialog dialog = new JDialog(over, look.text(name + ".title"), false);
        dialog.setName(name);
        dialog.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        JPanel all = new JPanel(new BorderLayout());
        all.setBackground(look.color(Tone.PANEL));
        all.setBorder(BorderFactory.createCompoundBorder(
                look.line(1, 1, 1, 1), BorderFactory.createEmptyBorder(16, 18, 16, 18)));
        all.add(content, BorderLayout.CENTER);
        dialog.setContentPane(new Scaling(look::scale).apply(all));
        dialog.getRootPane()
                .getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW)
                .put(KeyStroke.getKeyStroke("ESCAPE"), "close");
        dialog.getRootPane().getActionMap().put("close", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                dialog.dispose();
            }
        });
        Dimension screen = dialog.getToolkit().getScreenSize();
        dialog.setSize(Math.min(look.px(size.width), screen.width), Math.min(look.px(size.height), screen.height));
        dialog.setLocationRelativeTo(over);
        dialog.setVisible(true);
    }

    /** Closes the window of a name, if there is one. */
    private static void close(JFrame over, String name) {
        for (Window owned : over.getOwnedWindows()) {
            if (name.equals(owned.getName()) && owned.isDisplayable()) {
                owned.dispose();
            }
        }
    }
}
