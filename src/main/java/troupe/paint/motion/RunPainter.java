package troupe.paint.motion;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.paint.Clipping;
import troupe.paint.Disc;
import troupe.paint.Labels;
import troupe.paint.Pills;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.paint.scene.Cover;
import troupe.paint.scene.ScenePainter;
import troupe.paint.scene.TaskPainter;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Crowd;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Paints a run: its legs in the colour and line style of their abilities, a pill with the word where the
 * ability is not walking, the ends of the task, and the actors at a time, with arms to what they hold. What
 * passes below something that hangs is drawn faintly. Moved obstacles are painted with the scene, by the painter
 * that {@link #scene} gives; of them this one paints the ways of their centroids. Immutable; serves any thread.
 */
public final class RunPainter {
    private static final double COVERED_OPACITY = 0.4;
    private static final double LEAST_RADIUS = 8;
    /** Seconds: a frame may lie so far outside the leg that it shows. */
    private static final double SAME_TIME = 0.05;

    private final Run run;
    private final int level;
    private final Theme theme;
    private final Cover cover;
    private final Moved moved;
    private final List<Track> tracks;
    private final boolean gripping;
    private final List<Drawn> legs;
    private final Optional<CrowdPainter> crowd;
    private final Optional<EncounterPainter> encounter;

    private record Drawn(Optional<Ability> ability, List<Cover.Part> parts) {}

    /** Makes a painter of a run. Cost O(points of its legs + frames in which something is moved). */
    public RunPainter(Run run, Theme theme) {
        this(run, theme, CrowdPainter.DEEPEST, true);
    }

    /**
     * Makes a painter of a run that may be of a crowd.
     *
     * @param level the depth of the groups whose colours are shown, as in {@link CrowdPainter}
     * @param trails whether the last seconds of each agent's way are shown
     */
    public RunPainter(Run run, Theme theme, int level, boolean trails) {
        this.run = run;
        this.level = level;
        this.theme = theme;
        this.cover = new Cover(run.scene());
        this.moved = new Moved(run);
        Optional<Crowd> simulated =
                run.scene().task(run.task()).filter(Crowd.class::isInstance).map(Crowd.class::cast);
        this.crowd = simulated.map(c -> new CrowdPainter(c, run.frames(), theme, level, trails));
        this.encounter = EncounterPainter.of(run, theme);
        this.tracks = isSimulated()
                ? List.of()
                : Track.of(run).stream()
                        .filter(track -> run.scene().obstacle(track.owner()).isEmpty())
                        .toList();
        this.gripping = run.scene().task(run.task()).orElse(null) instanceof Journey journey
                && journey.manipulation() == Journey.Manipulation.GRIP;
        // the way of an encounter grows with time
        this.legs = (encounter.isPresent() ? List.<Run.Leg>of() : run.legs())
                .stream()
                        .map(leg -> new Drawn(Track.ability(leg.ability()), cover.parts(leg.points())))
                        .toList();
    }

    /**
     * Returns a painter of a scene as it stands at {@code time} seconds of the run: moved obstacles at their
     * poses, pale traces where they have left, outlines where they are going to stand. The scene is that of the
     * run or a later state of it; an obstacle whose outline has been edited is shown as it is now.
     */
    public ScenePainter scene(Scene shown, double time) {
        int frame = Track.frameAt(run.frames(), time);
        return new ScenePainter(moved.scene(shown, frame), theme).tracing(moved.traces(shown, frame));
    }

    /** Returns the poses of the moved obstacles at {@code time} seconds; while they are equal, so is what {@link #scene} shows. */
    public List<Pose> poses(double time) {
        return moved.poses(Track.frameAt(run.frames(), time));
    }

    /** Returns a stamp: painters with equal ones paint the same, but for the actors. A growing simulation keeps it. */
    public Object stamp() {
        return isSimulated() ? List.of(run.scene(), run.task(), level) : this;
    }

    private boolean isSimulated() {
        return crowd.isPresent() || encounter.isPresent();
    }

    /** Paints what the run adds to the scene as it stands at {@code time} seconds. */
    public void paint(Graphics2D g, Viewport view, double time) {
        paintLegs(g, view);
        paintEnds(g, view);
        Labels labels = new Labels();
        takeRoom(labels, view, time);
        paintPills(g, view, labels);
        paintActors(g, view, time);
    }

    /** Paints the legs, and the ways of what is moved. */
    public void paintLegs(Graphics2D graphics, Viewport view) {
        Graphics2D g = Shapes.smooth(graphics);
        Clipping clipping = new Clipping(g, view);
        for (double[] way : moved.ways()) {
            g.setColor(theme.color(Tone.FLOOR, 0.6));
            g.setStroke(Theme.line(4));
            g.draw(clipping.line(way, 2));
            g.setColor(theme.color(Tone.MOVE));
            g.setStroke(wayStroke());
            g.draw(clipping.line(way, 2));
        }
        g.setColor(theme.color(Tone.FLOOR, 0.9));
        g.setStroke(Theme.line(Theme.PATH_WIDTH + 2.6f));
        for (Drawn leg : legs) {
            for (Cover.Part part : leg.parts()) {
                if (!part.covered()) {
                    g.draw(clipping.line(part.coordinates(), 2));
                }
            }
        }
        for (Drawn leg : legs) {
            Color colour = leg.ability().map(theme::color).orElse(theme.color(Tone.DIM));
            BasicStroke stroke =
                    leg.ability().map(a -> Theme.stroke(a, Theme.PATH_WIDTH)).orElse(Theme.line(Theme.PATH_WIDTH));
            g.setStroke(stroke);
            for (Cover.Part part : leg.parts()) {
                double opacity = part.covered() ? COVERED_OPACITY : 1;
                g.setColor(new Color(
                        colour.getRed(), colour.getGreen(), colour.getBlue(), (int) Math.round(255 * opacity)));
                g.draw(clipping.line(part.coordinates(), 2));
            }
        }
        g.dispose();
    }

    /** Returns the stroke of the way of a moved obstacle's centroid. */
    public static BasicStroke wayStroke() {
        return Theme.line(1.4f, 5, 4);
    }

    /** Paints start and goal of the task, if it has them. */
    public void paintEnds(Graphics2D g, Viewport view) {
        if (run.scene().task(run.task()).orElse(null) instanceof Journey journey) {
            TaskPainter.paint(g, run.scene(), journey, view, theme);
        }
        crowd.ifPresent(c -> c.paintGoals(g, view));
        encounter.ifPresent(e -> e.paintEnds(g, view));
    }

    /**
     * Takes the room of the path, its ends and the actors at {@code time} seconds (NaN: at no time), so that
     * text keeps away from them.
     */
    public void takeRoom(Labels labels, Viewport view, double time) {
        if (run.scene().task(run.task()).orElse(null) instanceof Journey journey) {
            TaskPainter.take(labels, journey, view);
        }
        crowd.ifPresent(c -> c.takeRoom(labels, view, time));
        encounter.ifPresent(e -> e.takeRoom(labels, view, time));
        for (double[] p : pixels(legs, view)) {
            labels.take(new Rectangle2D.Double(p[0] - 1, p[1] - 1, 2, 2));
        }
        if (run.frames().count() > 0 && !Double.isNaN(time)) {
            int frame = Track.frameAt(run.frames(), time);
            for (Track track : tracks) {
                double r = radius(track, view);
                labels.take(
                        new Rectangle2D.Double(view.px(track.x(frame)) - r, view.py(track.y(frame)) - r, 2 * r, 2 * r));
            }
        }
    }

    private double radius(Track track, Viewport view) {
        double metres =
                run.scene().actor(track.owner()).map(a -> a.walk().radius()).orElse(0.0);
        return Math.max(LEAST_RADIUS, view.scale() * metres);
    }

    /** Paints a pill with the word of each stretch that is not walked, where there is room beside it. */
    public void paintPills(Graphics2D graphics, Viewport view, Labels labels) {
        paintPills(graphics, view, labels, Ability::key);
    }

    /** Paints the pills with {@code words} for the abilities, such as those of another language. */
    public void paintPills(Graphics2D graphics, Viewport view, Labels labels, Function<Ability, String> words) {
        Graphics2D g = Shapes.smooth(graphics);
        Pills pills = new Pills(g, theme, labels, pixels(legs, view), words);
        int i = 0;
        while (i < legs.size()) {
            int end = i + 1;
            while (end < legs.size()
                    && legs.get(end).ability().equals(legs.get(i).ability())) {
                end++;
            }
            Optional<Ability> ability = legs.get(i).ability();
            if (ability.isPresent() && ability.get() != Ability.WALK) {
                pills.paint(ability.get(), pixels(legs.subList(i, end), view));
            }
            i = end;
        }
        g.dispose();
    }

    /** Returns points along the legs, at most eight pixels apart. */
    private static List<double[]> pixels(List<Drawn> legs, Viewport view) {
        List<double[]> points = new ArrayList<>();
        for (Drawn leg : legs) {
            for (Cover.Part part : leg.parts()) {
                double[] at = part.coordinates();
                for (int k = 0; k + 1 < at.length; k += 2) {
                    double x = view.px(at[k]);
                    double y = view.py(at[k + 1]);
                    double[] from = k == 0 || points.isEmpty() ? new double[] {x, y} : points.get(points.size() - 1);
                    int pieces = (int) Math.max(1, Math.min(500, Math.hypot(x - from[0], y - from[1]) / 8));
                    for (int p = 1; p <= pieces; p++) {
                        double share = (double) p / pieces;
                        points.add(new double[] {from[0] + share * (x - from[0]), from[1] + share * (y - from[1])});
                    }
                }
            }
        }
        return points;
    }

    /** Paints every actor where it is at {@code time} seconds: a disc of its radius with its heading. */
    public void paintActors(Graphics2D graphics, Viewport view, double time) {
        crowd.ifPresent(c -> c.paintAgents(graphics, view, time));
        paintOthers(graphics, view, time);
    }

    /** Paints the same, the agents of a crowd pixel by pixel; see {@link CrowdPainter#paintAgents}. */
    public void paintActors(Graphics2D graphics, Viewport view, double time, AgentPixels pixels) {
        crowd.ifPresent(c -> c.paintAgents(graphics, view, time, pixels));
        paintOthers(graphics, view, time);
    }

    private void paintOthers(Graphics2D graphics, Viewport view, double time) {
        if (run.frames().count() == 0) {
            return;
        }
        encounter.ifPresent(e -> e.paint(graphics, view, time));
        int frame = Track.frameAt(run.frames(), time);
        Graphics2D g = Shapes.smooth(graphics);
        for (Track track : tracks) {
            Optional<Actor> actor = run.scene().actor(track.owner());
            double x = track.x(frame);
            double y = track.y(frame);
            Color colour = Track.ability(track.ability(frame))
                    .map(theme::color)
                    .orElse(actor.map(a -> Shapes.colour(a.colour(), theme.color(Tone.WALK)))
                            .orElse(theme.color(Tone.WALK)));
            if (cover.over(x, y, track.z(frame))) {
                g.setComposite(AlphaComposite.getInstance(AlphaComposite.SRC_OVER, 0.6f));
            }
            Optional<Polygon> held = held(track, frame, time);
            if (held.isPresent()) {
                Point hold = Hands.hold(held.get(), x, y);
                Hands.paint(g, view, new Point(x, y), radius(track, view), hold, colour, theme.color(Tone.PANEL));
            }
            new Disc(view.px(x), view.py(y), radius(track, view), track.headingRad(frame))
                    .paint(g, colour, theme.color(Tone.PANEL));
            g.setComposite(AlphaComposite.SrcOver);
        }
        g.dispose();
    }

    /** Finds what an actor holds. */
    private Optional<Polygon> held(Track track, int frame, double time) {
        if (!gripping || !track.ability(frame).equals(Ability.MOVE.key())) {
            return Optional.empty();
        }
        double at = Math.max(0, Math.min(run.frames().duration(), time));
        return run.legs().stream()
                .filter(leg -> Moved.isMove(leg) && leg.actor().equals(track.owner()))
                .filter(leg -> leg.begin() <= at + SAME_TIME && at <= leg.end() + SAME_TIME)
                .findFirst()
                .flatMap(leg -> moved.obstacle(leg.what(), frame))
                .map(Obstacle::outline);
    }
}
