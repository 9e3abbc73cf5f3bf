package troupe.app.look.widget;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.awt.Window;
import java.awt.event.ActionEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import troupe.app.look.Look;
import troupe.app.look.Scaling;
import troupe.paint.Tone;

/**
 * Asks a question that must be answered before anything else is done in the window. Escape, or closing the dialog,
 * is no answer. Belongs to the event thread.
 */
public final class Question {
    private final Look look;
    private final String key;
    private Optional<String> answer = Optional.empty();

    /** Makes a question; its title is the text of {@code key.title}, each answer's that of {@code key.answer}. */
    public Question(Look look, String key) {
        this.look = look;
        this.key = key;
    }

    /**
     * Asks, and returns when it is answered. The first answer is what Enter gives.
     *
     * @param content what is asked
     */
    public Optional<String> ask(Window over, JComponent content, List<String> answers) {
        JDialog dialog = new JDialog(over, look.text(key + ".title"), JDialog.ModalityType.DOCUMENT_MODAL);
        dialog.setName(key);
        JPanel all = new JPanel(new BorderLayout(0, 18));
        all.setBackground(look.color(Tone.PANEL));
        all.setBorder(BorderFactory.createCompoundBorder(
                look.line(1, 1, 1, 1), BorderFactory.createEmptyBorder(20, 22, 18, 22)));
        all.add(content, BorderLayout.CENTER);
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.RIGHT, 8, 0));
        buttons.setOpaque(false);
        for (int i = answers.size() - 1; i >= 0; i--) {
            FlatButton button = button(dialog, answers.get(i), i == 0);
            buttons.add(button);
            if (i == 0) {
                SwingUtilities.invokeLater(button::requestFocusInWindow);
                key(dialog, "ENTER", answers.get(i));
            }
        }
        all.add(buttons, BorderLayout.SOUTH);
        key(dialog, "ESCAPE", "");
        dialog.setContentPane(new Scaling(look::scale).apply(all));
        dialog.pack();
        dialog.setResizable(false);
        dialog.setLocationRelativeTo(over);
        dialog.setVisible(true);
        return answer;
    }

    /** Asks with a text alone. */
    public Optional<String> ask(Window over, String text, List<String> answers) {
        return ask(over, look.label(text, Tone.TEXT), answers);
    }

    private FlatButton button(JDialog dialog, String word, boolean first) {
        FlatButton button = new FlatButton(look, first ? FlatButton.Style.ACCENT : FlatButton.Style.PILL);
        button.setText(look.text(key + "." + word));
        button.setName(key + "." + word);
        button.setSelected(first);
        button.addActionListener(e -> {
            answer = Optional.of(word);
            dialog.dispose();
        });
        return button;
    }

    private void key(JDialog dialog, String stroke, String word) {
        dialog.getRootPane().getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke(stroke), stroke);
        dialog.getRootPane().getActionMap().put(stroke, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                JComponent focused = (JComponent) dialog.getMostRecentFocusOwner();
                if (!word.isEmpty() && focused instanceof FlatButton button) {
                    button.doClick(0);
                    return;
                }
                answer = Optional.of(word).filter(w -> !w.isEmpty());
                dialog.dispose();
            }
        });
    }
}
