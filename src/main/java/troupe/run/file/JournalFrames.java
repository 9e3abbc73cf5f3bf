package troupe.run.file;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import troupe.run.frame.FrameLayout;
import troupe.run.frame.PartedFrames;

/**
 * Gives the frames of a journal that is too large to be held: a second is read when it is asked for and checked
 * against its hashes. The last second that was looked at is kept.
 */
final class JournalFrames extends PartedFrames {
    private record Part(int number, byte[] bytes) {}

    private final Path path;
    private final int frameBytes;
    private final long[] begins;
    private volatile Part latest;

    /** Takes the frames of a journal; {@code begins} tells for each second where its first record begins. */
    JournalFrames(Path path, FrameLayout layout, double rate, int count, long[] begins) {
        super(layout, rate, count);
        this.path = path;
        this.frameBytes = layout.bytes();
        this.begins = begins;
    }

    /**
     * {@inheritDoc}
     *
     * @throws UncheckedIOException if the file has been changed or removed since it was opened
     */
    @Override
    public byte[] part(int number) {
        Part part = latest;
        if (part == null || part.number() != number) {
            part = new Part(number, read(number));
            latest = part;
        }
        return part.bytes();
    }

    private byte[] read(int number) {
        byte[] bytes = new byte[partBytes(number)];
        try (RandomAccessFile file = new RandomAccessFile(path.toFile(), "r")) {
            file.seek(begins[number]);
            int at = 0;
            while (at < bytes.length) {
                // what lies between the frames of a second are inputs, much smaller than a frame's limit
                JournalRecord entry = JournalRecord.read(file, (1 << 16) + 4 + bytes.length + frameBytes)
                        .orElseThrow(() -> new IOException(path + " has been changed since it was opened"));
                if (entry.kind() == JournalRecord.FRAMES) {
                    ByteBuffer content = ByteBuffer.wrap(entry.content()).order(ByteOrder.LITTLE_ENDIAN);
                    content.getInt();
                    int taken = Math.min(content.remaining(), bytes.length - at);
                    content.get(bytes, at, taken);
                    at += taken;
                }
            }
            return bytes;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
