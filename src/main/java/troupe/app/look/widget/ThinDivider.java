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

    /** Shows or hides a part of a split; what is shown again is as large as it was. */
    public static void show(JSplitPane split, Component part, boolean on) {
        boolean columns = split.getOrientation() == JSplitPane.HORIZONTAL_SPLIT;
        if (!on) {
            part.setPreferredSize(part.getWidth() > 0 ? part.getSize() : part.getPreferredSize());
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
