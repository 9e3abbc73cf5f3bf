package troupe.run.file;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import troupe.run.frame.FrameLayout;
import troupe.run.frame.PartedFrames;

/**
 * Gives the frames of a run file that is too large to be held: parts of a second are read when they are
 * asked for, checked against their hash, and the last few are kept. Cost of a frame: reading its second.
 */
final class FileFrames extends PartedFrames {
    private static final int KEPT = 8;

    private record Part(int number, byte[] bytes) {}

    private final Path file;
    private final List<String> hashes;
    private final Map<Integer, Part> kept = new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Integer, Part> eldest) {
            return size() > KEPT;
        }
    };
    private volatile Part latest;

    FileFrames(Path file, FrameLayout layout, RunManifest manifest) {
        super(layout, manifest.rate(), manifest.count());
        this.file = file;
        this.hashes = manifest.partHashes();
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
            part = recent(number);
            latest = part;
        }
        return part.bytes();
    }

    private synchronized Part recent(int number) {
        Part part = kept.get(number);
        if (part == null) {
            part = new Part(number, read(number));
            kept.put(number, part);
        }
        return part;
    }

    private byte[] read(int number) {
        try (RunArchive archive = new RunArchive(file)) {
            return archive.read(RunManifest.partName(number), partBytes(number), hashes.get(number));
        } catch (RunException e) {
            throw new UncheckedIOException(new IOException(file + ": " + e.getMessage(), e));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
