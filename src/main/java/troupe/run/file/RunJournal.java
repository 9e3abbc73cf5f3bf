package troupe.run.file;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.LongSupplier;
import troupe.run.Digest;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.Simulation;
import troupe.run.frame.FrameLayout;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.run.frame.PartedFrames;
import troupe.scene.Task;
import troupe.scene.setting.Settings;
import troupe.scene.xml.SceneXml;
import troupe.search.Outcome;

/**
 * Keeps the frames of a long simulation on disk while it works, in a journal beside the file that is to hold the
 * run, so that after a crash at any moment everything up to the last second can be opened: {@link RunFile#read}
 * takes a journal as it takes a run file. What is kept is with the system at once, and so outlives the process; it
 * is forced to disk about once a second, and so outlives the machine. Used by one thread at a time.
 *
 * <p>The file is made with the first frames. Once the run is in its place, {@link #discard} removes it.
 */
public final class RunJournal implements Closeable {
    private static final long SECOND = 1_000_000_000;
    /** How many journals may lie beside one target. */
    public static final int MOST = 100;

    private static final String ENDING = ".journal";

    private final Path target;
    private final LongSupplier nanos;
    private Path file;
    private FileChannel channel;
    private FrameLayout layout;
    private int block = 1;
    private int frames;
    private int inputs;
    private long bytes;
    private long keptAt;
    private long forcedAt;

    /** Prepares a journal beside {@code target}; nothing is written yet. */
    public RunJournal(Path target) {
        this(target, System::nanoTime);
    }

    RunJournal(Path target, LongSupplier nanos) {
        this.target = target.toAbsolutePath();
        this.nanos = nanos;
        this.keptAt = nanos.getAsLong();
        this.forcedAt = keptAt;
    }

    /** Returns the journals beside {@code target} that are there already: of runs cut off, or still at work. */
    public static List<Path> beside(Path target) {
        List<Path> found = new ArrayList<>();
        for (int k = 0; k < MOST; k++) {
            Path file = file(target.toAbsolutePath(), k);
            if (Files.isRegularFile(file)) {
                found.add(file);
            }
        }
        return found;
    }

    /** Tells whether a run was read from a journal: it has frames, but neither the report nor the paths of its end. */
    public static boolean recovered(Run run) {
        return Boolean.TRUE.equals(run.report().values().get(JournalReader.RECOVERED));
    }

    /** Returns the journal of a target with a number from 0 to {@link #MOST} - 1; of several the first free is taken. */
    public static Path file(Path target, int number) {
        return target.resolveSibling(target.getFileName() + (number == 0 ? "" : "." + number) + ENDING);
    }

    /** Returns how large the journal is, in bytes. */
    public long bytes() {
        return bytes;
    }

    /** Returns the number of frames kept so far. */
    public int frames() {
        return frames;
    }

    /**
     * Keeps the new frames of a simulation if there is a second of them, or if a second has passed since the last;
     * to be called after every slice of work. Cost O(1) if nothing is due.
     *
     * @throws IOException if the journal cannot be written; what was kept before can still be read
     */
    public void keep(Simulation simulation) throws IOException {
        if (simulation.progress().work() - frames >= block || nanos.getAsLong() - keptAt >= SECOND) {
            keep(simulation.run());
        }
    }

    /**
     * Keeps all frames and inputs of a run that are not yet kept. Cost O(values of the new frames).
     *
     * @param run the same run each time, as far as it has come
     * @throws IOException if the journal cannot be written
     */
    public void keep(Run run) throws IOException {
        keptAt = nanos.getAsLong();
        int count = run.frames().count();
        if (count > frames || run.inputs().size() > inputs) {
            if (channel == null) {
                begin(run);
            }
            // inputs first: frames that can be read have the inputs that made them
            for (; inputs < run.inputs().size(); inputs++) {
                write(new JournalRecord(
                        JournalRecord.INPUT, content(run.inputs().get(inputs))));
            }
            while (frames < count) {
                int end = Math.min(count, (frames / block + 1) * block);
                write(new JournalRecord(JournalRecord.FRAMES, content(run.frames(), frames, end)));
                frames = end;
            }
        }
        if (channel != null && keptAt - forcedAt >= SECOND) {
            channel.force(false);
            forcedAt = nanos.getAsLong();
        }
    }

    private void begin(Run run) throws IOException {
        layout = new FrameLayout(run.frames().channels());
        block = FrameRecorder.checkedBlock(run.frames().rate(), layout);
        Task task = run.scene()
                .task(run.task())
                .orElseThrow(() -> new IllegalArgumentException("the run's scene lacks its task " + run.task()));
        byte[] scene = SceneXml.write(run.scene()).getBytes(StandardCharsets.UTF_8);
        Frames none = new FrameRecorder(run.frames().rate(), run.frames().channels()).frames();
        Map<String, String> settings = Settings.values(run.scene(), task.id());
        RunManifest manifest = new RunManifest(
                RunFile.program(),
                task.id(),
                task.seed(),
                settings,
                Outcome.RUNNING,
                Report.builder().build(),
                Digest.of(scene),
                none.rate(),
                0,
                Digest.of(none),
                none.channels(),
                List.of(),
                List.of(),
                List.of());
        open();
        write(ByteBuffer.wrap(JournalRecord.MAGIC));
        write(new JournalRecord(JournalRecord.SCENE, scene));
        byte[] head = RunXmlWriter.write(manifest).getBytes(StandardCharsets.UTF_8);
        write(new JournalRecord(JournalRecord.MANIFEST, head));
    }

    private void open() throws IOException {
        for (int k = 0; k < MOST; k++) {
            try {
                Path free = file(target, k);
                channel = FileChannel.open(free, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
                file = free;
                return;
            } catch (FileAlreadyExistsException e) {
                // of a run that was cut off, and perhaps all that is left of it: take the next name
            }
        }
        throw new IOException("too many journals beside " + target + "; delete those that are of no use");
    }

    private static byte[] content(Run.Input input) {
        byte[] key = input.key().getBytes(StandardCharsets.UTF_8);
        return ByteBuffer.allocate(16 + key.length)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putLong(input.step())
                .putDouble(input.value())
                .put(key)
                .array();
    }

    private byte[] content(Frames all, int first, int end) {
        byte[] bytes = new byte[4 + (end - first) * layout.bytes()];
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(first);
        if (all instanceof PartedFrames parted && parted.channels().equals(layout.channels())) {
            // the same layout in the same parts: nothing has to be taken apart
            byte[] part = parted.part(first / block);
            System.arraycopy(part, first % block * layout.bytes(), bytes, 4, bytes.length - 4);
            return bytes;
        }
        for (int frame = first; frame < end; frame++) {
            layout.copy(all, frame, bytes, 4 + (frame - first) * layout.bytes());
        }
        return bytes;
    }

    private void write(JournalRecord entry) throws IOException {
        write(entry.bytes());
    }

    private void write(ByteBuffer bytes) throws IOException {
        while (bytes.hasRemaining()) {
            this.bytes += channel.write(bytes);
        }
    }

    /** Closes the journal and leaves it there. */
    @Override
    public void close() throws IOException {
        if (channel != null && channel.isOpen()) {
            channel.force(false);
            channel.close();
        }
    }

    /** Closes the journal and removes it, once the run is in its place or not wanted. */
    public void discard() throws IOException {
        if (channel != null) {
            channel.close();
            Files.deleteIfExists(file);
        }
    }
}
