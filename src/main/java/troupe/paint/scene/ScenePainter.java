package troupe.paint.scene;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import troupe.geometry.Polygon;
import troupe.paint.Clipping;
import troupe.paint.Labels;
import troupe.paint.ScaleBar;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Paints the world, its ditches and its obstacles as seen from above: what is higher covers what is
 * lower, heights are told by shade and, on low things, by a number; what hangs is see-through with a
 * dashed outline; movable obstacles are of hatched wood. Immutable; serves any thread.
 */
public final class ScenePainter {
    private static final double GRID_PIXELS = 20;
    private static final int MAX_LINES = 5_000;
    private static final double HANGING_OPACITY = 0.5;
    private static final double ABOVE_OPACITY = 0.12;
    private static final double GRAIN_SPACING = 8;

    private final Scene scene;
    private final Theme theme;
    private final List<ObstacleLook> looks;
    private final List<Ditch> ditches;
    private final double elevation;
    private final Set<String> numbered;

    /** Makes a painter that shows everything. Cost O(n log n) in the number of obstacles. */
    public ScenePainter(Scene scene, Theme theme) {
        this(
                scene,
                theme,
                ObstacleLook.of(scene.obstacles()),
                scene.ditches().stream()
                        .sorted(Comparator.comparingDouble(Ditch::depth))
                        .toList(),
                Double.POSITIVE_INFINITY,
                Set.of());
    }

    private ScenePainter(
            Scene scene,
            Theme theme,
            List<ObstacleLook> looks,
            List<Ditch> ditches,
            double elevation,
            Set<String> numbered) {
        this.scene = scene;
        this.theme = theme;
        this.looks = looks;
        this.ditches = ditches;
        this.elevation = elevation;
        this.numbered = numbered;
    }

    /** Returns a painter that leaves only a trace of what begins above {@code metres} over the ground. */
    public ScenePainter upTo(double metres) {
        return new ScenePainter(scene, theme, looks, ditches, metres, numbered);
    }

    /** Returns a painter that writes the heights of these elements too, whatever they are. */
    public ScenePainter numbering(Set<String> ids) {
        return new ScenePainter(scene, theme, looks, ditches, elevation, Set.copyOf(ids));
    }

    /** Returns a painter that shows these traces of moved obstacles too, each under what has a top as high. */
    public ScenePainter tracing(List<ObstacleLook> traces) {
        List<ObstacleLook> more = new ArrayList<>(traces);
        more.addAll(looks);
        more.sort(Comparator.comparingDouble(l -> l.obstacle().top()));
        return new ScenePainter(scene, theme, more, ditches, elevation, numbered);
    }

    /** Paints everything, text included. */
    public void paint(Graphics2D g, Viewport view) {
        paintGround(g, view);
        paintObstacles(g, view);
        paintLabels(g, view, new Labels());
    }

    /** Paints the floor, its faint grid and the ditches. */
    public void paintGround(Graphics2D graphics, Viewport view) {
        Graphics2D g = Shapes.smooth(graphics);
        World world = scene.world();
        Clipping clipping = new Clipping(g, view);
        Polygon ground = Polygon.rectangle(0, 0, side(world.width()), side(world.depth()));
        Rectangle2D floor = clipping.polygon(ground).getBounds2D();
        g.setColor(theme.color(Tone.FLOOR));
        g.fill(floor);
        paintGrid(g, view, floor);
        for (Ditch ditch : ditches) {
            Shape shape = clipping.polygon(ditch.outline());
            g.setColor(theme.color(Tone.DITCH, 0.8));
            g.fill(shape);
            g.setColor(theme.color(Tone.DITCH_EDGE));
            g.setStroke(Theme.line(1));
            g.draw(shape);
        }
        g.setColor(theme.color(Tone.LINE));
        g.setStroke(Theme.line(1));
        g.draw(floor);
        g.dispose();
    }

    private static double side(double metres) {
        return metres > 0 ? metres : 0;
    }

    private void paintGrid(Graphics2D g, Viewport view, Rectangle2D floor) {
        double step = ScaleBar.nice(GRID_PIXELS / view.scale());
        Rectangle clip = g.getClipBounds();
        Rectangle2D seen = clip == null ? floor : floor.createIntersection(clip);
        if (seen.isEmpty() || !(seen.getWidth() + seen.getHeight() < MAX_LINES * GRID_PIXELS)) {
            return;
        }
        Path2D lines = new Path2D.Double();
        double from = Math.ceil(view.x(seen.getMinX()) / step) * step;
        for (double x = from; view.px(x) <= seen.getMaxX(); x += step) {
            lines.moveTo(view.px(x), seen.getMinY());
            lines.lineTo(view.px(x), seen.getMaxY());
        }
        from = Math.ceil(view.y(seen.getMaxY()) / step) * step;
        for (double y = from; view.py(y) >= seen.getMinY(); y += step) {
            lines.moveTo(seen.getMinX(), view.py(y));
            lines.lineTo(seen.getMaxX(), view.py(y));
        }
        g.setColor(theme.color(Tone.GRID));
        g.setStroke(Theme.line(1));
        g.draw(lines);
    }

    /** Paints the obstacles, lowest top first. */
    public void paintObstacles(Graphics2D graphics, Viewport view) {
        Graphics2D g = Shapes.smooth(graphics);
        Clipping clipping = new Clipping(g, view);
        Rectangle clip = g.getClipBounds();
        for (ObstacleLook look : looks) {
            Shape shape = clipping.polygon(look.obstacle().outline());
            if (clip == null || shape.getBounds2D().intersects(grown(clip))) {
                if (look.solid()) {
                    paintObstacle(g, look, shape);
                } else {
                    double grain = Shapes.grain(look.obstacle().outline());
                    paintTrace(g, theme, look.trace(), shape, look.fill(theme), grain);
                }
            }
        }
        g.dispose();
    }

    private static Rectangle2D grown(Rectangle r) {
        return new Rectangle2D.Double(r.x - 2, r.y - 2, r.width + 4.0, r.height + 4.0);
    }

    private void paintObstacle(Graphics2D g, ObstacleLook look, Shape shape) {
        Color fill = look.fill(theme);
        boolean above = above(look);
        double opacity = above ? ABOVE_OPACITY : look.hanging() ? HANGING_OPACITY : 1;
        g.setColor(new Color(fill.getRed(), fill.getGreen(), fill.getBlue(), (int) Math.round(255 * opacity)));
        g.fill(shape);
        if (look.obstacle().movable()) {
            g.setColor(above ? theme.color(Tone.GRAIN, opacity) : edge(look.obstacle(), fill));
            g.setStroke(Theme.line(1.2f));
            g.draw(Shapes.hatch(
                    shape, GRAIN_SPACING, Shapes.grain(look.obstacle().outline())));
        }
        paintOutline(g, look, shape);
    }

    /** Paints where a moved obstacle stood, pale with a dashed outline, or the outline alone of where it is going to. */
    public static void paintTrace(
            Graphics2D g, Theme theme, ObstacleLook.Trace trace, Shape shape, Color fill, double grain) {
        if (trace == ObstacleLook.Trace.LEFT) {
            g.setColor(new Color(fill.getRed(), fill.getGreen(), fill.getBlue(), 56));
            g.fill(shape);
            g.setColor(theme.color(Tone.GRAIN, 0.3));
            g.setStroke(Theme.line(1.2f));
            g.draw(Shapes.hatch(shape, GRAIN_SPACING, grain));
        }
        paintTraceOutline(g, theme, trace, shape);
    }

    private static void paintTraceOutline(Graphics2D g, Theme theme, ObstacleLook.Trace trace, Shape shape) {
        g.setColor(trace == ObstacleLook.Trace.LEFT ? theme.color(Tone.GHOST) : theme.color(Tone.MOVE, 0.6));
        g.setStroke(trace == ObstacleLook.Trace.LEFT ? Theme.line(1.2f, 4, 4) : Theme.line(1.2f, 1, 4));
        g.draw(shape);
    }

    private boolean above(ObstacleLook look) {
        return look.obstacle().offset() > elevation + 1e-9;
    }

    private void paintOutline(Graphics2D g, ObstacleLook look, Shape shape) {
        Color fill = look.fill(theme);
        boolean movable = look.obstacle().movable();
        boolean dashed = look.hanging() || above(look);
        boolean plain = !movable && !dashed && !look.low() && !look.stair();
        Color edge = look.hanging() && !movable ? theme.color(Tone.DECK_EDGE) : edge(look.obstacle(), fill);
        g.setColor(plain ? fill : edge);
        g.setStroke(dashed ? Theme.line(1, 5, 3) : Theme.line(movable ? 1.2f : 0.8f));
        g.draw(shape);
    }

    /** Paints the outlines of ditches and obstacles alone, to show them through a field. */
    public void paintOutlines(Graphics2D graphics, Viewport view) {
        Graphics2D g = Shapes.smooth(graphics);
        Clipping clipping = new Clipping(g, view);
        g.setColor(theme.color(Tone.DITCH_EDGE));
        g.setStroke(Theme.line(1));
        for (Ditch ditch : ditches) {
            g.draw(clipping.polygon(ditch.outline()));
        }
        for (ObstacleLook look : looks) {
            if (!look.solid()) {
                Shape shape = clipping.polygon(look.obstacle().outline());
                paintTraceOutline(g, theme, look.trace(), shape);
            } else if (!above(look)) {
                paintOutline(g, look, clipping.polygon(look.obstacle().outline()));
            }
        }
        g.dispose();
    }

    private Color edge(Obstacle obstacle, Color fill) {
        return obstacle.movable() && obstacle.colour().isEmpty()
                ? theme.color(Tone.GRAIN)
                : Shapes.blend(fill, Color.BLACK, 0.22);
    }

    /** Paints heights and names where they fit; {@code labels} keeps texts apart. */
    public void paintLabels(Graphics2D graphics, Viewport view, Labels labels) {
        Graphics2D g = Shapes.smooth(graphics);
        ElevationLabels writer = new ElevationLabels(g, theme, view, labels);
        writer.keepOff(looks.stream().filter(l -> l.solid() && !above(l)).toList());
        for (Ditch ditch : ditches) {
            writer.write(ditch);
        }
        for (int i = looks.size() - 1; i >= 0; i--) {
            ObstacleLook look = looks.get(i);
            boolean asked = look.solid() && numbered.contains(look.obstacle().id());
            if (asked || look.low() && !look.obstacle().movable() && !above(look)) {
                writer.write(look, asked);
            }
        }
        g.dispose();
    }
}
