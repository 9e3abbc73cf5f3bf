package troupe.run.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.run.Digest;
import troupe.run.Run;
import troupe.run.RunComparison;
import troupe.run.SampleRuns;
import troupe.run.Simulation;
import troupe.run.frame.Frames;
import troupe.run.view.Overlay;
import troupe.search.Outcome;

/** Keeps runs of four frames a second in journals and opens what is left of them. */
class RunJournalTest {
    private static final Run.Input LATE = new Run.Input(90, "other", 2.5);

    @TempDir
    Path folder;

    private Path target() {
        return folder.resolve("sample.run");
    }

    private Path journal() {
        return folder.resolve("sample.run.journal");
    }

    private static Run sofar(int count, Run.Input... inputs) {
        Run whole = SampleRuns.run(count);
        return new Run(
                whole.scene(),
                whole.task(),
                Outcome.RUNNING,
                whole.report(),
                whole.frames(),
                List.of(),
                List.of(inputs));
    }

    /** Keeps 23 frames in four goes, and returns how many frames each length of the file holds from there on. */
    private TreeMap<Long, Integer> keepInGoes() throws IOException {
        TreeMap<Long, Integer> lengths = new TreeMap<>();
        try (RunJournal journal = new RunJournal(target())) {
            for (int count : new int[] {3, 11, 12, 23}) {
                Run.Input first = new Run.Input(3, "k", -0.5);
                journal.keep(count < 12 ? sofar(count, first) : sofar(count, first, LATE));
                lengths.put(Files.size(journal()), count);
            }
        }
        return lengths;
    }

    @Test
    void whatWasKeptIsOpenedAsARun() throws Exception {
        keepInGoes();
        Run back = RunFile.read(journal());
        assertTrue(RunJournal.recovered(back));
        assertFalse(RunJournal.recovered(SampleRuns.run(3)));
        assertEquals(SampleRuns.scene(), back.scene());
        assertEquals("go", back.task());
        assertEquals(Outcome.CANCELLED, back.outcome());
        assertEquals(List.of(new Run.Input(3, "k", -0.5), LATE), back.inputs());
        assertEquals(Optional.empty(), RunComparison.firstDifference(SampleRuns.frames(23), back.frames()));
        assertEquals(0L, back.report().values().get("lost_bytes"));
        RunFile.write(back, target());
        Run saved = RunFile.read(target());
        assertEquals(Digest.of(SampleRuns.frames(23)), Digest.of(saved.frames()));
        assertTrue(RunJournal.recovered(saved));
    }

    @Test
    void cutAtAnyByteItGivesEveryFrameThatWasWhole() throws Exception {
        TreeMap<Long, Integer> lengths = keepInGoes();
        byte[] whole = Files.readAllBytes(journal());
        Frames expected = SampleRuns.frames(23);
        Path cut = folder.resolve("cut");
        int opened = 0;
        for (int length = 0; length < whole.length; length = next(length, lengths)) {
            Files.write(cut, Arrays.copyOf(whole, length));
            int least = lengths.floorEntry((long) length) == null
                    ? 0
                    : lengths.floorEntry((long) length).getValue();
            opened += checkPrefix(cut, expected, least) ? 1 : 0;
        }
        assertTrue(opened > 80, opened + " of " + whole.length + " opened");
    }

    /** Goes on by many bytes within scene and manifest, and by few among the frames. */
    private static int next(int place, TreeMap<Long, Integer> lengths) {
        return place + (place < lengths.firstKey() - 200 ? 97 : 7);
    }

    /** Opens a file and returns whether it could be; then it must hold a beginning of {@code expected}. */
    private static boolean checkPrefix(Path file, Frames expected, int least) throws IOException {
        try {
            Run run = RunFile.read(file);
            int count = run.frames().count();
            assertTrue(count >= least, count + " frames; " + least + " had been kept");
            assertEquals(Optional.empty(), RunComparison.firstDifference(expected, run.frames(), count));
            return true;
        } catch (RunException e) {
            assertEquals(0, least, e.getMessage());
            assertFalse(e.getMessage().contains("\n"), e.getMessage());
            return false;
        }
    }

    @Test
    void aFlippedByteNeverGivesAFrameThatWasNotMade() throws Exception {
        TreeMap<Long, Integer> lengths = keepInGoes();
        byte[] good = Files.readAllBytes(journal());
        Path bad = folder.resolve("bad");
        int opened = 0;
        for (int i = 0; i < good.length; i = next(i, lengths)) {
            byte[] bytes = good.clone();
            bytes[i] ^= (byte) (1 << i % 8);
            Files.write(bad, bytes);
            opened += checkPrefix(bad, SampleRuns.frames(23), 0) ? 1 : 0;
        }
        assertTrue(opened > 60 && opened < good.length, opened + " of " + good.length + " opened");
    }

    @Test
    void framesOfALargeJournalStayInIt() throws Exception {
        keepInGoes();
        Run run = JournalReader.read(journal(), 0);
        assertEquals(JournalFrames.class, run.frames().getClass(), "frames of a journal larger than what may be held");
        assertEquals(Optional.empty(), RunComparison.firstDifference(SampleRuns.frames(23), run.frames()));
        assertEquals(SampleRuns.frames(23).value(13, 1, 0), run.frames().value(13, 1, 0));
        Frames fresh = JournalReader.read(journal(), 0).frames();
        Files.write(journal(), new byte[10]);
        assertThrows(UncheckedIOException.class, () -> fresh.value(20, 0, 0));
    }

    @Test
    void recordsThatDoNotFollowEachOtherAreRefused() throws Exception {
        keepInGoes();
        byte[] whole = Files.readAllBytes(journal());
        JournalRecord again = new JournalRecord(JournalRecord.FRAMES, new byte[4 + 21]);
        JournalRecord unknown = new JournalRecord((byte) '?', new byte[4]);
        for (JournalRecord last : List.of(again, unknown)) {
            byte[] more = Arrays.copyOf(whole, whole.length + last.bytes().remaining());
            last.bytes().get(more, whole.length, last.bytes().remaining());
            Files.write(journal(), more);
            assertThrows(RunException.class, () -> RunFile.read(journal()));
        }
    }

    @Test
    void aJournalThatIsThereAlreadyIsLeftAlone() throws Exception {
        Files.writeString(journal(), "precious");
        try (RunJournal journal = new RunJournal(target())) {
            journal.keep(sofar(5));
            Path second = folder.resolve("sample.run.1.journal");
            assertEquals(List.of(journal(), second), RunJournal.beside(target()));
            assertEquals(5, RunFile.read(second).frames().count());
            journal.discard();
            assertFalse(Files.exists(second));
        }
        assertEquals("precious", Files.readString(journal()));
    }

    @Test
    void nothingIsWrittenBeforeThereAreFrames() throws Exception {
        try (RunJournal journal = new RunJournal(target())) {
            journal.keep(sofar(0));
            assertArrayEquals(new String[0], folder.toFile().list());
            journal.discard();
        }
    }

    @Test
    void aSimulationIsAskedForItsRunOnlyWhenASecondOfItIsNewOrASecondHasPassed() throws Exception {
        long[] nanos = {0};
        int[] asked = {0};
        int[] steps = {1};
        Simulation simulation = new CountedSimulation(steps, asked);
        try (RunJournal journal = new RunJournal(target(), () -> nanos[0])) {
            journal.keep(simulation);
            assertEquals(1, asked[0], "the first frame");
            for (steps[0] = 2; steps[0] < 5; steps[0]++) {
                journal.keep(simulation);
            }
            assertEquals(1, asked[0], "four frames make a second");
            steps[0] = 5;
            journal.keep(simulation);
            assertEquals(2, asked[0]);
            assertEquals(5, journal.frames());
            steps[0] = 6;
            nanos[0] = 1_000_000_000;
            journal.keep(simulation);
            assertEquals(6, RunFile.read(journal()).frames().count());
        }
    }

    /** Stands for a simulation that has done so many steps, and counts how often it is asked for its run. */
    private record CountedSimulation(int[] steps, int[] asked) implements Simulation {
        @Override
        public List<Control> controls() {
            return List.of();
        }

        @Override
        public void give(Run.Input input) {
            throw new IllegalArgumentException("no controls");
        }

        @Override
        public Outcome step(long budget) {
            return Outcome.RUNNING;
        }

        @Override
        public Outcome outcome() {
            return Outcome.RUNNING;
        }

        @Override
        public void cancel() {}

        @Override
        public Progress progress() {
            return new Progress(steps[0], Double.NaN);
        }

        @Override
        public List<Overlay> overlays() {
            return List.of();
        }

        @Override
        public Run run() {
            asked[0]++;
            return sofar(steps[0]);
        }
    }
}
