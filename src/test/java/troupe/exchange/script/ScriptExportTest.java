package troupe.exchange.script;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.exchange.Formats;
import troupe.exchange.MelGrammar;
import troupe.exchange.SmallRuns;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.StreamExporter;
import troupe.paint.Sketch;
import troupe.run.Run;

/** Writes scripts for Maya and Blender and reads them as their programs would. */
class ScriptExportTest {
    @TempDir
    Path folder;

    static String text(String format, Run run) throws IOException, ExchangeException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ((StreamExporter) Formats.exporter(format)).write(run, ExportSettings.DEFAULT, out);
        return out.toString(StandardCharsets.US_ASCII);
    }

    private static long count(String text, String regex) {
        return Pattern.compile(regex).matcher(text).results().count();
    }

    @Test
    void solidsAndKeysOfAJourneyAreInMel() throws Exception {
        Run run = Sketch.haul();
        Map<String, Integer> calls = MelGrammar.check(text("mel", run));
        int solids = run.scene().obstacles().size() + run.scene().ditches().size() + 1;
        assertEquals(solids, calls.get("troupeRaise"));
        assertEquals(2 * 251, calls.get("troupeKey"), "the actor and the crate, at every frame");
    }

    @Test
    void melPlacesTheCrateWhereItIs() throws Exception {
        String text = text("mel", Sketch.haul());
        assertTrue(text.contains("\"8sec\", 9.2, 7.85, 0, 34.377468);"), "as the CSV export has it");
        assertTrue(text.contains("-maxTime \"10sec\""));
    }

    @Test
    void aCrowdHasATransformAndKeysForEachMember() throws Exception {
        Run run = SmallRuns.crowd();
        Map<String, Integer> calls = MelGrammar.check(text("mel", run));
        assertEquals(3 + 1, calls.get("troupeRaise"));
        assertEquals(3 * run.frames().count(), calls.get("troupeKey"));
        String python = text("blender", run);
        assertEquals(3, count(python, "(?m)^move\\(thing, 0, "));
        assertEquals(1, count(python, "things\\[\"all-2\"\\]"));
        assertEquals(3 * run.frames().count(), count(python, "(?m)^-?[\\d.]+ -?[\\d.]+ -?[\\d.]+ -?[\\d.]+$"));
    }

    @Test
    void oneWhoIsNotThereIsHidden() throws Exception {
        Run run = SmallRuns.visitor();
        Map<String, Integer> calls = MelGrammar.check(text("mel", run));
        assertEquals(3, calls.get("troupeShow"), "hidden, shown, hidden");
        String python = text("blender", run);
        assertTrue(python.contains("show(thing, 0, False)\nshow(thing, 2, True)\nmove(thing, 2, \"\"\"\n"), python);
        assertTrue(python.contains("\"\"\")\nshow(thing, 5, False)\n"), python);
    }

    @Test
    void headingsTurnOnWithoutAJump() throws Exception {
        String python = text("blender", SmallRuns.visitor());
        // from 170 degrees over 180 to 190, which the frames hold as -170
        assertTrue(python.contains("\n1.2 1 0 170\n1.3 1 0 180\n1.4 1 0 190\n"), python);
    }

    @Test
    void textsOfASceneAreNotExecuted() throws Exception {
        Run run = SmallRuns.titled("x\"); import os\n`system \"rm\"` */ 庭 \"\"\" \\");
        MelGrammar.check(text("mel", run));
        assertEquals(1, count(text("blender", run), "import os"));
        assertTrue(text("blender", run).startsWith("# x'); import os?`system 'rm'` '/ ? ''' ': all-go\n"));
    }

    @Test
    void pythonIsCompiledWherePythonIsThere() throws Exception {
        Path script = folder.resolve("run.py");
        for (Run run : List.of(Sketch.haul(), SmallRuns.crowd(), SmallRuns.visitor(), SmallRuns.titled("a\\"))) {
            Files.writeString(script, text("blender", run));
            Process python;
            try {
                python = new ProcessBuilder("python3", "-m", "py_compile", script.toString())
                        .redirectErrorStream(true)
                        .start();
            } catch (IOException e) {
                Assumptions.abort("no python3 to compile scripts with");
                return;
            }
            String said = new String(python.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertEquals(0, python.waitFor(), said);
        }
    }

    @Test
    void theGrammarFindsMistakes() throws Exception {
        String good = text("mel", SmallRuns.crowd());
        for (String[] change : new String[][] {
            {"$troupeNode = ", "$troupeNod = "},
            {"-relative", "-relativ"},
            {"sec\", ", "sec\", 1, "},
            {"`;\n$troupeNodes", "`\n$troupeNodes"},
            {"}", ""}
        }) {
            String bad =
                    good.replaceFirst(Pattern.quote(change[0]), java.util.regex.Matcher.quoteReplacement(change[1]));
            assertThrows(AssertionError.class, () -> MelGrammar.check(bad), change[0]);
        }
    }

    @Test
    void scriptsAreTheSameInAnyLocale() throws Exception {
        Locale before = Locale.getDefault();
        String[] formats = {"mel", "blender"};
        String[] plain = {text("mel", SmallRuns.crowd()), text("blender", SmallRuns.crowd())};
        try {
            for (String tag : List.of("de-DE", "ar-EG-u-nu-arab")) {
                Locale.setDefault(Locale.forLanguageTag(tag));
                assertArrayEquals(
                        plain, new String[] {text(formats[0], SmallRuns.crowd()), text(formats[1], SmallRuns.crowd())});
            }
        } finally {
            Locale.setDefault(before);
        }
    }
}
