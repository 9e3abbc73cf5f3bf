package troupe.exchange;

import java.util.List;
import java.util.OptionalDouble;
import troupe.geometry.Polygon;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.Channel.Type;
import troupe.run.frame.FrameRecorder;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Encounter;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.World;
import troupe.search.Outcome;

/** Makes runs of crowds and encounters by hand. */
public final class SmallRuns {
    private static final Obstacle WALL = new Obstacle("wall", "", Polygon.rectangle(4, 0, 5, 2), 0, 3, false, 20, "");

    private SmallRuns() {}

    /** Three members who walk along x for 60 frames at 25 frames a second, half a metre apart in y. */
    public static Run crowd() {
        return titled("Three");
    }

    public static Run titled(String title) {
        CrowdGroup.Members members =
                new CrowdGroup.Members(3, Polygon.rectangle(0, 0, 1, 3), OptionalDouble.empty(), 0.2, 1.3);
        Crowd crowd = Crowd.of("all-go", List.of(CrowdGroup.of("all", Place.of(9, 1), members)));
        FrameRecorder recorder = new FrameRecorder(
                25,
                List.of(
                        new Channel("x", "m", Type.F64, "all", 3),
                        new Channel("y", "m", Type.F64, "all", 3),
                        new Channel("heading", "rad", Type.F32, "all", 3)));
        for (int k = 0; k < 60; k++) {
            double x = 0.5 + 0.05 * k;
            recorder.append(x, x, x, 2.5, 3, 3.5, 0, 0, 0);
        }
        return run(title, crowd, recorder);
    }

    /** An actor who stands for eight frames, and an avatar who is there from frame 2 to frame 4 and turns. */
    public static Run visitor() {
        Avatar guest = Avatar.of("guest", new Avatar.Pointer(Place.of(1, 1)));
        Encounter encounter = Encounter.of("all", "ann", Place.of(7, 7), Place.of(8, 7), List.of(guest));
        FrameRecorder recorder = new FrameRecorder(
                12.5,
                List.of(
                        new Channel("x", "m", Type.F64, "ann", 1),
                        new Channel("y", "m", Type.F64, "ann", 1),
                        new Channel("action", "kept,replanned", Type.U8, "ann", 1),
                        new Channel("x", "m", Type.F64, "guest", 1),
                        new Channel("y", "m", Type.F64, "guest", 1),
                        new Channel("heading", "rad", Type.F64, "guest", 1)));
        for (int k = 0; k < 8; k++) {
            boolean there = k >= 2 && k < 5;
            double heading = Math.toRadians(150 + 10 * k);
            recorder.append(
                    7,
                    7,
                    k % 2,
                    there ? 1 + 0.1 * k : Double.NaN,
                    there ? 1 : Double.NaN,
                    there ? Math.IEEEremainder(heading, 2 * Math.PI) : Double.NaN);
        }
        return run("Visitor", encounter, recorder);
    }

    private static Run run(String title, Task task, FrameRecorder recorder) {
        Scene scene = new Scene(
                title,
                new World(10, 8, 0.1),
                List.of(WALL),
                List.of(),
                List.of(Actor.walker("ann", 0.25, 0.1)),
                List.of(task));
        return new Run(
                scene, task.id(), Outcome.FOUND, Report.builder().build(), recorder.frames(), List.of(), List.of());
    }
}
