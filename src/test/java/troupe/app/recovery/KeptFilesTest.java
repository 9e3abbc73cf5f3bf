package troupe.app.recovery;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class KeptFilesTest {
    /** Larger than any process number. */
    private static final String GONE = "99999999999";

    @TempDir
    Path folder;

    private Path write(Path in, String name, long seconds) throws IOException {
        Files.createDirectories(in);
        Path file = Files.writeString(in.resolve(name), "");
        Files.setLastModifiedTime(file, FileTime.from(Instant.ofEpochSecond(seconds)));
        return file;
    }

    @Test
    void findsWhatAProcessLeftBehindThatIsGoneTheNewestFirst() throws IOException {
        KeptFiles kept = new KeptFiles(folder.resolve("unnamed"));
        Path older = write(folder, ".a.b.xml." + GONE + ".troupe", 1_000);
        Path newer = write(folder, ".c.xml." + GONE + ".troupe", 2_000);
        write(folder, ".other.xml." + GONE + ".troupe", 3_000);
        write(folder, "c.xml." + GONE + ".troupe", 4_000);
        Path unnamed = write(folder.resolve("unnamed"), "." + GONE + ".troupe", 5_000);
        List<KeptFiles.Left> left = kept.leftOf(List.of(folder.resolve("a.b.xml"), folder.resolve("c.xml")));
        assertEquals(
                List.of(newer, older), left.stream().map(KeptFiles.Left::kept).toList());
        assertEquals(Optional.of(folder.resolve("c.xml")), left.get(0).file());
        assertEquals(Instant.ofEpochSecond(1_000), left.get(1).time());
        assertEquals(
                List.of(new KeptFiles.Left(Optional.empty(), unnamed, Instant.ofEpochSecond(5_000))),
                kept.leftUnnamed());
    }

    @Test
    void leavesWhatARunningProcessKeepsAlone() throws IOException {
        KeptFiles kept = new KeptFiles(folder.resolve("unnamed"));
        Path document = folder.resolve("a.xml");
        Files.writeString(kept.slot(Optional.of(document)), "");
        assertTrue(kept.leftOf(List.of(document)).isEmpty());
    }

    @Test
    void aNumberThatAnotherProcessGotSinceDoesNotCount() throws IOException {
        KeptFiles kept = new KeptFiles(folder.resolve("unnamed"));
        Path document = folder.resolve("a.xml");
        Path slot = kept.slot(Optional.of(document));
        write(folder, slot.getFileName().toString(), 1_000);
        assertEquals(1, kept.leftOf(List.of(document)).size());
    }

    @Test
    void foldersThatAreNotThereHoldNothing() throws IOException {
        KeptFiles kept = new KeptFiles(folder.resolve("unnamed"));
        assertTrue(kept.leftUnnamed().isEmpty());
        assertTrue(kept.leftOf(List.of(folder.resolve("no/a.xml"))).isEmpty());
    }
}
