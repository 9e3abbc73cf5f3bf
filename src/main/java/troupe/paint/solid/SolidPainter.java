package troupe.paint.solid;

import java.awt.Color;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.scene.ObstacleLook;
import troupe.run.Run;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Paints a scene and a run at a time in three dimensions, seen from a side by parallel projection: obstacles as
 * prisms, ditches dug out of the ground, the path where it lies, and whoever moves. The path and the movers show
 * faintly through what hides them, and tall walls that would hide the ground behind them are of glass. Whatever lies over, under or within each other is drawn right, because each
 * sample of the picture keeps its own depth. Holds the memory of a picture; serves one thread.
 */
public final class SolidPainter {
    private static final double GRAIN_METRES = 0.16;
    private static final double LEAST_HIGH = 1;
    /** What is as tall in metres may be of glass. */
    private static final double TALL = 1.3;

    private static final double GLASS = 0.34;
    /** So many metres from the border of the world the ground may be hidden. */
    private static final double INSIDE = 0.3;

    private final Scene scene;
    private final Theme theme;
    private final SolidGround ground;
    private final Optional<SolidRun> run;
    private final Stage stage;
    private final Way way;

    /** How it is painted: up to an elevation, with these elements outlined, and whether in a hurry. */
    private record Way(double elevation, Set<String> marked, boolean draft) {}

    /** Makes a painter of a scene as it stands, or as a run of it or of an earlier state of it changes it. */
    public SolidPainter(Scene scene, Optional<Run> run, Theme theme) {
        this.scene = scene;
        this.theme = theme;
        this.ground = new SolidGround(scene, theme);
        this.run = run.map(r -> new SolidRun(r, theme));
        this.stage = new Stage();
        this.way = new Way(Double.POSITIVE_INFINITY, Set.of(), false);
    }

    private SolidPainter(SolidPainter other, Way way) {
        this.scene = other.scene;
        this.theme = other.theme;
        this.ground = other.ground;
        this.run = other.run;
        this.stage = other.stage;
        this.way = way;
    }

    /** Returns a painter that leaves out what begins higher than {@code metres} over the ground; it shares the memory. */
    public SolidPainter upTo(double metres) {
        return new SolidPainter(this, new Way(metres, way.marked(), way.draft()));
    }

    /** Returns a painter that outlines these elements in the accent; it shares the memory. */
    public SolidPainter marking(Set<String> ids) {
        return new SolidPainter(this, new Way(way.elevation(), Set.copyOf(ids), way.draft()));
    }

    /** Returns a painter for pictures that are shown for a moment, a quarter of the work; it shares the memory. */
    public SolidPainter drafting(boolean draft) {
        return new SolidPainter(this, new Way(way.elevation(), way.marked(), draft));
    }

    /** Returns the largest view of a scene in {@code width x height} pixels, at the given pixels from the left and the top. */
    public static Camera fit(Scene scene, Camera.Angle angle, double x, double y, double width, double height) {
        return Camera.fit(angle, box(scene), -SolidGround.THICK, high(scene), width, height)
                .panned(x, y);
    }

    /** Returns the largest view of a scene that turning keeps within {@code width x height} pixels. */
    public static Camera around(Scene scene, Camera.Angle angle, double width, double height) {
        return Camera.around(angle, box(scene), -SolidGround.THICK, high(scene), width, height);
    }

    /** Returns how high a picture of a scene is for each pixel of its width, at most 2. */
    public static double aspect(Scene scene, Camera.Angle angle) {
        Camera camera = Camera.fit(angle, box(scene), -SolidGround.THICK, high(scene), 1000, 1e6);
        Camera flat = Camera.fit(angle, box(scene), -SolidGround.THICK, high(scene), 1e6, 1000);
        return Math.max(0.1, Math.min(2, 1000 / flat.scale() / (1000 / camera.scale())));
    }

    private static Box box(Scene scene) {
        return new Box(
                0, 0, drawable(scene.world().width()), drawable(scene.world().depth()));
    }

    private static double drawable(double side) {
        return side > 1e-6 && side < 1e9 ? side : 1;
    }

    private static double high(Scene scene) {
        double high = scene.obstacles().stream()
                .mapToDouble(Obstacle::top)
                .filter(top -> top < 1e6)
                .max()
                .orElse(0);
        return Math.max(LEAST_HIGH, high);
    }

    /**
     * Returns an opaque image of {@code width x height} pixels, drawn {@code density} times as large.
     *
     * @param time seconds into the run
     * @param background the colour of what lies beyond the ground
     */
    public BufferedImage image(Camera camera, int width, int height, double density, double time, Color background) {
        stage.set(camera, width, height, density, way.draft(), background);
        ground.paint(stage);
        Scene now = run.map(r -> r.scene(scene, time)).orElse(scene);
        List<ObstacleLook> looks = ObstacleLook.of(now.obstacles()).stream()
                .filter(look -> look.obstacle().offset() <= way.elevation() + 1e-9)
                .toList();
        looks.stream().filter(look -> !isGlass(look)).forEach(this::paint);
        run.map(r -> r.traces(scene, time)).orElse(List.of()).forEach(this::paintTrace);
        run.ifPresent(r -> r.paint(stage, time));
        looks.stream().filter(this::isGlass).forEach(look -> {
            stage.glass(GLASS);
            paint(look);
        });
        return stage.image();
    }

    /** Tells whether a thing is so tall that it would hide the ground behind it, which then shows through it. */
    private boolean isGlass(ObstacleLook look) {
        Obstacle obstacle = look.obstacle();
        if (obstacle.movable() || look.hanging() || look.stair() || obstacle.height() < TALL) {
            return false;
        }
        Polygon outline = obstacle.outline();
        boolean left = outline.signedArea() >= 0;
        Camera camera = stage.camera();
        for (int i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
            double across = camera.px(outline.x(i), outline.y(i)) - camera.px(outline.x(j), outline.y(j));
            if (left ? across > 1e-9 : across < -1e-9) {
                double x = (outline.x(i) + outline.x(j)) / 2;
                double y = (outline.y(i) + outline.y(j)) / 2;
                Point hidden = camera.angle().behind(x, y, obstacle.top());
                if (hidden.x() > INSIDE
                        && hidden.y() > INSIDE
                        && hidden.x() < scene.world().width() - INSIDE
                        && hidden.y() < scene.world().depth() - INSIDE) {
                    return true;
                }
            }
        }
        return false;
    }

    private void paintTrace(ObstacleLook trace) {
        boolean left = trace.trace() == ObstacleLook.Trace.LEFT;
        Color colour = theme.color(left ? Tone.GHOST : Tone.MOVE);
        float[] dashes = left ? new float[] {4, 4} : new float[] {1, 4};
        Obstacle there = trace.obstacle();
        stage.outline(there.outline(), there.offset() + 0.01, 1.4, colour, dashes);
    }

    private void paint(ObstacleLook look) {
        Obstacle obstacle = look.obstacle();
        Color fill = look.fill(theme);
        double low = Math.min(obstacle.offset(), obstacle.top());
        double high = Math.max(obstacle.offset(), obstacle.top());
        stage.prism(obstacle.outline(), low, high, fill, fill);
        if (obstacle.movable()) {
            paintGrain(obstacle.outline(), high);
        }
        boolean chosen = way.marked().contains(obstacle.id());
        Color edge = chosen ? theme.color(Tone.ACCENT) : Shapes.blend(fill, Color.BLACK, 0.28);
        stage.figure(0);
        stage.outline(obstacle.outline(), high, chosen ? 2.4 : 1, edge);
        if (chosen) {
            stage.outline(obstacle.outline(), low + 0.01, 2.4, edge);
        }
    }

    /** Draws the grain of wood on the top of what can be moved. */
    private void paintGrain(Polygon outline, double z) {
        Path2D shape = new Path2D.Double();
        for (int i = 0; i < outline.size(); i++) {
            if (i == 0) {
                shape.moveTo(outline.x(i), outline.y(i));
            } else {
                shape.lineTo(outline.x(i), outline.y(i));
            }
        }
        shape.closePath();
        double[] point = new double[6];
        double[] line = new double[6];
        line[2] = z;
        line[5] = z;
        Path2D grain = Shapes.hatch(shape, GRAIN_METRES, -Shapes.grain(outline));
        for (PathIterator it = grain.getPathIterator(null); !it.isDone(); it.next()) {
            if (it.currentSegment(point) == PathIterator.SEG_MOVETO) {
                line[0] = point[0];
                line[1] = point[1];
            } else {
                line[3] = point[0];
                line[4] = point[1];
                stage.line(line, 1, theme.color(Tone.GRAIN));
            }
        }
    }
}
