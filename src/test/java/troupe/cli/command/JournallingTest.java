package troupe.cli.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.cli.Session;
import troupe.cli.Session.Result;
import troupe.cli.terminal.ExitCode;
import troupe.run.Simulation;
import troupe.run.file.RunJournal;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.work.Tasks;

/** Runs a small crowd with a file to keep, and opens the journal of one that was cut off. */
class JournallingTest {
    private static final String CROWD = """
            <?xml version="1.0" encoding="UTF-8"?>
            <scene xmlns="urn:troupe:scene:1" title="Five">
              <world width="8" depth="4" cell="0.1"/>
              <crowd id="five" seconds="4">
                <group id="all" goal="7,2" count="5" spawn="0.5,0.5 2,0.5 2,3.5 0.5,3.5"/>
              </crowd>
            </scene>
            """;

    @TempDir
    Path folder;

    private Session session;
    private Path scene;
    private Path target;
    private Path journal;

    @BeforeEach
    void writeScene() throws IOException {
        session = new Session(folder);
        scene = Files.writeString(folder.resolve("five.xml"), CROWD);
        target = folder.resolve("five.run");
        journal = folder.resolve("five.run.journal");
    }

    private void cutOffAfter(int steps) throws IOException, SceneException {
        Scene read = SceneXml.read(scene).scene();
        Simulation simulation = (Simulation) Tasks.start(read, "five");
        try (RunJournal kept = new RunJournal(target)) {
            simulation.step(steps);
            kept.keep(simulation);
        }
    }

    @Test
    void aRunThatEndsLeavesNoJournal() throws Exception {
        session.run("run", scene.toString(), "-o", target.toString());
        assertTrue(Files.exists(target));
        assertArrayEquals(
                new String[] {"five.run", "five.xml"},
                java.util.Arrays.stream(folder.toFile().list()).sorted().toArray());
    }

    @Test
    void aJournalIsReplayedVerifiedAndSaved() throws Exception {
        cutOffAfter(60);
        Result shown = session.run("replay", journal.toString());
        assertEquals("five: recovered, 60 of ? frames, 2.36 s\n", shown.out(), shown.toString());
        Result verified = session.run("replay", journal.toString(), "--verify");
        assertEquals("five: verified, 60 frames equal bit by bit\n", verified.out(), verified.toString());
        assertEquals(
                0,
                session.run("replay", journal.toString(), "-o", target.toString())
                        .code());
        assertEquals(shown.out(), session.run("replay", target.toString()).out());
        assertArrayEquals(
                Files.readAllBytes(target),
                session.run("replay", journal.toString(), "-o", "-").bytes());
        assertTrue(Files.exists(journal));
    }

    @Test
    void aJournalThatIsThereIsToldOfAndLeftAlone() throws Exception {
        cutOffAfter(30);
        byte[] before = Files.readAllBytes(journal);
        Result result = session.run("run", scene.toString(), "-o", target.toString());
        assertTrue(result.err().contains("five.run.journal is there"), result.toString());
        assertArrayEquals(before, Files.readAllBytes(journal));
        assertFalse(Files.exists(folder.resolve("five.run.1.journal")));
    }

    @Test
    void whatIsNoJournalAnyMoreIsRefusedInOneLine() throws Exception {
        cutOffAfter(30);
        Files.write(journal, java.util.Arrays.copyOf(Files.readAllBytes(journal), 100));
        Result result = session.run("replay", journal.toString());
        assertEquals(ExitCode.BAD_INPUT, result.code());
        assertEquals(
                "troupe: five.run.journal: a journal that was cut off, or damaged, before its first frame\n",
                result.err());
    }
}
