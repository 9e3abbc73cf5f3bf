package troupe.app.solid;

import troupe.paint.solid.Camera;
import troupe.paint.solid.SolidPainter;
import troupe.scene.Scene;

/**
 * Says from where a scene is looked at: an angle, how much larger than fitted, and how far the middle has been moved,
 * in shares of the width. Immutable.
 */
public record Eye(Camera.Angle angle, double zoom, double right, double down) {
    /** The whole scene from the usual side. */
    public static final Eye DEFAULT = new Eye(Camera.Angle.DEFAULT, 1, 0, 0);

    private static final double MOST = 40;
    private static final double LEAST = 0.4;

    /** Returns the eye after a turn, in radians. */
    Eye turned(double azimuth, double elevation) {
        return new Eye(angle.turned(azimuth, elevation), zoom, right, down);
    }

    /** Returns the eye nearer by a factor; what is at a place, in shares of the width from the middle, stays there. */
    Eye zoomed(double factor, double x, double y) {
        double to = Math.max(LEAST, Math.min(MOST, zoom * factor));
        double by = to / zoom;
        return new Eye(angle, to, x + (right - x) * by, y + (down - y) * by);
    }

    /** Returns the eye with the scene moved, in shares of the width. */
    Eye moved(double dx, double dy) {
        return new Eye(angle, zoom, right + dx, down + dy);
    }

    /** Returns the camera for a picture of {@code width x height} pixels with a margin. */
    Camera camera(Scene scene, int width, int height, int margin) {
        return SolidPainter.around(scene, angle, width - 2.0 * margin, height - 2.0 * margin)
                .panned(margin, margin)
                .zoomed(zoom, width / 2.0, height / 2.0)
                .panned(right * width, down * width);
    }
}
