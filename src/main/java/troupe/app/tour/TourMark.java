package troupe.app.tour;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.RoundRectangle2D;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.paint.Theme;
import troupe.paint.Tone;

/** Rings what a step of the tour speaks of; the pointer goes through it. */
final class TourMark extends Drawn {
    private static final int AROUND = 5;
    private final transient Look look;

    TourMark(Look look) {
        this.look = look;
        setName("tour.mark");
        setVisible(false);
        setFocusable(false);
        getAccessibleContext().setAccessibleName(look.text("tour.name"));
    }

    /** Rings a rectangle of the parent, or nothing where it is empty. */
    void ring(Rectangle around) {
        boolean shown = around.width > 0 && around.height > 0;
        if (shown) {
            Rectangle wide = new Rectangle(around);
            wide.grow(look.px(AROUND), look.px(AROUND));
            if (!wide.equals(getBounds())) {
                setBounds(wide);
            }
        }
        if (shown != isVisible()) {
            setVisible(shown);
        }
    }

    @Override
    public boolean contains(int x, int y) {
        return false;
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        double line = look.px(2.5);
        RoundRectangle2D ring = new RoundRectangle2D.Double(
                line, line, getWidth() - 2 * line, getHeight() - 2 * line, look.px(14), look.px(14));
        g.setColor(look.theme().color(Tone.ACCENT, 0.25));
        g.setStroke(Theme.line((float) (2 * line)));
        g.draw(ring);
        g.setColor(look.color(Tone.ACCENT));
        g.setStroke(Theme.line((float) line));
        g.draw(ring);
        g.dispose();
    }
}
