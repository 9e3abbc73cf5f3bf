package troupe.app.start;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.nio.file.Path;
import javax.swing.JButton;
import troupe.app.look.Look;
import troupe.paint.Tone;

/** A button with the name of a file and, dim, the folder it lies in. */
final class RecentRow extends JButton {
    private static final int HEIGHT = 40;
    private final transient Look look;
    private final String name;
    private final String folder;

    RecentRow(Look look, Path file) {
        this.look = look;
        this.name = file.getFileName().toString();
        this.folder = file.getParent() == null ? "" : file.getParent().toString();
        setName("recent." + name);
        setFont(look.font());
        setContentAreaFilled(false);
        setBorderPainted(false);
        setFocusPainted(false);
        setOpaque(false);
        setRolloverEnabled(true);
        setToolTipText(file.toString());
        setPreferredSize(new Dimension(100, HEIGHT));
        setMaximumSize(new Dimension(Short.MAX_VALUE, HEIGHT));
        setAlignmentX(LEFT_ALIGNMENT);
        getAccessibleContext().setAccessibleName(name);
        getAccessibleContext().setAccessibleDescription(file.toString());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        if (getModel().isRollover() || isFocusOwner()) {
            g.setColor(isFocusOwner() ? look.selected() : look.hovered());
            g.fillRoundRect(0, 0, getWidth(), getHeight(), look.px(10), look.px(10));
        }
        if (isFocusOwner()) {
            g.setColor(look.color(Tone.ACCENT));
            g.drawRoundRect(0, 0, getWidth() - 1, getHeight() - 1, look.px(10), look.px(10));
        }
        g.setFont(getFont());
        FontMetrics metrics = g.getFontMetrics();
        int line = metrics.getHeight();
        int base = (getHeight() - 2 * line) / 2 + metrics.getAscent();
        g.setColor(look.color(Tone.TEXT));
        g.drawString(shortened(name, metrics), look.px(8), base);
        g.setColor(look.color(Tone.DIM));
        g.drawString(shortened(folder, metrics), look.px(8), base + line);
        g.dispose();
    }

    /** Returns the text, without its beginning where it is too long: the end of a path tells more. */
    private String shortened(String text, FontMetrics metrics) {
        String rest = text;
        while (rest.length() > 1 && metrics.stringWidth("\u2026" + rest) > getWidth() - look.px(16)) {
            rest = rest.substring(1);
        }
        return rest.length() == text.length() ? text : "\u2026" + rest;
    }
}
