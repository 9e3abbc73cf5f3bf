package troupe.run.file;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.run.Digest;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.RunComparison;
import troupe.run.SampleRuns;
import troupe.run.frame.FrameLayout;
import troupe.run.frame.Frames;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.search.Outcome;

class RunFileTest {
    @TempDir
    Path folder;

    @Test
    void readsWhatWasWritten() throws Exception {
        for (int count : new int[] {0, 1, 4, 5, 11}) {
            Run run = SampleRuns.run(count);
            Run back = RunFile.read(written(run));
            assertEquals(run.scene(), back.scene());
            assertEquals("go", back.task());
            assertEquals(run.outcome(), back.outcome());
            assertEquals(run.report(), back.report());
            assertEquals(Optional.empty(), RunComparison.firstDifference(run.frames(), back.frames()));
            assertEquals(Digest.of(run.frames()), Digest.of(back.frames()));
            assertEquals(run.inputs(), back.inputs());
            assertEquals(run.legs().size(), back.legs().size());
            assertEquals("wall", back.legs().get(1).what());
            assertArrayEquals(
                    run.legs().get(0).points().get(1),
                    back.legs().get(0).points().get(1));
        }
    }

    @Test
    void keepsEveryOutcome() throws Exception {
        for (Outcome outcome : List.of(
                Outcome.FOUND,
                Outcome.EXHAUSTED,
                Outcome.CANCELLED,
                Outcome.RUNNING,
                new Outcome.Infeasible("no path: 'Wall' & more"))) {
            Run run = new Run(
                    SampleRuns.scene(),
                    "go",
                    outcome,
                    Report.builder().build(),
                    SampleRuns.frames(0),
                    List.of(),
                    List.of());
            assertEquals(outcome, RunFile.read(written(run)).outcome());
        }
    }

    @Test
    void equalRunsGiveEqualBytes() throws Exception {
        assertArrayEquals(bytes(SampleRuns.run(9)), bytes(SampleRuns.run(9)));
    }

    @Test
    void everyFlippedByteIsRefusedOrHarmless() throws Exception {
        byte[] good = bytes(SampleRuns.run(6));
        String digest = Digest.of(SampleRuns.frames(6));
        Path file = folder.resolve("flipped.run");
        int refused = 0;
        for (int i = 0; i < good.length; i++) {
            byte[] bad = good.clone();
            bad[i] ^= (byte) (1 << i % 8);
            Files.write(file, bad);
            refused += refusedOrEqual(file, digest) ? 1 : 0;
        }
        assertTrue(refused > good.length / 2, refused + " of " + good.length + " refused");
    }

    @Test
    void everyTruncationIsRefused() throws Exception {
        byte[] good = bytes(SampleRuns.run(6));
        Path file = folder.resolve("cut.run");
        for (int length = 0; length < good.length; length++) {
            Files.write(file, Arrays.copyOf(good, length));
            assertTrue(refusedOrEqual(file, ""), "cut to " + length + " bytes");
        }
    }

    private static boolean refusedOrEqual(Path file, String digest) throws IOException {
        try {
            assertEquals(digest, Digest.of(RunFile.read(file).frames()));
            return false;
        } catch (RunException e) {
            assertFalse(e.getMessage().contains("\n"), e.getMessage());
            assertTrue(e.getMessage().startsWith(file.getFileName() + ": "), e.getMessage());
            return true;
        }
    }

    @Test
    void refusesPartsThatDoNotBelong() throws Exception {
        Map<String, byte[]> parts = parts(SampleRuns.run(6));
        parts.put("../../escaped.txt", new byte[1]);
        assertRefused(parts, "3 are there");
        assertFalse(Files.exists(folder.resolve("../../escaped.txt")));
        parts.remove("frames/00001.bin");
        assertRefused(parts, "'frames/00001.bin' is missing");
    }

    @Test
    void refusesASceneThatCannotBePlannedWhenTheHashesAreRight() throws Exception {
        Run sample = SampleRuns.run(3);
        Scene fine = sample.scene();
        Scene bad = fine.with(new World(fine.world().width(), fine.world().depth(), 1e-9));
        Run run = new Run(bad, sample.task(), sample.outcome(), sample.report(), sample.frames(), List.of(), List.of());
        Path file = folder.resolve("bad.run");
        RunFile.write(run, file);
        String message =
                assertThrows(RunException.class, () -> RunFile.read(file)).getMessage();
        assertTrue(message.contains("cell"), message);
        assertFalse(message.contains("\n"), message);
    }

    @Test
    void refusesAPartThatIsThereTwice() throws Exception {
        Path file = zipped(parts(SampleRuns.run(6)));
        String text = Files.readString(file, StandardCharsets.ISO_8859_1);
        Files.writeString(file, text.replace("frames/00001.bin", "frames/00000.bin"), StandardCharsets.ISO_8859_1);
        assertEquals(
                "made.run: part 'frames/00000.bin' is there twice",
                assertThrows(RunException.class, () -> RunFile.read(file)).getMessage());
    }

    @Test
    void refusesAnotherVersion() throws Exception {
        assertManifestRefused("version=\"1\"", "version=\"2\"", "format version 2; this program reads version 1");
    }

    @Test
    void refusesDocumentTypesAndEntities() throws Exception {
        assertManifestRefused("<run ", "<!DOCTYPE run [<!ENTITY a \"b\">]><run ", "DOCTYPE");
    }

    @Test
    void refusesWhatTheSchemaDoesNotAllow() throws Exception {
        assertManifestRefused("<outcome", "<surprise/><outcome", "surprise");
        assertManifestRefused("rate=\"4.0\"", "rate=\"NaN\"", "NaN");
        assertManifestRefused("rate=\"4.0\"", "rate=\"1E999\"", "finite");
        assertManifestRefused("rate=\"4.0\"", "rate=\"0\"", "rate 0.0 frames/s");
        assertManifestRefused("count=\"6\"", "count=\"-6\"", "-6");
        assertManifestRefused("<text name=\"title\"", "<text", "without a name");
        assertManifestRefused("name=\"energy\"", "name=\"solved\"", "is there already");
    }

    @Test
    void refusesSizesThatDoNotFit() throws Exception {
        assertManifestRefused("count=\"6\"", "count=\"2147483647\"", "parts");
        assertManifestRefused("count=\"6\"", "count=\"7\"", "has");
        assertManifestRefused("type=\"F32\" width=\"1\"", "type=\"F32\" width=\"1000000\"", "");
        assertManifestRefused("type=\"F64\" width=\"1\"", "type=\"F64\" width=\"1000000\"", "");
        assertManifestRefused("task=\"go\"", "task=\"went\"", "lacks the task 'went'");
    }

    @Test
    void refusesABombBeforeItsContentIsHeld() throws Exception {
        Map<String, byte[]> parts = parts(SampleRuns.run(6));
        parts.put("run.xml", new byte[RunFile.MAX_MANIFEST + 1]);
        assertRefused(parts, "has more than " + RunFile.MAX_MANIFEST + " bytes");
        parts.putAll(parts(SampleRuns.run(6)));
        parts.put("frames/00000.bin", new byte[1 << 26]);
        assertRefused(parts, "frames/00000.bin' has more than");
    }

    @Test
    void refusesAReportNestedTooDeep() throws Exception {
        String deep = "<list name=\"d\">" + "<list>".repeat(40) + "</list>".repeat(40) + "</list>";
        assertManifestRefused("<report>", "<report>" + deep, "nested deeper");
    }

    @Test
    void saysThatAMissingFileIsMissing() {
        assertThrows(NoSuchFileException.class, () -> RunFile.read(folder.resolve("none.run")));
    }

    @Test
    void framesOfALargeFileStayInItAndAreCheckedWhenRead() throws Exception {
        Run run = SampleRuns.run(50);
        Path file = written(run);
        Frames frames = new FileFrames(file, new FrameLayout(run.frames().channels()), manifest(file));
        assertEquals(Optional.empty(), RunComparison.firstDifference(run.frames(), frames));
        assertEquals(run.frames().value(49, 0, 0), frames.value(49, 0, 0));
        assertThrows(IndexOutOfBoundsException.class, () -> frames.value(50, 0, 0));
        Frames fresh = new FileFrames(file, new FrameLayout(run.frames().channels()), manifest(file));
        Files.write(file, bytes(SampleRuns.run(3)));
        assertThrows(UncheckedIOException.class, () -> fresh.value(40, 0, 0));
    }

    @Test
    void aRunThatCannotBeWrittenLeavesTheOldFile() throws Exception {
        Path file = written(SampleRuns.run(3));
        byte[] before = Files.readAllBytes(file);
        Run bad = new Run(
                SampleRuns.scene(),
                "go",
                Outcome.FOUND,
                Report.builder().put("title", "a\u0001").build(),
                SampleRuns.frames(2),
                List.of(),
                List.of());
        assertThrows(IllegalArgumentException.class, () -> RunFile.write(bad, file));
        assertArrayEquals(before, Files.readAllBytes(file));
        try (var files = Files.list(folder)) {
            assertEquals(List.of(file), files.toList());
        }
    }

    @Test
    void schemaInTheDocumentsIsTheOneInUse() throws Exception {
        try (InputStream in = RunFile.class.getResourceAsStream("/troupe/run/run.xsd")) {
            assertEquals(
                    Files.readString(Path.of("docs/run.xsd")), new String(in.readAllBytes(), StandardCharsets.UTF_8));
        }
    }

    private void assertManifestRefused(String old, String changed, String expected) throws Exception {
        Map<String, byte[]> parts = parts(SampleRuns.run(6));
        String xml = new String(parts.get("run.xml"), StandardCharsets.UTF_8);
        assertTrue(xml.contains(old), xml);
        parts.put("run.xml", xml.replace(old, changed).getBytes(StandardCharsets.UTF_8));
        assertRefused(parts, expected);
    }

    private void assertRefused(Map<String, byte[]> parts, String expected) throws IOException {
        Path file = zipped(parts);
        RunException e = assertThrows(RunException.class, () -> RunFile.read(file));
        assertTrue(e.getMessage().contains(expected), e.getMessage());
        assertFalse(e.getMessage().contains("\n"), e.getMessage());
    }

    private static RunManifest manifest(Path file) throws Exception {
        try (RunArchive archive = new RunArchive(file)) {
            return RunXmlReader.read(archive.read("run.xml", RunFile.MAX_MANIFEST));
        }
    }

    private Path written(Run run) throws IOException {
        Path file = folder.resolve("sample.run");
        RunFile.write(run, file);
        return file;
    }

    private static byte[] bytes(Run run) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        RunFile.write(run, out);
        return out.toByteArray();
    }

    private Map<String, byte[]> parts(Run run) throws IOException {
        Map<String, byte[]> parts = new LinkedHashMap<>();
        try (ZipFile zip = new ZipFile(written(run).toFile())) {
            for (ZipEntry entry : zip.stream().toList()) {
                try (InputStream in = zip.getInputStream(entry)) {
                    parts.put(entry.getName(), in.readAllBytes());
                }
            }
        }
        return parts;
    }

    private Path zipped(Map<String, byte[]> parts) throws IOException {
        Path file = folder.resolve("made.run");
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
            for (Map.Entry<String, byte[]> part : parts.entrySet()) {
                zip.putNextEntry(new ZipEntry(part.getKey()));
                zip.write(part.getValue());
                zip.closeEntry();
            }
        }
        return file;
    }
}
