package troupe.work;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.search.Outcome;

/** Verifies the saved runs, and that a saved run which differs is found out. */
class GoldenRunsTest {
    private static final Path SAVED = Path.of("src/test/resources/runs");

    @TempDir
    Path folder;

    @TestFactory
    Stream<DynamicTest> everySavedRunComesOutTheSameBitByBit() throws IOException {
        List<Path> files = GoldenRuns.in(SAVED);
        assertFalse(files.isEmpty(), "no saved runs in " + SAVED);
        return files.stream()
                .map(file -> DynamicTest.dynamicTest(file.getFileName().toString(), () -> {
                    Run saved = RunFile.read(file);
                    assertEquals(Optional.empty(), GoldenRuns.difference(saved, GoldenRuns.again(saved)));
                }));
    }

    @Test
    void theFirstValueThatDiffersIsNamed() throws Exception {
        Run fresh = GoldenRuns.again(run(Outcome.RUNNING, new FrameRecorder(25, List.of()).frames(), 0));
        assertEquals(Optional.empty(), GoldenRuns.difference(fresh, GoldenRuns.again(fresh)));
        int channel = fresh.frames().channel("anna", "y");
        Run changed = run(fresh.outcome(), nudged(fresh.frames(), 7, channel), 0);
        double y = fresh.frames().value(7, channel, 0);
        assertEquals(
                Optional.of("frame 7, channel anna.y: expected " + Math.nextUp(y) + ", found " + y),
                GoldenRuns.difference(changed, fresh));
        Run stopped = run(new Outcome.Infeasible("shut"), fresh.frames(), 0);
        assertEquals(
                Optional.of("outcome: expected infeasible (shut), found found"), GoldenRuns.difference(stopped, fresh));
    }

    @Test
    void ofARunThatWasCutOffTheFramesThatAreThereAreCompared() throws Exception {
        Run fresh = GoldenRuns.again(run(Outcome.RUNNING, new FrameRecorder(25, List.of()).frames(), 0));
        Run cut = run(Outcome.CANCELLED, nudged(fresh.frames(), -1, -1, 5), 0);
        assertEquals(Optional.empty(), GoldenRuns.difference(cut, fresh));
        Run wrong = run(Outcome.CANCELLED, nudged(fresh.frames(), 3, 0, 5), 0);
        assertTrue(GoldenRuns.difference(wrong, fresh).orElse("").startsWith("frame 3, "));
        Run shorter = run(Outcome.FOUND, nudged(fresh.frames(), -1, -1, 2), 0);
        assertEquals(Optional.of("frames: expected at least 5, found 2"), GoldenRuns.difference(cut, shorter));
    }

    @Test
    void recordingAgainTellsWhatChangedAndLeavesEqualFilesAlone() throws Exception {
        Run fresh = GoldenRuns.again(run(Outcome.RUNNING, new FrameRecorder(25, List.of()).frames(), 0));
        Path equal = folder.resolve("a-equal.run");
        Path other = folder.resolve("b-other.run");
        RunFile.write(fresh, equal);
        RunFile.write(run(fresh.outcome(), nudged(fresh.frames(), 7, 0), 99), other);
        byte[] before = Files.readAllBytes(equal);
        List<String> lines = new ArrayList<>();
        assertEquals(1, GoldenRuns.record(folder, lines::add));
        assertEquals("a-equal.run: unchanged", lines.get(0));
        assertTrue(lines.get(1).startsWith("b-other.run: changed, frame 7, channel anna."), lines.get(1));
        assertTrue(
                lines.contains(
                        "  energy: was 99.0, is " + fresh.report().values().get("energy")),
                lines.toString());
        assertArrayEquals(before, Files.readAllBytes(equal));
        assertEquals(Optional.empty(), GoldenRuns.difference(RunFile.read(other), fresh));
    }

    @Test
    void inputsOfATaskThatTakesNoneAreRefused() {
        Run bare = run(Outcome.RUNNING, new FrameRecorder(25, List.of()).frames(), 0);
        Run steered = new Run(
                bare.scene(),
                bare.task(),
                bare.outcome(),
                bare.report(),
                bare.frames(),
                List.of(),
                List.of(new Run.Input(3, "avatar.bob.x", 1)));
        RunException refused = assertThrows(RunException.class, () -> GoldenRuns.again(steered));
        assertEquals("input 'avatar.bob.x' of step 3: the task takes no input", refused.getMessage());
    }

    private static Run run(Outcome outcome, Frames frames, double energy) {
        Scene scene = new Scene(
                "",
                new World(6, 4, 0.1),
                List.of(),
                List.of(),
                List.of(Actor.standard("anna")),
                List.of(Journey.of("go", "anna", Place.of(1, 1), Place.of(5, 2.5))));
        Report report = Report.builder().put("energy", energy).build();
        return new Run(scene, "go", outcome, report, frames, List.of(), List.of());
    }

    private static Frames nudged(Frames frames, int frame, int channel) {
        return nudged(frames, frame, channel, frames.count());
    }

    private static Frames nudged(Frames frames, int frame, int channel, int count) {
        FrameRecorder recorder = new FrameRecorder(frames.rate(), frames.channels());
        for (int f = 0; f < count; f++) {
            double[] values = new double[frames.channels().size()];
            for (int c = 0; c < values.length; c++) {
                double value = frames.value(f, c, 0);
                values[c] = f == frame && c == channel ? Math.nextUp(value) : value;
            }
            recorder.append(values);
        }
        return recorder.frames();
    }
}
