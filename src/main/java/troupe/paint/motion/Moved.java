package troupe.paint.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.geometry.Pose;
import troupe.paint.scene.ObstacleLook;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Ability;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Knows where the obstacles that a run moves stand in each of its frames: those whose ids own the channels
 * {@code x}, {@code y} and {@code heading}. Immutable; serves any thread.
 */
public final class Moved {
    private final Run run;
    private final List<One> all;

    /** One moved obstacle as the run's scene has it, its track, and the way of its centroid. */
    private record One(Obstacle obstacle, Track track, double[] way) {
        Pose pose(int frame) {
            return new Pose(track.x(frame), track.y(frame), track.headingRad(frame));
        }

        Obstacle at(Pose pose) {
            return obstacle.withOutline(obstacle.outline().at(pose));
        }
    }

    /** Looks for what a run moves. Cost O(channels · obstacles + frames in which something is moved). */
    public Moved(Run run) {
        this.run = run;
        List<One> found = new ArrayList<>();
        if (run.frames().count() > 0) {
            for (Track track : Track.of(run, id -> run.scene().obstacle(id).isPresent())) {
                Optional<Obstacle> obstacle = run.scene().obstacle(track.owner());
                obstacle.ifPresent(o -> found.add(new One(o, track, way(run, track))));
            }
        }
        this.all = List.copyOf(found);
    }

    /** Returns {@code x0, y0, x1, y1, …} in metres of the frames in which legs tell that it is moved. */
    private static double[] way(Run run, Track track) {
        Frames frames = run.frames();
        List<Double> way = new ArrayList<>();
        for (Run.Leg leg : run.legs()) {
            if (isMove(leg) && leg.what().equals(track.owner())) {
                int last = Math.min(frames.count() - 1, Track.frameAt(frames, leg.end()) + 1);
                for (int frame = Track.frameAt(frames, leg.begin()); frame <= last; frame++) {
                    int n = way.size();
                    double x = track.x(frame);
                    double y = track.y(frame);
                    if (n == 0 || way.get(n - 2) != x || way.get(n - 1) != y) {
                        way.add(x);
                        way.add(y);
                    }
                }
            }
        }
        return way.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** Tells whether a leg is one in which an obstacle is moved. */
    static boolean isMove(Run.Leg leg) {
        return leg.ability().equals(Ability.MOVE.key());
    }

    /** Tells whether a run moves an obstacle, at the cost of looking at its legs and channels only. */
    public static boolean any(Run run) {
        return run.legs().stream().anyMatch(leg -> isMove(leg) && run.frames().channel(leg.what(), "x") >= 0);
    }

    /** Returns the ways of the centroids, {@code x0, y0, x1, y1, …} in metres. */
    public List<double[]> ways() {
        return all.stream().map(One::way).toList();
    }

    /** Returns the poses in a frame, in the order of the channels. */
    List<Pose> poses(int frame) {
        return all.stream().map(one -> one.pose(frame)).toList();
    }

    /** Finds a moved obstacle as it stands in a frame. */
    Optional<Obstacle> obstacle(String id, int frame) {
        return all.stream()
                .filter(one -> one.obstacle().id().equals(id))
                .findFirst()
                .map(one -> one.at(one.pose(frame)));
    }

    /**
     * Returns a scene as it stands in a frame. An obstacle that differs in its outline from that of the run's
     * scene, since it has been edited meanwhile, stays where it is.
     */
    public Scene scene(Scene shown, int frame) {
        Scene now = shown;
        for (One one : all) {
            Pose pose = one.pose(frame);
            Obstacle here = here(shown, one);
            if (here != null && !pose.equals(one.pose(0))) {
                now = now.with(here.withOutline(here.outline().at(pose)));
            }
        }
        return now;
    }

    private static Obstacle here(Scene shown, One one) {
        return shown.obstacle(one.obstacle().id())
                .filter(o -> o.outline().equals(one.obstacle().outline()))
                .orElse(null);
    }

    /** Returns where the obstacles of a scene stood that have left by a frame, and where they are going to stand. */
    public List<ObstacleLook> traces(Scene shown, int frame) {
        List<ObstacleLook> traces = new ArrayList<>();
        for (One one : all) {
            Obstacle here = here(shown, one);
            Pose first = one.pose(0);
            Pose last = one.pose(run.frames().count() - 1);
            if (here != null && !first.equals(last)) {
                Pose pose = one.pose(frame);
                if (!pose.equals(last)) {
                    Obstacle there = here.withOutline(here.outline().at(last));
                    traces.add(new ObstacleLook(there, false, false, ObstacleLook.Trace.AHEAD));
                }
                if (!pose.equals(first)) {
                    traces.add(new ObstacleLook(here, false, false, ObstacleLook.Trace.LEFT));
                }
            }
        }
        return traces;
    }
}
