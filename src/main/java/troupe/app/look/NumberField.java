package troupe.app.look;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyEvent;
import java.util.function.DoubleConsumer;
import java.util.function.DoublePredicate;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import troupe.paint.Theme;
import troupe.paint.Tone;

/**
 * A field for a number, its unit dim and inside. What is typed is checked at once and shown as wrong
 * while it is; Enter, or leaving the field, takes a right number; Escape and a wrong one bring the old
 * one back.
 */
public final class NumberField extends JTextField {
    private final transient Look look;
    private final String unit;
    private final int decimals;
    private transient DoublePredicate allowed = Double::isFinite;
    private transient DoubleConsumer taker = value -> {};
    private double value = Double.NaN;
    private boolean wrong;

    /** Makes a field with a unit (may be empty) that shows this many decimals. */
    public NumberField(Look look, String unit, int decimals) {
        this.look = look;
        this.unit = unit;
        this.decimals = decimals;
        setFont(look.font());
        setForeground(look.color(Tone.TEXT));
        setCaretColor(look.color(Tone.TEXT));
        setOpaque(false);
        int right = 10 + getFontMetrics(getFont()).stringWidth(unit);
        setBorder(BorderFactory.createEmptyBorder(3, 8, 3, right));
        setPreferredSize(new Dimension(60, 24));
        getDocument().addDocumentListener(new Check());
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
                show(value);
            }
        });
    }

    /** Sets which numbers are right, and who takes a new one. */
    public void onNumber(DoublePredicate right, DoubleConsumer taken) {
        allowed = right;
        taker = taken;
    }

    /** Shows a number. */
    public void show(double shown) {
        value = shown;
        setText(Texts.number(shown, decimals));
        setCaretPosition(0);
    }

    private double typed() {
        try {
            return Double.parseDouble(getText().trim().replace('\u2212', '-').replace(',', '.'));
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }

    private void take() {
        double typed = typed();
        boolean same = getText().equals(Texts.number(value, decimals));
        if (same || !allowed.test(typed)) {
            show(value);
            return;
        }
        value = typed;
        taker.accept(typed);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        g.setColor(look.color(Tone.BACKGROUND));
        g.fillRoundRect(0, 0, getWidth() - 1, getHeight() - 1, 12, 12);
        Tone edge = wrong ? Tone.MOVE : isFocusOwner() ? Tone.ACCENT : Tone.LINE;
        g.setColor(look.color(edge));
        g.drawRoundRect(0, 0, getWidth() - 1, getHeight() - 1, 12, 12);
        g.setColor(look.color(Tone.DIM));
        g.setFont(Theme.font(Look.TEXT_SIZE));
        FontMetrics metrics = g.getFontMetrics();
        int base = (getHeight() - metrics.getHeight()) / 2 + metrics.getAscent();
        g.drawString(unit, getWidth() - 8 - metrics.stringWidth(unit), base);
        g.dispose();
        super.paintComponent(graphics);
    }

    /** Marks what is typed as right or wrong. */
    private final class Check implements DocumentListener {
        private void check() {
            boolean before = wrong;
            wrong = isEditable() && !getText().equals(Texts.number(value, decimals)) && !allowed.test(typed());
            if (before != wrong) {
                repaint();
            }
        }

        @Override
        public void insertUpdate(DocumentEvent event) {
            check();
        }

        @Override
        public void removeUpdate(DocumentEvent event) {
            check();
        }

        @Override
        public void changedUpdate(DocumentEvent event) {
            check();
        }
    }
}
