package troupe.paint.solid;

import troupe.geometry.Box;
import troupe.geometry.Point;

/**
 * Projects places in metres to pixels along parallel lines. The view plane has {@code u} to the right and
 * {@code w} up, in metres: {@code u = x cos a + y sin a}, {@code w = v sin e + z cos e} with
 * {@code v = y cos a - x sin a}; the depth {@code z sin e - v cos e} grows towards the eye. Immutable.
 *
 * @param left the u of the left edge of the picture, in metres
 * @param top the w of its upper edge, in metres
 * @param scale pixels per metre across the direction of view
 */
public record Camera(Angle angle, double left, double top, double scale) {

    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if the scale is not positive and finite or a place is not finite
     */
    public Camera {
        if (!(scale > 0) || Double.isInfinite(scale) || !Double.isFinite(left) || !Double.isFinite(top)) {
            throw new IllegalArgumentException(
                    "camera at " + left + ", " + top + " with " + scale + " px/m; needs a finite scale above 0");
        }
    }

    /**
     * Says from where a scene is seen.
     *
     * @param azimuthRad the turn of the eye round the scene, 0 from the south, growing as the scene turns clockwise
     *     seen from above
     * @param elevationRad the height of the eye over the horizon, {@link #MIN_ELEVATION} to {@link #MAX_ELEVATION}
     */
    public record Angle(double azimuthRad, double elevationRad) {
        /** The lowest eye, in radians: from there the sides of things cover the floor. */
        public static final double MIN_ELEVATION = Math.toRadians(10);

        /** The highest eye, in radians: from there heights just show. */
        public static final double MAX_ELEVATION = Math.toRadians(85);

        /** From the south-east, half-way up. */
        public static final Angle DEFAULT = new Angle(Math.toRadians(32), Math.toRadians(38));

        /**
         * Checks the numbers.
         *
         * @throws IllegalArgumentException if the azimuth is not finite or the elevation outside its range
         */
        public Angle {
            if (!Double.isFinite(azimuthRad)
                    || !(elevationRad >= MIN_ELEVATION - 1e-9 && elevationRad <= MAX_ELEVATION + 1e-9)) {
                throw new IllegalArgumentException("seen from azimuth " + Math.toDegrees(azimuthRad) + ", elevation "
                        + Math.toDegrees(elevationRad) + " degrees; needs an elevation of 10 to 85");
            }
        }

        /** Returns the angle after a turn, in radians; the elevation stays within its range. */
        public Angle turned(double azimuth, double elevation) {
            double to = Math.max(MIN_ELEVATION, Math.min(MAX_ELEVATION, elevationRad + elevation));
            return new Angle(Math.IEEEremainder(azimuthRad + azimuth, 2 * Math.PI), to);
        }

        /** Returns the place of the ground that is seen behind a place in metres, or in front of one below the ground. */
        public Point behind(double x, double y, double z) {
            double away = z / Math.tan(elevationRad);
            return new Point(x - away * Math.sin(azimuthRad), y + away * Math.cos(azimuthRad));
        }

        double u(double x, double y) {
            return x * Math.cos(azimuthRad) + y * Math.sin(azimuthRad);
        }

        double v(double x, double y) {
            return y * Math.cos(azimuthRad) - x * Math.sin(azimuthRad);
        }
    }

    /**
     * Makes the largest view of a block centred in {@code width x height} pixels.
     *
     * @param ground the block as seen from above
     * @param low the elevation in metres of its bottom, {@code high} that of its top
     */
    public static Camera fit(Angle angle, Box ground, double low, double high, double width, double height) {
        double[] u = {
            angle.u(ground.minX(), ground.minY()),
            angle.u(ground.maxX(), ground.minY()),
            angle.u(ground.minX(), ground.maxY()),
            angle.u(ground.maxX(), ground.maxY())
        };
        double[] v = {
            angle.v(ground.minX(), ground.minY()),
            angle.v(ground.maxX(), ground.minY()),
            angle.v(ground.minX(), ground.maxY()),
            angle.v(ground.maxX(), ground.maxY())
        };
        double wide = max(u) - min(u);
        double tall = (max(v) - min(v)) * Math.sin(angle.elevationRad) + (high - low) * Math.cos(angle.elevationRad);
        double scale = Math.min(Math.max(1, width) / Math.max(1e-9, wide), Math.max(1, height) / Math.max(1e-9, tall));
        return centred(angle, ground, low, high, width, height, scale);
    }

    /** Makes the largest view that shows a block from every azimuth, so that turning does not change its scale. */
    public static Camera around(Angle angle, Box ground, double low, double high, double width, double height) {
        double across = Math.hypot(ground.width(), ground.depth());
        double tall = across * Math.sin(angle.elevationRad) + (high - low) * Math.cos(angle.elevationRad);
        double scale =
                Math.min(Math.max(1, width) / Math.max(1e-9, across), Math.max(1, height) / Math.max(1e-9, tall));
        return centred(angle, ground, low, high, width, height, scale);
    }

    private static Camera centred(
            Angle angle, Box ground, double low, double high, double width, double height, double scale) {
        double x = (ground.minX() + ground.maxX()) / 2;
        double y = (ground.minY() + ground.maxY()) / 2;
        double w = angle.v(x, y) * Math.sin(angle.elevationRad) + (low + high) / 2 * Math.cos(angle.elevationRad);
        return new Camera(angle, angle.u(x, y) - width / 2 / scale, w + height / 2 / scale, scale);
    }

    private static double min(double[] values) {
        return Math.min(Math.min(values[0], values[1]), Math.min(values[2], values[3]));
    }

    private static double max(double[] values) {
        return Math.max(Math.max(values[0], values[1]), Math.max(values[2], values[3]));
    }

    /** Returns the pixel column of a place in metres. */
    public double px(double x, double y) {
        return (angle.u(x, y) - left) * scale;
    }

    /** Returns the pixel row of a place in metres. */
    public double py(double x, double y, double z) {
        double w = angle.v(x, y) * Math.sin(angle.elevationRad) + z * Math.cos(angle.elevationRad);
        return (top - w) * scale;
    }

    /** Returns how near a place is to the eye, in metres; only differences mean anything. */
    public double depth(double x, double y, double z) {
        return z * Math.sin(angle.elevationRad) - angle.v(x, y) * Math.cos(angle.elevationRad);
    }

    /** Returns this view with the scale multiplied by {@code factor}, above 0; what is at pixel {@code (px, py)} stays. */
    public Camera zoomed(double factor, double px, double py) {
        double to = scale * factor;
        return new Camera(angle, left + px / scale - px / to, top - py / scale + py / to, to);
    }

    /** Returns this view with its content moved by {@code (dx, dy)} pixels, right and down. */
    public Camera panned(double dx, double dy) {
        return new Camera(angle, left - dx / scale, top + dy / scale, scale);
    }

    /** Returns this view for a picture {@code factor} times as large. */
    public Camera magnified(double factor) {
        return new Camera(angle, left, top, scale * factor);
    }

    /** Returns the plane of the floor at an elevation in metres. */
    Plane floor(double z) {
        double sin = Math.sin(angle.elevationRad);
        double cot = Math.cos(angle.elevationRad) / sin;
        return new Plane(0, cot / scale, z / sin - top * cot);
    }

    /** Returns the upright plane through two places, which must not lie in one column of pixels. */
    Plane wall(double x0, double y0, double x1, double y1) {
        double u0 = angle.u(x0, y0);
        double v0 = angle.v(x0, y0);
        double slope = (angle.v(x1, y1) - v0) / (angle.u(x1, y1) - u0);
        double cos = Math.cos(angle.elevationRad);
        double tan = Math.sin(angle.elevationRad) / cos;
        return new Plane(-slope / scale / cos, -tan / scale, top * tan - (v0 + slope * (left - u0)) / cos);
    }

    /** The depth of a face as it is seen: {@code a px + b py + c} metres at pixel {@code (px, py)}. */
    record Plane(double a, double b, double c) {
        double at(double px, double py) {
            return a * px + b * py + c;
        }
    }
}
