package troupe.app.look.widget;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import troupe.app.look.Look;
import troupe.app.look.Typed;
import troupe.paint.Tone;

/**
 * A field for a text, its unit dim and inside. What is typed is checked at once and shown as wrong while it is,
 * with the reason as its tool tip; Enter, or leaving the field, takes a right text; Escape and a wrong one bring
 * the old one back.
 */
public class Entry extends JTextField {
    private final transient Look look;
    private final String unit;
    private transient Function<String, Optional<String>> check = text -> Optional.empty();
    private transient Consumer<String> taker = text -> {};
    private String shown = "";
    private String absent = "";
    private boolean wrong;

    /** Makes a field with a unit, which may be empty. */
    public Entry(Look look, String unit) {
        this.look = look;
        this.unit = unit;
        setFont(look.font());
        setForeground(look.color(Tone.TEXT));
        setCaretColor(look.color(Tone.TEXT));
        setOpaque(false);
        // in pixels at 100 %, as all borders are
        int right = (int) Math.ceil(10 + getFontMetrics(getFont()).stringWidth(unit) / look.scale());
        setBorder(BorderFactory.createEmptyBorder(3, 8, 3, right));
        setPreferredSize(new Dimension(60, 24));
        getDocument().addDocumentListener(new Typed(this::mark));
        addActionListener(e -> take());
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                take();
                repaint();
            }

            @Override
            public void focusGained(FocusEvent event) {
                repaint();
            }
        });
        getInputMap().put(KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0), "restore");
        getActionMap().put("restore", new AbstractAction() {
            @Override
            public void actionPerformed(java.awt.event.ActionEvent event) {
                showText(shown);
            }
        });
    }

    /** Sets what is wrong with a text, empty for nothing, and who takes a new one. */
    public final void onText(Function<String, Optional<String>> wrongWith, Consumer<String> taken) {
        check = wrongWith;
        taker = taken;
    }

    /** Sets the dim word that stands for the empty text. */
    public final void setAbsent(String word) {
        absent = word;
        repaint();
    }

    /** Shows a text. */
    public final void showText(String text) {
        shown = text;
        setText(text);
        setCaretPosition(0);
    }

    private void take() {
        String typed = getText();
        if (typed.equals(shown) || check.apply(typed).isPresent()) {
            showText(shown);
            return;
        }
        shown = typed;
        taker.accept(typed);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        int arc = look.px(12);
        g.setColor(look.color(Tone.BACKGROUND));
        g.fillRoundRect(0, 0, getWidth() - 1, getHeight() - 1, arc, arc);
        Tone edge = wrong ? Tone.MOVE : isFocusOwner() ? Tone.ACCENT : Tone.LINE;
        g.setColor(look.color(edge));
        g.drawRoundRect(0, 0, getWidth() - 1, getHeight() - 1, arc, arc);
        g.setColor(look.color(Tone.DIM));
        g.setFont(look.font());
        FontMetrics metrics = g.getFontMetrics();
        int base = (getHeight() - metrics.getHeight()) / 2 + metrics.getAscent();
        boolean stands = getText().isEmpty() && !isFocusOwner() && !absent.isEmpty();
        if (stands) {
            g.drawString(absent, look.px(8), base);
        } else {
            g.drawString(unit, getWidth() - look.px(8) - metrics.stringWidth(unit), base);
        }
        g.dispose();
        super.paintComponent(graphics);
    }

    /** Marks what is typed as right or wrong. */
    private void mark() {
        boolean before = wrong;
        Optional<String> found = getText().equals(shown) || !isEditable() ? Optional.empty() : check.apply(getText());
        wrong = found.isPresent();
        setToolTipText(found.orElse(null));
        if (before != wrong) {
            repaint();
        }
    }
}
