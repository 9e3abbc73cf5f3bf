package troupe.app.canvas;

import java.awt.Dimension;
import troupe.geometry.Box;
import troupe.paint.Viewport;

/** Finds the largest view of a world that leaves a corner free. Pure. */
final class Fitting {
    private Fitting() {}

    /**
     * Returns the largest view of a world in a rectangle of pixels.
     *
     * @param corner the pixels of its upper right corner that stay free; nothing for none
     */
    static Viewport of(Box world, double left, double top, double wide, double tall, Dimension corner) {
        Viewport whole = Viewport.fit(world, left, top, wide, tall);
        double right = left + wide - corner.width;
        boolean free = whole.px(world.maxX()) <= right || whole.py(world.maxY()) >= top + corner.height;
        if (corner.width == 0 || free) {
            return whole;
        }
        Viewport beside = Viewport.fit(world, left, top, right - left, tall);
        Viewport below = Viewport.fit(world, left, top + corner.height, wide, tall - corner.height);
        return beside.scale() >= below.scale() ? beside : below;
    }
}
