package troupe.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Gives the frames of a run file that is too large to be held: parts of a second are read when they are
 * asked for, checked against their hash, and the last few are kept. Cost of a frame: reading its second.
 */
final class FileFrames implements Frames {
    private static final int KEPT = 8;

    private record Part(int number, byte[] bytes) {}

    private final Path file;
    private final FrameLayout layout;
    private final double rate;
    private final int count;
    private final int block;
    private final List<String> hashes;
    private final Map<Integer, Part> kept = new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Integer, Part> eldest) {
            return size() > KEPT;
        }
    };
    private volatile Part latest;

    FileFrames(Path file, FrameLayout layout, RunManifest manifest) {
        this.file = file;
        this.layout = layout;
        this.rate = manifest.rate();
        this.count = manifest.count();
        this.block = FrameRecorder.framesPerBlock(rate);
        this.hashes = manifest.partHashes();
    }

    @Override
    public List<Channel> channels() {
        return layout.channels();
    }

    @Override
    public double rate() {
        return rate;
    }

    @Override
    public int count() {
        return count;
    }

    /**
     * {@inheritDoc}
     *
     * @throws UncheckedIOException if the file has been changed or removed since it was opened
     */
    @Override
    public double value(int frame, int channel, int k) {
        if (frame < 0 || frame >= count) {
            throw new IndexOutOfBoundsException("frame " + frame + "; needs 0 to " + (count - 1));
        }
        Part part = latest;
        if (part == null || part.number() != frame / block) {
            part = part(frame / block);
            latest = part;
        }
        return layout.get(part.bytes(), frame % block * layout.bytes(), channel, k);
    }

    private synchronized Part part(int number) {
        Part part = kept.get(number);
        if (part == null) {
            part = new Part(number, read(number));
            kept.put(number, part);
        }
        return part;
    }

    private byte[] read(int number) {
        int frames = Math.min(block, count - number * block);
        try (RunArchive archive = new RunArchive(file)) {
            return archive.read(RunManifest.partName(number), frames * layout.bytes(), hashes.get(number));
        } catch (RunException e) {
            throw new UncheckedIOException(new IOException(file + ": " + e.getMessage(), e));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
