package troupe.run.file;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import troupe.run.Digest;

/**
 * Gives the parts of a run file as bytes, never more than asked for, whatever the file declares. Names
 * are looked up, never used as paths.
 */
final class RunArchive implements Closeable {
    /** The most parts of a run file: a day in parts of a second, and the two documents. */
    static final int MAX_PARTS = 86_402;

    private final ZipFile zip;
    private final Map<String, ZipEntry> entries = new HashMap<>();

    /**
     * Opens a file and looks at its table of contents.
     *
     * @throws RunException if it is no ZIP, holds a name twice or too many parts
     * @throws IOException if the file is not there or cannot be opened
     */
    RunArchive(Path file) throws RunException, IOException {
        ZipFile opened = opened(file);
        boolean good = false;
        try {
            index(opened);
            good = true;
        } catch (IllegalArgumentException e) {
            throw new RunException("the table of contents is damaged", e);
        } finally {
            if (!good) {
                opened.close();
            }
        }
        zip = opened;
    }

    private static ZipFile opened(Path file) throws RunException, IOException {
        try (InputStream probe = Files.newInputStream(file)) {
            probe.read();
        }
        try {
            return new ZipFile(file.toFile());
        } catch (IOException | IllegalArgumentException e) {
            throw new RunException("not a ZIP archive, or cut off", e);
        }
    }

    private void index(ZipFile opened) throws RunException {
        if (opened.size() > MAX_PARTS) {
            throw new RunException(opened.size() + " parts; a run has at most " + MAX_PARTS);
        }
        Iterator<? extends ZipEntry> all = opened.entries().asIterator();
        while (all.hasNext()) {
            ZipEntry entry = all.next();
            if (entries.putIfAbsent(entry.getName(), entry) != null) {
                throw new RunException("part '" + RunXmlReader.oneLine(entry.getName()) + "' is there twice");
            }
        }
    }

    /** Returns the number of parts. */
    int size() {
        return entries.size();
    }

    /**
     * Reads a part of at most {@code most} bytes.
     *
     * @throws RunException if it is missing, larger, or damaged
     */
    byte[] read(String name, int most) throws RunException {
        ZipEntry entry = entries.get(name);
        if (entry == null) {
            throw new RunException("part '" + name + "' is missing");
        }
        byte[] bytes;
        try (InputStream in = zip.getInputStream(entry)) {
            bytes = in.readNBytes(most + 1);
        } catch (IOException | IllegalArgumentException e) {
            throw new RunException("part '" + name + "' is damaged", e);
        }
        if (bytes.length > most) {
            throw new RunException("part '" + name + "' has more than " + most + " bytes");
        }
        CRC32 check = new CRC32();
        check.update(bytes);
        if (check.getValue() != entry.getCrc()) {
            throw new RunException("part '" + name + "' is damaged (its check sum differs)");
        }
        return bytes;
    }

    /**
     * Reads a part whose hash is known.
     *
     * @throws RunException if it is missing, larger than {@code most}, or not what was written
     */
    byte[] read(String name, int most, String hash) throws RunException {
        byte[] bytes = read(name, most);
        if (!Digest.of(bytes).equals(hash)) {
            throw new RunException("part '" + name + "' is damaged (its SHA-256 differs)");
        }
        return bytes;
    }

    @Override
    public void close() throws IOException {
        zip.close();
    }
}
