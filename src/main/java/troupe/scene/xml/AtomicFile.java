package troupe.scene.xml;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/**
 * Writes a file so that at any crash the old file or the new one is there, whole: into a file beside the
 * target, forced to disk, then renamed.
 */
public final class AtomicFile {
    private static final int TRIES = 100;

    /** What writes the content; {@code E} is what it may throw besides. */
    @FunctionalInterface
    public interface Content<E extends Exception> {
        /** Writes everything; the stream is buffered and closed by the caller. */
        void writeTo(OutputStream out) throws IOException, E;
    }

    private AtomicFile() {}

    /**
     * Writes {@code target}, replacing what is there. If the content cannot be written the target stays as
     * it is and nothing is left beside it. A link is followed; a device or pipe cannot be replaced and is
     * written to as it comes.
     */
    public static <E extends Exception> void write(Path target, Content<E> content) throws IOException, E {
        Path file = Files.exists(target) ? target.toRealPath() : target.toAbsolutePath();
        if (Files.exists(file) && !Files.isRegularFile(file) && !Files.isDirectory(file)) {
            try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file), 1 << 16)) {
                content.writeTo(out);
            }
            return;
        }
        if (file.getFileName() == null || Files.isDirectory(file)) {
            throw new IOException(target + " is a folder; needs the name of a file");
        }
        if (!Files.isDirectory(file.getParent())) {
            throw new IOException("there is no folder " + file.getParent() + " to write " + file.getFileName() + " to");
        }
        for (int k = 0; k < TRIES; k++) {
            Path part = file.resolveSibling("." + file.getFileName() + "." + k + ".part");
            try (FileChannel channel =
                    FileChannel.open(part, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)) {
                fill(channel, part, file, content);
                return;
            } catch (FileAlreadyExistsException e) {
                // another writer is at work on the same target, or was cut off: take the next name
            } catch (AccessDeniedException e) {
                if (e.getFile() == null || !e.getFile().equals(part.toString())) {
                    throw e;
                }
                throw new IOException(target + " cannot be written: no right to write to " + file.getParent(), e);
            } catch (FileSystemException e) {
                if (e.getFile() == null || !e.getFile().equals(part.toString())) {
                    throw e;
                }
                String reason = e.getReason() == null ? "no file can be made there" : e.getReason();
                throw new IOException(target + " cannot be written to " + file.getParent() + ": " + reason, e);
            }
        }
        throw new IOException("too many unfinished files beside " + target + "; delete those that end in .part");
    }

    private static <E extends Exception> void fill(FileChannel channel, Path part, Path file, Content<E> content)
            throws IOException, E {
        boolean done = false;
        try {
            OutputStream out = new BufferedOutputStream(Channels.newOutputStream(channel), 1 << 16);
            content.writeTo(out);
            out.flush();
            channel.force(true);
            channel.close();
            replace(part, file);
            done = true;
        } finally {
            if (!done) {
                channel.close();
                Files.deleteIfExists(part);
            }
        }
    }

    private static void replace(Path part, Path file) throws IOException {
        try {
            Files.move(part, file, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
        }
    }
}
