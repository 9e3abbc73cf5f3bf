package troupe.app.look.widget;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.plaf.basic.BasicScrollBarUI;
import troupe.app.look.Look;
import troupe.paint.Tone;

/** Draws a scroll bar as a thin rounded stroke without arrows. */
public final class ThinScrollBarUI extends BasicScrollBarUI {
    private final Look look;

    private ThinScrollBarUI(Look look) {
        this.look = look;
    }

    /** Makes a pane that scrolls a component up and down, on the colour of panels. */
    public static JScrollPane scroll(JComponent content, Look look) {
        JScrollPane pane = new JScrollPane(
                content, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        pane.getViewport().setBackground(look.color(Tone.PANEL));
        pane.setBackground(look.color(Tone.PANEL));
        pane.getVerticalScrollBar().setUI(new ThinScrollBarUI(look));
        pane.getVerticalScrollBar().setPreferredSize(new Dimension(9, 9));
        pane.getVerticalScrollBar().setUnitIncrement(20);
        return pane;
    }

    @Override
    protected JButton createDecreaseButton(int orientation) {
        return none();
    }

    @Override
    protected JButton createIncreaseButton(int orientation) {
        return none();
    }

    private static JButton none() {
        return Look.sized(new JButton(), 0, 0);
    }

    @Override
    protected void paintTrack(Graphics graphics, JComponent bar, Rectangle bounds) {
        graphics.setColor(look.color(Tone.PANEL));
        graphics.fillRect(bounds.x, bounds.y, bounds.width, bounds.height);
    }

    @Override
    protected void paintThumb(Graphics graphics, JComponent bar, Rectangle bounds) {
        Graphics2D g = Look.smooth(graphics);
        g.setColor(look.mix(Tone.DIM, Tone.PANEL, isDragging ? 0.8 : 0.4));
        g.fillRoundRect(bounds.x + 2, bounds.y + 1, bounds.width - 4, bounds.height - 2, 5, 5);
        g.dispose();
    }
}
