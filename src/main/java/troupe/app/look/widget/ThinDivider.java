package troupe.app.look.widget;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import javax.swing.plaf.basic.BasicSplitPaneDivider;
import javax.swing.plaf.basic.BasicSplitPaneUI;
import troupe.app.look.Look;
import troupe.paint.Tone;

/** Divides two panels by a thin strip that can be dragged. The function keys stay with the commands. */
public final class ThinDivider extends BasicSplitPaneUI {
    private static final int SIZE = 4;
    /** Under this a part keeps the size that it liked to have before it was hidden first. */
    private static final String LIKED = "troupe.liked";

    private final Look look;
    private final Tone tone;

    private ThinDivider(Look look, Tone tone) {
        this.look = look;
        this.tone = tone;
    }

    /** Makes a split of two panels; {@code weight} is the share of the first in what the window gains. */
    public static JSplitPane split(int orientation, Component first, Component second, double weight, Look look) {
        JSplitPane split = new JSplitPane(orientation, true, first, second);
        boolean columns = orientation == JSplitPane.HORIZONTAL_SPLIT;
        split.setUI(new ThinDivider(look, columns ? Tone.CANVAS : Tone.PANEL));
        split.setDividerSize(SIZE);
        split.setResizeWeight(weight);
        SwingUtilities.replaceUIInputMap(split, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, null);
        split.setBorder(BorderFactory.createEmptyBorder());
        split.setBackground(look.color(Tone.PANEL));
        return split;
    }

    /**
     * Shows or hides a part of a split. What is shown again is as large as it was, but no smaller than it likes to be: the
     * window may have squeezed it before it was hidden.
     */
    public static void show(JSplitPane split, JComponent part, boolean on) {
        boolean columns = split.getOrientation() == JSplitPane.HORIZONTAL_SPLIT;
        if (!on) {
            if (part.getClientProperty(LIKED) == null) {
                part.putClientProperty(LIKED, part.getPreferredSize());
            }
            Dimension liked = (Dimension) part.getClientProperty(LIKED);
            part.setPreferredSize(
                    new Dimension(Math.max(liked.width, part.getWidth()), Math.max(liked.height, part.getHeight())));
            part.setVisible(false);
            return;
        }
        Dimension wanted = part.getPreferredSize();
        part.setVisible(true);
        int size = columns ? wanted.width : wanted.height;
        int whole = columns ? split.getWidth() : split.getHeight();
        split.validate();
        split.setDividerLocation(part == split.getLeftComponent() ? size : whole - split.getDividerSize() - size);
    }

    @Override
    public BasicSplitPaneDivider createDefaultDivider() {
        BasicSplitPaneDivider strip = new BasicSplitPaneDivider(this) {
            @Override
            public void paint(Graphics g) {
                g.setColor(look.color(tone));
                g.fillRect(0, 0, getWidth(), getHeight());
            }
        };
        strip.setBorder(BorderFactory.createEmptyBorder());
        return strip;
    }
}
