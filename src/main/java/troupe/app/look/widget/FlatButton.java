package troupe.app.look.widget;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import java.text.BreakIterator;
import java.util.ArrayList;
import java.util.List;
import javax.swing.Action;
import javax.swing.Icon;
import javax.swing.JToggleButton;
import troupe.app.look.Look;
import troupe.paint.Tone;

/** A button without bevels: an icon, a pill with a text, a chip, or the accented one; on or off where it is a choice. */
public final class FlatButton extends JToggleButton {

    /** How a button looks. */
    public enum Style {
        /** Nothing but its icon; tinted when on. */
        ICON(8, 0),
        /** A rounded frame with a text. */
        PILL(7, 10),
        /** A frame with round ends; accented when on. */
        CHIP(14, 11),
        /** Filled with the accent when on. */
        ACCENT(7, 12);

        private final int arc;
        private final int padding;

        Style(int arc, int padding) {
            this.arc = arc;
            this.padding = padding;
        }
    }

    private final transient Look look;
    private final Style style;
    private String hint = "";
    private int widest = Integer.MAX_VALUE;

    /** Makes a button without text. */
    public FlatButton(Look look, Style style) {
        this.look = look;
        this.style = style;
        setFont(style == Style.ACCENT ? look.bold() : look.font());
        setForeground(look.color(Tone.TEXT));
        setContentAreaFilled(false);
        setBorderPainted(false);
        setFocusPainted(false);
        setOpaque(false);
        setRolloverEnabled(true);
        setRequestFocusEnabled(false); // a click leaves the keys with what is worked on
        setMargin(new Insets(0, 0, 0, 0));
    }

    /** Makes a button for an action, with the action's text, icon and state. */
    public FlatButton(Look look, Style style, Action action) {
        this(look, style);
        setAction(action);
        if (style == Style.ICON) {
            setHideActionText(true);
            getAccessibleContext().setAccessibleName((String) action.getValue(Action.NAME));
        }
    }

    /** Shows a dim word after the text, such as a shortcut. */
    public void setHint(String word) {
        hint = word;
        revalidate();
        repaint();
    }

    /** Breaks the text into lines where it is wider than so many pixels at 100 %; a button with a hint has one line. */
    public void setWidest(int pixels) {
        widest = look.px(pixels);
        revalidate();
        repaint();
    }

    /** Breaks a text into lines of at most {@code room} pixels, after a space, or anywhere in scripts without them. */
    private static List<String> lines(String text, FontMetrics metrics, int room) {
        List<String> lines = new ArrayList<>();
        BreakIterator breaks = BreakIterator.getLineInstance();
        breaks.setText(text);
        int begin = 0;
        int last = 0;
        for (int end = breaks.next(); end != BreakIterator.DONE; end = breaks.next()) {
            if (last > begin && metrics.stringWidth(text.substring(begin, end).stripTrailing()) > room) {
                lines.add(text.substring(begin, last).stripTrailing());
                begin = last;
            }
            last = end;
        }
        lines.add(text.substring(begin));
        return lines;
    }

    @Override
    public Dimension getPreferredSize() {
        if (isPreferredSizeSet() || hint == null) {
            return super.getPreferredSize();
        }
        if (widest < Integer.MAX_VALUE) {
            FontMetrics metrics = getFontMetrics(getFont());
            List<String> lines = lines(shownText(), metrics, widest - 2 * look.px(style.padding));
            int wide = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
            return new Dimension(wide + 2 * look.px(style.padding), lines.size() * metrics.getHeight() + look.px(12));
        }
        FontMetrics metrics = getFontMetrics(getFont());
        int icon = getIcon() == null ? 0 : getIcon().getIconWidth();
        int text = shownText().isEmpty() ? 0 : metrics.stringWidth(shownText());
        int after = hint.isEmpty() ? 0 : metrics.stringWidth(hint) + look.px(8);
        int between = icon > 0 && text > 0 ? look.px(6) : 0;
        int height = look.px(style == Style.CHIP ? 24 : 28);
        return new Dimension(icon + between + text + after + 2 * look.px(style.padding), height);
    }

    /** {@inheritDoc} It is shown at the scale of the looks. */
    @Override
    public void setIcon(Icon icon) {
        super.setIcon(icon == null || look == null ? icon : look.enlarged(icon));
    }

    private String shownText() {
        return getHideActionText() || getText() == null ? "" : getText();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        paintGround(g);
        FontMetrics metrics = g.getFontMetrics(getFont());
        Icon icon = getIcon();
        String text = shownText();
        int width = (icon == null ? 0 : icon.getIconWidth()) + (text.isEmpty() ? 0 : metrics.stringWidth(text));
        int between = icon != null && !text.isEmpty() ? look.px(6) : 0;
        int x = style == Style.ICON || hint.isEmpty() ? (getWidth() - width - between) / 2 : look.px(style.padding);
        if (icon != null) {
            setForeground(ink());
            icon.paintIcon(this, g, x, (getHeight() - icon.getIconHeight()) / 2);
            x += icon.getIconWidth() + between;
        }
        g.setFont(getFont());
        g.setColor(ink());
        if (widest < Integer.MAX_VALUE) {
            paintLines(g, lines(text, metrics, getWidth() - 2 * look.px(style.padding)));
            g.dispose();
            return;
        }
        int base = (getHeight() - metrics.getHeight()) / 2 + metrics.getAscent();
        g.drawString(text, x, base);
        if (!hint.isEmpty() && getWidth() >= getPreferredSize().width) {
            g.setColor(look.color(Tone.DIM));
            g.drawString(hint, getWidth() - look.px(style.padding) - metrics.stringWidth(hint), base);
        }
        g.dispose();
    }

    private void paintLines(Graphics2D g, List<String> lines) {
        FontMetrics metrics = g.getFontMetrics();
        int base = (getHeight() - lines.size() * metrics.getHeight()) / 2 + metrics.getAscent();
        for (String line : lines) {
            g.drawString(line, (getWidth() - metrics.stringWidth(line)) / 2, base);
            base += metrics.getHeight();
        }
    }

    private void paintGround(Graphics2D g) {
        int arc = look.px(2 * style.arc);
        Color fill = fill();
        if (fill != null) {
            g.setColor(fill);
            g.fillRoundRect(0, 0, getWidth(), getHeight(), arc, arc);
        }
        boolean framed = style == Style.PILL || style == Style.CHIP || style == Style.ACCENT && !isSelected();
        if (framed || isFocusOwner()) {
            boolean accented = isFocusOwner() || style == Style.CHIP && isSelected();
            g.setColor(look.color(accented ? Tone.ACCENT : Tone.LINE));
            g.drawRoundRect(0, 0, getWidth() - 1, getHeight() - 1, arc, arc);
        }
    }

    private Color fill() {
        boolean over = getModel().isRollover() && isEnabled();
        if (style == Style.ACCENT && isSelected()) {
            return look.color(Tone.ACCENT);
        }
        if (style == Style.ICON) {
            return isSelected() ? look.selected() : over ? look.hovered() : null;
        }
        return over ? look.hovered() : look.color(Tone.PANEL);
    }

    private Color ink() {
        if (!isEnabled()) {
            return look.mix(Tone.DIM, Tone.PANEL, 0.5);
        }
        if (style == Style.ACCENT) {
            return look.color(isSelected() ? Tone.INK : Tone.TEXT);
        }
        boolean accented = isSelected() && style != Style.PILL;
        return look.color(accented ? Tone.ACCENT : Tone.TEXT);
    }
}
