package troupe.paint.solid;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.List;
import java.util.Optional;
import troupe.geometry.Polygon;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.motion.Moved;
import troupe.paint.motion.Track;
import troupe.paint.scene.ObstacleLook;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Scene;

/**
 * Draws what a run adds to a scene in three dimensions: the legs in the colour and line style of their abilities,
 * start and goal, and everybody who moves. Immutable; serves any thread.
 */
final class SolidRun {
    private static final double THROUGH = 0.3;
    private static final double PATH_LIFT = 0.02;
    /** Pixels per metre from which on lines are as wide as in the plan. */
    private static final double FULL_SIZE = 30;

    private static final int CORNERS = 14;
    /** So many movers are drawn with fewer corners. */
    private static final int CROWDED = 150;

    private final Run run;
    private final Theme theme;
    private final Moved moved;
    private final SolidBodies bodies;
    private final List<Track> tracks;

    /** Looks at a run. */
    SolidRun(Run run, Theme theme) {
        this.run = run;
        this.theme = theme;
        this.moved = new Moved(run);
        this.bodies = new SolidBodies(run, theme);
        this.tracks = Track.of(run).stream()
                .filter(track -> run.scene().obstacle(track.owner()).isEmpty())
                .toList();
    }

    private int frame(double time) {
        return Track.frameAt(run.frames(), time);
    }

    /** Returns a scene as it stands at a time. */
    Scene scene(Scene shown, double time) {
        return moved.scene(shown, frame(time));
    }

    /** Returns where obstacles stood and where they are going to stand. */
    List<ObstacleLook> traces(Scene shown, double time) {
        return moved.traces(shown, frame(time));
    }

    /** Draws everything at a time. */
    void paint(Stage stage, double time) {
        for (double[] way : moved.ways()) {
            stage.figure(THROUGH);
            stage.line(level(way), 1.6, theme.color(Tone.MOVE), 5, 4);
        }
        for (Run.Leg leg : run.legs()) {
            paint(stage, leg);
        }
        paintEnds(stage);
        if (run.frames().count() > 0) {
            int frame = frame(time);
            tracks.forEach(track -> paint(stage, track, frame));
        }
        stage.figure(0);
    }

    private static double[] level(double[] way) {
        double[] points = new double[way.length / 2 * 3];
        for (int i = 0; i < way.length / 2; i++) {
            points[3 * i] = way[2 * i];
            points[3 * i + 1] = way[2 * i + 1];
            points[3 * i + 2] = PATH_LIFT;
        }
        return points;
    }

    private void paint(Stage stage, Run.Leg leg) {
        Optional<Ability> ability = Track.ability(leg.ability());
        BasicStroke stroke = ability.map(a -> Theme.stroke(a, Theme.PATH_WIDTH)).orElse(Theme.line(Theme.PATH_WIDTH));
        float[] dashes = stroke.getDashArray() == null ? new float[0] : stroke.getDashArray();
        double[] points = new double[3 * leg.points().size()];
        for (int i = 0; i < leg.points().size(); i++) {
            System.arraycopy(leg.points().get(i), 0, points, 3 * i, 3);
            points[3 * i + 2] += PATH_LIFT;
        }
        double size = size(stage);
        for (int k = 0; k < dashes.length; k++) {
            dashes[k] = (float) (dashes[k] * size);
        }
        stage.figure(THROUGH);
        stage.line(
                points, size * stroke.getLineWidth(), ability.map(theme::color).orElse(theme.color(Tone.DIM)), dashes);
    }

    /** Draws a ring where the task starts and a flag at its goal. */
    private void paintEnds(Stage stage) {
        SolidBodies.Ends ends = bodies.ends().orElse(null);
        if (ends == null) {
            return;
        }
        double size = size(stage);
        double[] from = ends.start();
        double[] to = ends.goal();
        stage.figure(THROUGH);
        stage.outline(circle(from[0], from[1], ends.radius(), 24), from[2] + PATH_LIFT, 3 * size, ends.colour());
        stage.figure(THROUGH);
        stage.ball(to[0], to[1], to[2], 0.05, 3 * size, ends.colour());
        double[] flag = {-1, 0, 1, 0, 1, 16, 17, 22, 0, 28, -1, 28};
        for (int k = 0; k < flag.length; k++) {
            flag[k] *= size;
        }
        stage.flag(to[0], to[1], to[2], ends.colour(), flag);
    }

    /** Returns how large lines and signs are, 1 where a metre has at least as many pixels as {@link #FULL_SIZE}. */
    private static double size(Stage stage) {
        return Math.max(0.5, Math.min(1, stage.camera().scale() / FULL_SIZE));
    }

    private static Polygon circle(double x, double y, double radius, int corners) {
        double[] xs = new double[corners];
        double[] ys = new double[corners];
        for (int k = 0; k < corners; k++) {
            xs[k] = x + radius * Math.cos(2 * Math.PI * k / corners);
            ys[k] = y + radius * Math.sin(2 * Math.PI * k / corners);
        }
        return new Polygon(xs, ys);
    }

    /** Draws a mover: a body with a head, and on the floor its disc with an arrow where it heads. */
    private void paint(Stage stage, Track track, int frame) {
        double x = track.x(frame);
        double y = track.y(frame);
        double z = track.z(frame);
        if (!Double.isFinite(x) || !Double.isFinite(y) || !Double.isFinite(z)) {
            return;
        }
        SolidBodies.Body body = bodies.of(track.owner());
        Color colour = Track.ability(track.ability(frame)).map(theme::color).orElse(body.colour());
        int corners = tracks.size() > CROWDED ? CORNERS / 2 : CORNERS;
        double radius = body.radius();
        double shoulder = z + 0.76 * body.height();
        stage.figure(tracks.size() > CROWDED ? 0 : THROUGH);
        stage.prism(circle(x, y, 0.62 * radius, corners), z, shoulder, colour, colour);
        double head = Math.min(0.13 * body.height(), 0.8 * radius);
        Color face = Shapes.blend(colour, Color.WHITE, 0.25);
        stage.ball(x, y, shoulder + head, head, 2.5, face);
        stage.outline(circle(x, y, radius, 2 * corners), z + PATH_LIFT, 1.4, colour);
        double heading = track.headingRad(frame);
        double tipX = x + 1.7 * radius * Math.cos(heading);
        double tipY = y + 1.7 * radius * Math.sin(heading);
        double sideX = -0.55 * radius * Math.sin(heading);
        double sideY = 0.55 * radius * Math.cos(heading);
        double footX = x + radius * Math.cos(heading);
        double footY = y + radius * Math.sin(heading);
        Polygon arrow = Polygon.of(tipX, tipY, footX + sideX, footY + sideY, footX - sideX, footY - sideY);
        stage.floor(arrow, z + PATH_LIFT, colour, List.of());
    }
}
