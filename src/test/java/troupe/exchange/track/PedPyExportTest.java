package troupe.exchange.track;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.exchange.SmallRuns;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.paint.Sketch;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.Channel.Type;
import troupe.run.frame.FrameRecorder;

/** Writes trajectories and reads them by the rules of PedPy's loader. */
class PedPyExportTest {
    @TempDir
    Path folder;

    private List<String> written(Run run) throws Exception {
        Path target = folder.resolve("run.txt");
        new PedPyExport().write(run, ExportSettings.DEFAULT, target);
        return Files.readAllLines(target);
    }

    private static List<String> rows(List<String> lines) {
        return lines.stream().filter(line -> !line.startsWith("#")).toList();
    }

    private static void assertHeader(List<String> lines, String rate) {
        assertEquals("# framerate: " + rate, lines.get(0));
        List<String> header =
                lines.stream().takeWhile(line -> line.startsWith("#")).toList();
        assertEquals("# id\tframe\tx/m\ty/m\tz/m\theading/deg\tradius/m\tability", header.get(header.size() - 1));
        for (String line : header.subList(0, header.size() - 1)) {
            String lower = line.toLowerCase(Locale.ROOT);
            assertFalse(lower.contains("in m") || lower.contains("in cm") || lower.contains("x/"), line);
        }
        assertEquals(1, header.stream().filter(l -> l.contains("framerate")).count());
    }

    /** Checks that rows are sorted by id and frame and contiguous, and returns how many there are of each id. */
    private static long[] counts(List<String> rows, int ids) {
        long[] counts = new long[ids + 1];
        int id = 0;
        int frame = 0;
        for (String row : rows) {
            String[] columns = row.split("\t");
            assertEquals(8, columns.length, row);
            int nextId = Integer.parseInt(columns[0]);
            int nextFrame = Integer.parseInt(columns[1]);
            assertTrue(nextId == id ? nextFrame == frame + 1 : nextId == id + 1, row);
            assertTrue(columns[2].matches("-?\\d+\\.\\d{6}"), row);
            id = nextId;
            frame = nextFrame;
            counts[id]++;
        }
        return counts;
    }

    @Test
    void aCrowdIsWrittenMemberByMember() throws Exception {
        List<String> lines = written(SmallRuns.crowd());
        assertHeader(lines, "25.00");
        assertArrayEquals(new long[] {0, 60, 60, 60}, counts(rows(lines), 3));
        assertEquals(
                "1\t0\t0.500000\t2.500000\t0.000000\t0.000000\t0.2\t-",
                rows(lines).get(0));
        assertEquals(
                "2\t1\t0.550000\t3.000000\t0.000000\t0.000000\t0.2\t-",
                rows(lines).get(61));
        assertTrue(lines.contains("# id 2 = all-2"), lines.toString());
        assertEquals(80 - 2, area(Files.readString(folder.resolve("run.wkt"))), 1e-9);
    }

    /** Returns the area of a polygon without holes, counter-clockwise and closed. */
    private static double area(String text) {
        assertTrue(text.startsWith("POLYGON ((") && text.endsWith("))\n"), text);
        String[] corners = text.substring(10, text.length() - 3).split(", ");
        assertEquals(corners[0], corners[corners.length - 1]);
        double twice = 0;
        for (int i = 0; i + 1 < corners.length; i++) {
            String[] a = corners[i].split(" ");
            String[] b = corners[i + 1].split(" ");
            twice += Double.parseDouble(a[0]) * Double.parseDouble(b[1])
                    - Double.parseDouble(b[0]) * Double.parseDouble(a[1]);
        }
        return twice / 2;
    }

    @Test
    void oneWhoIsNotThereHasNoRows() throws Exception {
        List<String> lines = written(SmallRuns.visitor());
        assertHeader(lines, "12.50");
        assertArrayEquals(new long[] {0, 8, 3}, counts(rows(lines), 2));
        assertEquals(
                "1\t1\t7.000000\t7.000000\t0.000000\t0.000000\t0.25\treplanned",
                rows(lines).get(1));
        assertEquals(
                "2\t2\t1.200000\t1.000000\t0.000000\t170.000000\t0.25\t-",
                rows(lines).get(8));
        assertTrue(Files.exists(folder.resolve("run.wkt")));
    }

    @Test
    void anObstacleThatIsMovedGivesAGeometryForEachPhaseAndNoRows() throws Exception {
        List<String> lines = written(Sketch.haul());
        assertArrayEquals(new long[] {0, 251}, counts(rows(lines), 1));
        assertFalse(Files.exists(folder.resolve("run.wkt")));
        String before = Files.readString(folder.resolve("run-1.wkt"));
        String after = Files.readString(folder.resolve("run-2.wkt"));
        assertTrue(before.matches("POLYGON \\(\\([^()]*\\)(, \\([^()]*\\))*\\)\n"), before);
        assertFalse(before.equals(after), "the crate has moved");
        assertFalse(Files.exists(folder.resolve("run-3.wkt")));
        // moved from 7 s to 9 s at 25 frames a second
        assertTrue(lines.stream().anyMatch(l -> l.startsWith("# walkable area 1: frames 0 to 175")), lines.toString());
        assertTrue(
                lines.stream().anyMatch(l -> l.startsWith("# walkable area 2: frames 225 to 250")), lines.toString());
    }

    @Test
    void filesAreTheSameInAnyLocale() throws Exception {
        List<String> plain = written(SmallRuns.crowd());
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
            assertEquals(plain, written(SmallRuns.crowd()));
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void whatIsNotANumberIsRefusedAndTheOldFileStays() throws Exception {
        Files.writeString(folder.resolve("run.txt"), "old");
        for (double bad : new double[] {Double.NaN, Double.NEGATIVE_INFINITY}) {
            FrameRecorder recorder = new FrameRecorder(
                    25, List.of(new Channel("x", "m", Type.F64, "ann", 1), new Channel("y", "m", Type.F64, "ann", 1)));
            recorder.append(1, 2);
            recorder.append(1, bad);
            Run some = SmallRuns.visitor();
            Run run = new Run(
                    some.scene(), some.task(), some.outcome(), some.report(), recorder.frames(), List.of(), List.of());
            ExchangeException e = assertThrows(ExchangeException.class, () -> written(run));
            assertTrue(e.getMessage().startsWith("frame 1: 'ann'"), e.getMessage());
            assertEquals("old", Files.readString(folder.resolve("run.txt")));
            assertFalse(Files.exists(folder.resolve("run.wkt")));
        }
    }
}
