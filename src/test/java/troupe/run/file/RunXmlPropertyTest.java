package troupe.run.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.SplittableRandom;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.run.SampleRuns;

/** Mutates {@code run.xml}: only the declared exception may come, with one line. */
class RunXmlPropertyTest {
    private static final long SEED = Long.getLong("troupe.seed", 7);
    private static final int MUTANTS = 2_000;
    private static final String[] TOKENS = {
        "\"",
        "<",
        ">",
        "&",
        "]]>",
        "<!--",
        "-1",
        "1E308",
        "99999999999",
        "NaN",
        "<report>",
        "</report>",
        "<list name=\"x\">",
        "count=\"",
        "name=\"",
        " ",
        "\u0000",
        "é",
        "&#0;",
        "<![CDATA[",
        "<?x ?>",
        "width=\"1000000\""
    };

    @TempDir
    Path folder;

    @Test
    void mutantsAreReadOrRefusedWithOneLine() throws Exception {
        String good = manifest();
        assertEquals(
                "go", RunXmlReader.read(good.getBytes(StandardCharsets.UTF_8)).task());
        SplittableRandom random = new SplittableRandom(SEED);
        int refused = 0;
        for (int i = 0; i < MUTANTS; i++) {
            String mutant = mutated(good, random);
            try {
                RunXmlReader.read(mutant.getBytes(StandardCharsets.UTF_8));
            } catch (RunException e) {
                refused++;
                assertFalse(e.getMessage().contains("\n"), e.getMessage());
                assertTrue(e.getMessage().length() < 400, e.getMessage());
            } catch (RuntimeException e) {
                throw new AssertionError("seed " + SEED + ", mutant " + i + ":\n" + mutant, e);
            }
        }
        assertTrue(refused > MUTANTS / 2, refused + " of " + MUTANTS + " refused");
    }

    private static String mutated(String good, SplittableRandom random) {
        StringBuilder text = new StringBuilder(good);
        int changes = 1 + random.nextInt(3);
        for (int c = 0; c < changes; c++) {
            int at = random.nextInt(text.length());
            int end = Math.min(text.length(), at + 1 + random.nextInt(12));
            switch (random.nextInt(4)) {
                case 0 -> text.delete(at, end);
                case 1 -> text.insert(at, TOKENS[random.nextInt(TOKENS.length)]);
                case 2 -> text.setCharAt(at, (char) random.nextInt(128));
                default -> text.insert(at, text.substring(at, end));
            }
        }
        return text.toString();
    }

    private String manifest() throws Exception {
        Path file = folder.resolve("sample.run");
        RunFile.write(SampleRuns.run(6), file);
        try (ZipFile zip = new ZipFile(file.toFile())) {
            byte[] xml = zip.getInputStream(zip.getEntry("run.xml")).readAllBytes();
            return new String(xml, StandardCharsets.UTF_8);
        }
    }
}
