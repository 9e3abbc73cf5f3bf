package troupe.app;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import troupe.app.look.Look;
import troupe.app.look.Scaling;
import troupe.app.start.NewScenePanel;
import troupe.paint.Tone;

/** Asks for the size of a new scene. */
final class NewSceneDialog {
    private NewSceneDialog() {}

    /** Shows the dialog until a size is chosen or Escape is pressed. */
    static void show(StudioWindow window, Pages pages) {
        Look look = window.look();
        JDialog dialog = new JDialog(window.frame(), look.text("start.new"), true);
        dialog.setName("new");
        JPanel all = new JPanel(new java.awt.BorderLayout());
        all.setBackground(look.color(Tone.PANEL));
        all.setBorder(BorderFactory.createCompoundBorder(
                look.line(1, 1, 1, 1), BorderFactory.createEmptyBorder(18, 20, 20, 20)));
        all.add(new NewScenePanel(look, scene -> {
            dialog.dispose();
            pages.create(scene);
        }));
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
        dialog.pack();
        dialog.setResizable(false);
        dialog.setLocationRelativeTo(window.frame());
        dialog.setVisible(true);
    }
}
