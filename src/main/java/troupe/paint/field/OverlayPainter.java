package troupe.paint.field;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import troupe.paint.Clipping;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.run.view.Overlay;

/**
 * Paints one overlay: fields of numbers by a colour map and contour lines, fields of categories by colour
 * and pattern, points as discs (smaller where they are dense), polylines as thin lines. Immutable; serves any thread. The contours are
 * traced once, in the constructor.
 */
public final class OverlayPainter {
    private static final double POINT_RADIUS = 3.2;
    private static final double LEAST_POINT_RADIUS = 1.4;
    private static final double POINT_SHARE = 0.62;
    private static final String EXPECTED = "expected-path";

    private final Overlay overlay;
    private final Theme theme;
    private final boolean filled;
    private final FieldRaster raster;
    private final Path2D contours;

    /** Makes a painter that fills fields. */
    public OverlayPainter(Overlay overlay, Theme theme) {
        this(overlay, theme, true);
    }

    /**
     * Makes a painter. Cost O(cells) for each contour line of a field.
     *
     * @param filled false to leave a field of numbers to its contour lines alone, if it has any
     */
    public OverlayPainter(Overlay overlay, Theme theme, boolean filled) {
        this.overlay = overlay;
        this.theme = theme;
        boolean lined =
                overlay instanceof Overlay.Field f && f.scale() instanceof Overlay.Continuous c && c.contour() > 0;
        this.filled = filled || !lined;
        this.raster = overlay instanceof Overlay.Field field ? new FieldRaster(field, theme) : null;
        this.contours = lined ? contours((Overlay.Field) overlay) : null;
    }

    private static Path2D contours(Overlay.Field field) {
        Overlay.Continuous scale = (Overlay.Continuous) field.scale();
        return new Contours(field).lines(scale.min(), scale.max(), scale.contour());
    }

    /** Paints the part of the overlay that lies in the clip. */
    public void paint(Graphics2D graphics, Viewport view) {
        Graphics2D g = Shapes.smooth(graphics);
        if (overlay instanceof Overlay.Field field) {
            if (filled) {
                raster.paint(g, view);
            }
            if (contours != null) {
                g.setColor(filled ? theme.color(Tone.TEXT, 0.35) : theme.color(Tone.CONTOUR));
                g.setStroke(Theme.line(filled ? 0.8f : 1.1f));
                g.draw(view.transform().createTransformedShape(contours));
            }
        } else if (overlay instanceof Overlay.Lines lines) {
            Clipping clipping = new Clipping(g, view);
            for (double[] line : lines.lines()) {
                Path2D path = clipping.line(line, 2);
                if (overlay.key().equals(EXPECTED)) {
                    // it leads over what bars it
                    g.setColor(theme.color(Tone.FLOOR, 0.7));
                    g.setStroke(Theme.line(5));
                    g.draw(path);
                }
                g.setColor(theme.color(lineTone(overlay.key())));
                g.setStroke(lineStroke(overlay.key()));
                g.draw(path);
            }
        } else if (overlay instanceof Overlay.Points points) {
            double[] at = points.coordinates();
            double radius = radius(spacing(at) * view.scale());
            for (int k = 0; k + 1 < at.length; k += 2) {
                paintPoint(g, theme, view.px(at[k]), view.py(at[k + 1]), radius);
            }
        }
        g.dispose();
    }

    /** Returns the least distance in metres of a point from the one before it, infinite if there is none. */
    private static double spacing(double[] at) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 2; k + 1 < at.length; k += 2) {
            double apart = Math.hypot(at[k] - at[k - 2], at[k + 1] - at[k - 1]);
            least = apart > 0 ? Math.min(least, apart) : least;
        }
        return least;
    }

    /** Returns the radius in pixels of points that lie {@code spacing} pixels apart: where they are dense, smaller. */
    public static double radius(double spacing) {
        return Math.max(LEAST_POINT_RADIUS, Math.min(POINT_RADIUS, spacing * POINT_SHARE));
    }

    /** Paints a sample of a point. */
    public static void paintPoint(Graphics2D g, Theme theme, double x, double y) {
        paintPoint(g, theme, x, y, POINT_RADIUS);
    }

    private static void paintPoint(Graphics2D g, Theme theme, double x, double y, double radius) {
        Ellipse2D disc = new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
        g.setColor(theme.color(Tone.MOVE));
        g.fill(disc);
        if (radius == POINT_RADIUS) {
            g.setColor(theme.color(Tone.PANEL));
            g.setStroke(Theme.line(1.2f));
            g.draw(disc);
        }
    }

    /** Returns the colour of polylines of a kind: the skeleton and expected paths their own, others the accent. */
    public static Tone lineTone(String key) {
        return switch (key) {
            case "skeleton" -> Tone.SKELETON;
            case EXPECTED -> Tone.MOVE;
            case "plan-before" -> Tone.DIM;
            default -> Tone.ACCENT;
        };
    }

    /** Returns the stroke of polylines of a kind: dots for what is expected, a thin line for others. */
    public static BasicStroke lineStroke(String key) {
        return key.equals(EXPECTED) ? Theme.line(2.6f, 0.1f, 5) : Theme.line(1.6f);
    }
}
