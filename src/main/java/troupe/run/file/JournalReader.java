package troupe.run.file;

import java.io.IOException;
import java.io.InputStream;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.BlockFrames;
import troupe.run.frame.FrameLayout;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Scene;
import troupe.search.Outcome;

/**
 * Reads what a journal holds, up to the first record that is cut off or damaged: every frame that is given out is
 * the one that was written. Used once.
 */
final class JournalReader {
    /** The value of the report that marks a run as recovered. */
    static final String RECOVERED = "recovered";

    private static final int MAX_INPUT = 1 << 16;

    private final Path path;
    private final RandomAccessFile file;
    private final List<Run.Input> inputs = new ArrayList<>();
    private final List<byte[]> blocks = new ArrayList<>();
    private long[] begins = new long[64];
    private FrameLayout layout;
    private int block;
    private int frames;

    private JournalReader(Path path, RandomAccessFile file) {
        this.path = path;
        this.file = file;
    }

    /** Tells whether a file begins as a journal does, be it cut off after that. */
    static boolean isJournal(Path file) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            byte[] begin = in.readNBytes(JournalRecord.MAGIC.length);
            return begin.length > 0 && Arrays.equals(begin, Arrays.copyOf(JournalRecord.MAGIC, begin.length));
        }
    }

    /**
     * Reads a journal. Frames are held or stay in the file as with run files.
     *
     * @throws RunException if not even the scene can be read
     */
    static Run read(Path path) throws RunException, IOException {
        return read(path, RunFile.HELD_BYTES);
    }

    /** Reads a journal whose frames are held if it has at most {@code heldBytes}. */
    static Run read(Path path, long heldBytes) throws RunException, IOException {
        try (RandomAccessFile file = new RandomAccessFile(path.toFile(), "r")) {
            return new JournalReader(path.toAbsolutePath(), file).run(heldBytes);
        }
    }

    private Run run(long heldBytes) throws RunException, IOException {
        file.seek(Math.min(file.length(), JournalRecord.MAGIC.length));
        byte[] xml = head(JournalRecord.SCENE, RunFile.MAX_SCENE);
        RunManifest manifest = RunXmlReader.read(head(JournalRecord.MANIFEST, RunFile.MAX_MANIFEST));
        Scene scene = RunFile.scene(xml, manifest);
        layout = RunFile.layout(manifest);
        block = FrameRecorder.framesPerBlock(manifest.rate());
        boolean held = file.length() <= heldBytes;
        int most = Math.max(MAX_INPUT, 4 + block * layout.bytes());
        long end = file.getFilePointer();
        for (Optional<JournalRecord> next = JournalRecord.read(file, most); next.isPresent(); ) {
            take(next.get(), end, held);
            end = file.getFilePointer();
            next = JournalRecord.read(file, most);
        }
        Report report = Report.builder()
                .put(RECOVERED, true)
                .put("lost_bytes", file.length() - end)
                .build();
        Frames recovered = held
                ? new BlockFrames(manifest.rate(), layout, frames, blocks.toArray(new byte[0][]))
                : new JournalFrames(path, layout, manifest.rate(), frames, begins);
        return new Run(scene, manifest.task(), Outcome.CANCELLED, report, recovered, List.of(), inputs);
    }

    private byte[] head(byte kind, int most) throws RunException, IOException {
        Optional<JournalRecord> found = JournalRecord.read(file, most);
        if (found.isEmpty()) {
            throw new RunException("a journal that was cut off, or damaged, before its first frame");
        }
        if (found.get().kind() != kind) {
            throw new RunException("a journal whose records are out of order");
        }
        return found.get().content();
    }

    private void take(JournalRecord entry, long begin, boolean held) throws RunException {
        ByteBuffer content = ByteBuffer.wrap(entry.content()).order(ByteOrder.LITTLE_ENDIAN);
        if (entry.kind() == JournalRecord.INPUT && content.remaining() >= 16) {
            long step = content.getLong();
            double value = content.getDouble();
            inputs.add(
                    new Run.Input(step, StandardCharsets.UTF_8.decode(content).toString(), value));
        } else if (entry.kind() == JournalRecord.FRAMES && content.remaining() >= 4) {
            frames(content, begin, held);
        } else {
            throw new RunException("a journal with a record of unknown kind " + entry.kind());
        }
    }

    private void frames(ByteBuffer content, long begin, boolean held) throws RunException {
        int first = content.getInt();
        int bytes = content.remaining();
        int count = layout.bytes() == 0 ? 0 : bytes / layout.bytes();
        int place = frames % block;
        int part = frames / block;
        boolean fits = count > 0 && count * layout.bytes() == bytes && place + count <= block;
        if (first != frames || !fits || part >= RunArchive.MAX_PARTS - 2) {
            throw new RunException("a journal whose frames do not follow each other after frame " + frames);
        }
        if (place == 0) {
            begins = part < begins.length ? begins : Arrays.copyOf(begins, 2 * begins.length);
            begins[part] = begin;
            if (held) {
                blocks.add(new byte[block * layout.bytes()]);
            }
        }
        if (held) {
            content.get(blocks.get(part), place * layout.bytes(), bytes);
        }
        frames += count;
    }
}
