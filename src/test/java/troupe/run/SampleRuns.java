package troupe.run;

import java.util.List;
import troupe.run.frame.Channel;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.search.Outcome;

/** Makes small runs for tests, without a planner. */
public final class SampleRuns {
    static final List<Channel> CHANNELS = List.of(
            new Channel("x", "m", Channel.Type.F64, "anna", 1),
            new Channel("y", "m", Channel.Type.F64, "anna", 1),
            new Channel("ability", "walk,sidestep,stride,vault,move", Channel.Type.U8, "anna", 1),
            new Channel("phase", "", Channel.Type.F32, "anna", 1));

    private SampleRuns() {}

    public static Scene scene() {
        return new Scene(
                "Yard & <garden> 庭",
                World.of(10, 10),
                List.of(),
                List.of(),
                List.of(Actor.standard("anna")),
                List.of(Journey.of("go", "anna", Place.of(1, 1), Place.of(2, 2))));
    }

    /** Makes a run of {@code count} frames at 4 frames a second. */
    public static Run run(int count) {
        return new Run(
                scene(), "go", Outcome.FOUND, report(), frames(count), legs(), List.of(new Run.Input(3, "k", -0.5)));
    }

    public static Frames frames(int count) {
        FrameRecorder recorder = new FrameRecorder(4, CHANNELS);
        for (int k = 0; k < count; k++) {
            recorder.append(1 + 0.1 * k, 1 / 3.0 * k, k % 5, k / 7f);
        }
        return recorder.frames();
    }

    static Report report() {
        return Report.builder()
                .put("solved", true)
                .put("energy", 12.25e-7)
                .put("expanded", Long.MAX_VALUE)
                .put("title", "a \"b\" <c> & d\n\te é 庭 😀")
                .put("abilities", List.of("walk", "vault", "walk"))
                .put("empty", List.of())
                .put(
                        "nested",
                        List.of(
                                List.of(1L, 2.5),
                                Report.builder().put("k", false).build()))
                .put("times_ms", Report.builder().put("search", 1.5).build())
                .build();
    }

    private static List<Run.Leg> legs() {
        return List.of(
                new Run.Leg("anna", "walk", "", 0, 1.25, 1, List.of(new double[] {1, 1, 0}, new double[] {2, 1.1, 0})),
                new Run.Leg("anna", "vault", "wall", 1.25, 2, 7.5, List.of()));
    }
}
