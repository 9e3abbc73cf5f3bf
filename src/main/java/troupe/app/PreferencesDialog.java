package troupe.app;

import java.awt.BorderLayout;
import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import troupe.app.look.Look;
import troupe.app.look.Scaling;
import troupe.app.look.Texts;
import troupe.app.settings.PreferencesPanel;
import troupe.app.settings.StudioSettings;
import troupe.paint.Tone;

/** Shows the preferences; each choice holds at once, for the dialog too. */
final class PreferencesDialog {
    private final StudioWindow window;
    private final StudioSettings settings;
    private final JDialog dialog;

    PreferencesDialog(StudioWindow window, StudioSettings settings) {
        this.window = window;
        this.settings = settings;
        this.dialog = new JDialog(window.frame(), true);
        dialog.setName("preferences");
        dialog.getRootPane()
                .getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW)
                .put(KeyStroke.getKeyStroke("ESCAPE"), "close");
        dialog.getRootPane().getActionMap().put("close", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                dialog.dispose();
            }
        });
    }

    /** Shows the dialog until it is closed. */
    void show() {
        build();
        dialog.setLocationRelativeTo(window.frame());
        dialog.setVisible(true);
    }

    private void build() {
        Look look = window.look();
        dialog.setTitle(look.text("preferences.title"));
        JPanel all = new JPanel(new BorderLayout());
        all.setBackground(look.color(Tone.PANEL));
        all.setBorder(BorderFactory.createCompoundBorder(
                look.line(1, 1, 1, 1), BorderFactory.createEmptyBorder(14, 24, 16, 24)));
        all.add(new PreferencesPanel(look, settings, takers()));
        dialog.setContentPane(new Scaling(look::scale).apply(all));
        dialog.pack();
    }

    private PreferencesPanel.Takers takers() {
        return new PreferencesPanel.Takers(
                theme -> rebuilt(() -> window.show(theme)),
                language -> rebuilt(() -> window.show(new Texts(language))),
                scale -> rebuilt(() -> window.scale(scale)),
                live -> {
                    settings.setLive(live);
                    window.commands().get("live").setOn(live);
                    window.session().setLive(live);
                },
                snapping -> {
                    settings.setSnapping(snapping);
                    window.canvas().setSnapping(snapping);
                },
                settings::setOpening);
    }

    private void rebuilt(Runnable change) {
        change.run();
        build();
    }
}
