package troupe.exchange.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.Places;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.paint.motion.Track;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Crowd;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.Task;

/**
 * Tells where the people of a run can walk while nothing is moved. What is higher than a step and leaves no room to
 * pass under blocks, and so do ditches deeper than a step, unless somebody of this run walks on it. Used once: show
 * it everybody, then ask.
 */
final class PedestrianGround {
    private static final double TOUCH = 0.05;
    /** Where things stand still for less than so many seconds is no phase. */
    private static final double LEAST_SECONDS = 0.25;

    private final Run run;
    private final double step;
    private final double height;
    private final List<Obstacle> blocks = new ArrayList<>();
    private final List<Ditch> ditches = new ArrayList<>();
    private final List<Track> moved;

    /**
     * A stretch of time in which nothing is moved.
     *
     * @param first the first frame
     * @param last the last frame
     */
    record Phase(int first, int last) {}

    PedestrianGround(Run run) {
        this.run = run;
        Scene scene = run.scene();
        Task task = scene.task(run.task()).orElseThrow();
        if (task instanceof Crowd crowd) {
            step = crowd.manner().stepHeight();
            height = crowd.manner().bodyHeight();
        } else {
            List<Actor> acting = scene.actors().stream()
                    .filter(a -> run.frames().channel(a.id(), "x") >= 0)
                    .toList();
            step = acting.stream().mapToDouble(Actor::stepHeight).min().orElse(0);
            height = acting.stream().mapToDouble(Actor::bodyHeight).max().orElse(0);
        }
        scene.obstacles().stream()
                .filter(o -> o.top() > step && o.offset() < height)
                .forEach(blocks::add);
        scene.ditches().stream().filter(d -> d.depth() > step).forEach(ditches::add);
        moved = run.frames().count() == 0
                ? List.of()
                : Track.of(run).stream()
                        .filter(t -> scene.obstacle(t.owner()).isPresent())
                        .toList();
    }

    /** Lets go of what this one walks on. Cost O(frames · what blocks). */
    void show(Places places) {
        for (int frame = 0; frame < places.x().length; frame++) {
            String word = places.words()[frame];
            boolean inTheAir = word.equals(Ability.VAULT.key()) || word.equals(Ability.STRIDE.key());
            if (places.isThere(frame) && !inTheAir && places.z()[frame] != 0) {
                double x = places.x()[frame];
                double y = places.y()[frame];
                double z = places.z()[frame];
                blocks.removeIf(o -> Math.abs(o.top() - z) < TOUCH
                        && isStill(o)
                        && o.outline().contains(x, y));
                ditches.removeIf(
                        d -> Math.abs(d.depth() + z) < TOUCH && d.outline().contains(x, y));
            }
        }
    }

    private boolean isStill(Obstacle obstacle) {
        return moved.stream().noneMatch(t -> t.owner().equals(obstacle.id()));
    }

    /** Returns the phases in order: one, of all frames, if nothing is moved. */
    List<Phase> phases() {
        int count = run.frames().count();
        if (moved.isEmpty()) {
            return List.of(new Phase(0, Math.max(0, count - 1)));
        }
        List<Phase> phases = new ArrayList<>();
        int first = 0;
        for (int frame = 1; frame <= count; frame++) {
            if (frame == count || !isSame(frame)) {
                if (phases.isEmpty() || (frame - first) / run.frames().rate() >= LEAST_SECONDS) {
                    phases.add(new Phase(first, frame - 1));
                }
                first = frame;
            }
        }
        return phases;
    }

    private boolean isSame(int frame) {
        return moved.stream()
                .allMatch(t -> t.x(frame) == t.x(frame - 1)
                        && t.y(frame) == t.y(frame - 1)
                        && t.headingRad(frame) == t.headingRad(frame - 1));
    }

    /**
     * Returns the ground in a phase.
     *
     * @throws ExchangeException if nothing is left to walk on
     */
    WalkableArea in(Phase phase) throws ExchangeException {
        Map<String, Pose> poses = new TreeMap<>();
        for (Track t : moved) {
            poses.put(t.owner(), new Pose(t.x(phase.first()), t.y(phase.first()), t.headingRad(phase.first())));
        }
        Stream<Polygon> standing =
                blocks.stream().map(o -> poses.containsKey(o.id()) ? o.outline().at(poses.get(o.id())) : o.outline());
        List<Polygon> all =
                Stream.concat(standing, ditches.stream().map(Ditch::outline)).toList();
        try {
            return WalkableArea.of(run.scene().world(), all, people(phase.first()));
        } catch (IllegalArgumentException e) {
            throw new ExchangeException("frame " + phase.first(), 0, 0, e.getMessage(), "choose another format");
        }
    }

    /** Returns where everybody is who is there in a frame. */
    private List<double[]> people(int frame) {
        Frames frames = run.frames();
        return frames.count() == 0
                ? List.of()
                : Places.acting(run).stream()
                        .filter(t -> t.isThere(frame))
                        .map(t -> new double[] {t.x(frame), t.y(frame)})
                        .toList();
    }
}
