package troupe.app.recovery;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.app.Await;
import troupe.app.OnEventThread;
import troupe.app.Scenes;
import troupe.app.Studios;
import troupe.app.document.SceneDocument;
import troupe.app.plan.PlanningSteps;
import troupe.app.session.Session;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.run.RunComparison;
import troupe.run.Simulation;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;
import troupe.run.file.RunJournal;
import troupe.run.view.Overlay;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.work.KilledRuns;
import troupe.work.Tasks;

class RunKeepingTest {
    @TempDir
    Path folder;

    private static final PlanningSteps STEPS = new PlanningSteps() {
        @Override
        public List<Problem> check(Scene scene) {
            return List.of();
        }

        @Override
        public List<Problem> inspect(Scene scene) {
            return List.of();
        }

        @Override
        public Engine start(Scene scene, String task) {
            return Tasks.start(scene, task);
        }

        @Override
        public List<Overlay> overlays(
                Scene scene, String task, Engine engine, List<Integer> chosen, Predicate<String> wanted) {
            return List.of();
        }
    };

    private KeptFiles kept;
    private Session session;
    private RunKeeping keeping;

    private static Scene crowd() {
        return KilledRuns.scene(200, 7200);
    }

    @BeforeEach
    void begin() {
        kept = new KeptFiles(folder);
        OnEventThread.run(() -> {
            session = new Session(
                    new SceneDocument(crowd(), Optional.empty()), STEPS, Studios.NO_FILES, EventQueue::invokeLater);
            keeping = new RunKeeping(session, kept, EventQueue::invokeLater, RunKeepingTest::fail, 0);
        });
    }

    @AfterEach
    void end() {
        OnEventThread.run(() -> {
            keeping.close();
            session.close();
        });
    }

    private static void fail(IOException e) {
        throw new AssertionError(e);
    }

    private Path journal() {
        return RunJournal.file(kept.run(), 0);
    }

    private Run read() {
        try {
            return RunFile.read(journal());
        } catch (RunException | IOException e) {
            // not begun, or just being begun anew
            return null;
        }
    }

    private Run awaitKept(int frames, int inputs) {
        Run[] found = {null};
        Await.until(frames + " frames and " + inputs + " inputs are kept", () -> {
            found[0] = read();
            return found[0] != null
                    && found[0].frames().count() >= frames
                    && found[0].inputs().size() >= inputs;
        });
        return found[0];
    }

    private static void assertSimulated(Run run) {
        Simulation again = (Simulation) Tasks.start(crowd(), "go");
        run.inputs().forEach(again::give);
        again.step(60);
        assertEquals(Optional.empty(), RunComparison.firstDifference(again.run().frames(), run.frames(), 60));
    }

    @Test
    void whatIsSimulatedIsKeptAsItGrows() {
        OnEventThread.run(session::planNow);
        Run first = awaitKept(60, 0);
        assertTrue(RunJournal.recovered(first));
        assertSimulated(first);
        awaitKept(first.frames().count() + 60, 0);
    }

    @Test
    void whatIsSteeredTakesThePlaceOfWhatCameAfter() {
        OnEventThread.run(session::planNow);
        awaitKept(200, 0);
        OnEventThread.run(() -> {
            session.playback().seek(1);
            session.grab();
            session.steer("weight.path", 0);
            session.release();
        });
        Run steered = awaitKept(60, 1);
        assertEquals("weight.path", steered.inputs().get(0).key());
        assertTrue(
                steered.inputs().get(0).step() < 40,
                "given at " + steered.inputs().get(0));
        assertSimulated(steered);
    }

    @Test
    void whatIsGivenUpIsRemoved() {
        OnEventThread.run(session::planNow);
        awaitKept(1, 0);
        OnEventThread.run(() -> session.document().open(Scenes.room(), Optional.empty()));
        Await.until("gone with its document", () -> !Files.exists(journal()));
        OnEventThread.run(() -> session.document().open(crowd(), Optional.empty()));
        awaitKept(1, 0);
        OnEventThread.run(keeping::close);
        Await.until("gone with the studio", () -> !Files.exists(journal()));
    }

    @Test
    void onlyTheNewestThatWereLeftBehindStay() throws Exception {
        Simulation simulation = (Simulation) Tasks.start(crowd(), "go");
        simulation.step(30);
        for (int k = 0; k < 6; k++) {
            // no process has such a number
            Path run = folder.resolve("." + (Integer.MAX_VALUE - k) + ".run");
            try (RunJournal one = new RunJournal(run)) {
                one.keep(simulation.run());
            }
            Files.setLastModifiedTime(RunJournal.file(run, 0), java.nio.file.attribute.FileTime.fromMillis(1000L * k));
        }
        Files.writeString(folder.resolve(".2147480000.run.journal"), "troupe jour");
        Recovery.RunOffer offer = keeping.left().orElseThrow();
        assertEquals(30, offer.run().frames().count());
        assertEquals(
                ".2147483642.run.journal", offer.left().kept().getFileName().toString());
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(RunKeeping.MOST_LEFT, files.count());
        }
        OnEventThread.run(() -> keeping.bringBack(offer.left().kept(), () -> {}));
        Await.until("shown", () -> OnEventThread.get(() -> session.run())
                .filter(run -> run.frames().count() == 30)
                .isPresent());
        assertFalse(Files.exists(offer.left().kept()));
        assertTrue(Files.exists(RunJournal.file(kept.run(), RunJournal.MOST - 1)), "it is kept until the studio ends");
        OnEventThread.run(keeping::close);
        Await.until("gone", () -> !Files.exists(RunJournal.file(kept.run(), RunJournal.MOST - 1)));
    }
}
