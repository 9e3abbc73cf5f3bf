package troupe.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.cli.Session.Result;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.Option;
import troupe.exchange.Formats;
import troupe.exchange.format.ExportSettings;
import troupe.run.Run;
import troupe.run.file.RunFile;

/** Types commands from end to end. */
class CommandLineTest {
    private static final String SCENE = """
            <?xml version="1.0" encoding="UTF-8"?>
            <scene xmlns="urn:troupe:scene:1" title="Two rooms">
              <world width="6" depth="4" cell="0.1"/>
              <obstacle id="wall" height="2" points="2.8,0 3.2,0 3.2,3 2.8,3"/>
              <actor id="anna"/>
              <journey id="round" actor="anna" start="1,1" goal="5,1"/>
              <journey id="short" actor="anna" start="1,1" goal="2,1"/>
            </scene>
            """;
    private static final byte[] PNG = {(byte) 0x89, 'P', 'N', 'G'};

    @TempDir
    Path folder;

    private Session session;
    private String scene;

    @BeforeEach
    void writeScene() throws IOException {
        session = new Session(folder);
        scene = written("rooms.xml", SCENE);
    }

    @Test
    void helpOfEveryCommandNamesItsOptions() {
        Result all = session.run("--help");
        assertEquals(0, all.code());
        for (Command command : Troupe.all()) {
            assertTrue(all.out().contains("  " + command.name() + " "), all.out());
            Result one = session.run(command.name(), "--help");
            assertEquals(0, one.code(), one.toString());
            assertTrue(one.out().startsWith("usage: troupe " + command.name()), one.out());
            for (Option option : command.options()) {
                assertTrue(one.out().contains(option.name()), option.name() + " in " + one.out());
            }
        }
    }

    @Test
    void badUseEndsWithCodeTwoAndOneReason() {
        assertUse("unknown command 'frobnicate'", "frobnicate");
        assertUse("unknown option --bar", "run", scene, "--bar");
        assertUse("needs SCENE", "run");
        assertUse("unknown task 'none'; the scene has round, short", "run", scene, "--task", "none");
        assertUse("ordering", "run", scene, "--set", "frob=1");
        assertUse("key=value", "run", scene, "--set", "frob");
        assertUse("--seed", "run", scene, "--seed", "many");
        assertUse("--show", "fields", scene, "--show", "colour", "-o", folder.toString());
        assertUse("-o", "fields", scene);
        assertUse("needs KEY=N", "fields", scene, "--aspect", "space", "-o", folder.toString());
        assertUse("needs KEY=N", "fields", scene, "--aspect", "space=0", "-o", folder.toString());
        assertUse("needs a task that offers a choice", "fields", scene, "--aspect", "hue=1", "-o", folder.toString());
        assertUse("--vary", "batch", scene, "--vary", "seed");
        assertUse("preference.walk=off: ", "batch", scene, "--task", "round", "--vary", "preference.walk=1,off");
        assertUse("--seeds", "batch", scene, "--seeds", "9..1");
        assertUse("--problems", "batch", scene, "--problems", "x", "--seeds", "1..2");
        assertUse("there is no folder", "record", folder.resolve("none").toString());
        assertUse("format 'wav'", "export", scene, "--format", "wav", "-o", "x");
        assertUse("needs --format", "import", scene, "-o", "x.xml");
        assertUse("--png is missing", "replay", scene, "--at", "1");
        assertUse("--png is missing", "replay", scene, "--view", "solid");
        assertUse("needs plan or solid", "export", recorded(), "-o", "x.png", "--view", "side");
        assertUse("elevation 10 to 85", "export", recorded(), "-o", "x.png", "--view", "solid", "--turn", "3,90");
        assertUse("needs --view solid", "export", recorded(), "-o", "x.png", "--turn", "3,40");
    }

    private void assertUse(String reason, String... typed) {
        Result result = session.run(typed);
        assertEquals(2, result.code(), List.of(typed) + ": " + result);
        assertTrue(result.err().contains(reason), List.of(typed) + ": " + result);
        assertEquals("", result.out());
    }

    @Test
    void badInputEndsWithCodeThreeAndOneLine() throws IOException {
        String broken = written("broken.xml", SCENE.replace("</scene>", ""));
        String twisted = written("twisted.xml", SCENE.replace("3.2,3 2.8,3", "2.8,3 3.3,3"));
        String noRun = written("no.run", "nothing");
        assertInput("there is no file", "run", folder.resolve("none.xml").toString());
        assertInput("there is no file", "open", folder.resolve("none.xml").toString());
        for (String command : List.of("run", "check", "replay", "batch", "open")) {
            assertInput(folder + ": is a folder; needs a file", command, folder.toString());
        }
        assertInput("broken.xml", "run", broken);
        assertInput("broken.xml", "check", broken);
        assertInput("wall", "run", twisted);
        assertInput("wall", "batch", twisted);
        assertInput("no.run: not a ZIP", "replay", noRun);
        assertInput(
                "no.run: not a ZIP",
                "export",
                noRun,
                "-o",
                folder.resolve("x.csv").toString());
        assertInput("no.run", "record", folder.toString());
        assertInput("", "import", scene, "--format", "movingai", "-o", "-");
        assertInput(
                "there is no folder",
                "run",
                scene,
                "-o",
                folder.resolve("no/x.run").toString());
    }

    private void assertInput(String reason, String... typed) {
        Result result = session.run(typed);
        assertEquals(3, result.code(), List.of(typed) + ": " + result);
        assertTrue(result.err().contains(reason), List.of(typed) + ": " + result);
        assertEquals(
                1,
                result.err().lines().filter(l -> !l.contains("task 'round' of")).count(),
                result.err());
        assertFalse(result.err().contains("Exception"), result.err());
    }

    @Test
    void checkTellsEveryProblem() throws IOException {
        Result good = session.run("check", scene);
        assertEquals(0, good.code(), good.toString());
        assertTrue(good.out().endsWith("rooms.xml: 0 errors, 0 warnings\n"), good.out());
        String bad = written("bad.xml", SCENE.replace("goal=\"5,1\"", "goal=\"3,1\""));
        Result result = session.run("check", bad);
        assertEquals(1, result.code(), result.toString());
        assertTrue(
                result.out().contains("bad.xml:6: error: round: the goal (3, 1) is inside obstacle 'wall'"),
                result.out());
        assertTrue(result.out().contains("1 error,"), result.out());
    }

    @Test
    void runPrintsOneObjectWithTheStableKeysFirst() {
        Result result = session.run("run", scene, "--task", "round", "--json");
        assertEquals(0, result.code(), result.toString());
        assertEquals(1, result.out().lines().count());
        Matcher keys = Pattern.compile("\"([a-z_]+)\":").matcher(result.out());
        List<String> found = new ArrayList<>();
        while (keys.find()) {
            found.add(keys.group(1));
        }
        found.removeAll(List.of("layers", "region", "nf2", "instances", "search"));
        assertEquals(
                List.of(
                        "task",
                        "solved",
                        "energy",
                        "cost",
                        "length",
                        "abilities",
                        "moved",
                        "expanded",
                        "times_ms",
                        "frames",
                        "digest"),
                found.subList(0, 11));
        for (String stage : List.of("layers", "region", "nf2", "instances", "search")) {
            assertTrue(result.out().contains("\"" + stage + "\":"), result.out());
        }
        assertTrue(result.out().contains("\"solved\":true"), result.out());
        assertTrue(result.out().contains("\"abilities\":[\"walk\"]"), result.out());
        assertEquals("", result.err());
    }

    @Test
    void runReadsStandardInputAndWritesStandardOutput() throws IOException {
        Result result = session.run(
                SCENE.getBytes(StandardCharsets.UTF_8), false, "run", "-", "--task", "round", "-o", "-", "--quiet");
        assertEquals(0, result.code(), result.toString());
        Path file = folder.resolve("piped.run");
        Files.write(file, result.bytes());
        Result replay = session.run("replay", file.toString());
        assertTrue(replay.out().startsWith("round: solved: walk; "), replay.toString());
    }

    @Test
    void runSaysWhyThereIsNoSolution() throws IOException {
        String closed = written("closed.xml", SCENE.replace("3.2,3 2.8,3", "3.2,4 2.8,4"));
        Result result = session.run(
                "run",
                closed,
                "--task",
                "round",
                "-o",
                folder.resolve("none.run").toString());
        assertEquals(1, result.code(), result.toString());
        assertTrue(result.out().startsWith("round: no solution: "), result.out());
        Result json = session.run("run", closed, "--task", "round", "--json");
        assertTrue(json.out().contains("\"solved\":false"), json.out());
        assertTrue(json.out().contains("\"outcome\":\"infeasible\",\"reason\":\""), json.out());
        Result saved = session.run("replay", folder.resolve("none.run").toString());
        assertTrue(saved.out().startsWith("round: no solution: "), saved.out());
    }

    @Test
    void runTellsALimitFromNoSolution() {
        Result result = session.run("run", scene, "--task", "round", "--set", "limit.expansions=3");
        assertEquals(1, result.code(), result.toString());
        assertTrue(result.out().contains("gave up at the limit"), result.out());
    }

    @Test
    void interruptionEndsCleanlyAndKeepsWhatIsComplete() {
        String big = scene;
        Path file = folder.resolve("cut.run");
        Result result = session.run(
                new byte[0], true, "run", big, "--task", "round", "--set", "cell=0.005", "-o", file.toString());
        assertEquals(1, result.code(), result.toString());
        Result replay = session.run("replay", file.toString());
        assertTrue(replay.out().startsWith("round: cancelled"), replay.toString());
    }

    @Test
    void replayVerifiesEveryBit() throws IOException {
        String file = recorded();
        Result result = session.run("replay", file, "--verify");
        assertEquals(0, result.code(), result.toString());
        assertTrue(result.out().contains("frames equal bit by bit"), result.out());
    }

    @Test
    void replayDrawsAnInstant() throws IOException {
        Path png = folder.resolve("a.png");
        assertEquals(
                0,
                session.run("replay", recorded(), "--at", "1", "--png", png.toString())
                        .code());
        assertPng(Files.readAllBytes(png));
        assertPng(session.run("replay", recorded(), "--png", "-").bytes());
    }

    @Test
    void replayDrawsThreeDimensionsFromAnySide() throws IOException {
        String file = recorded();
        byte[] plan = session.run("replay", file, "--png", "-").bytes();
        byte[] solid =
                session.run("replay", file, "--png", "-", "--view", "solid").bytes();
        byte[] turned = session.run("replay", file, "--png", "-", "--view", "solid", "--turn", "120,60")
                .bytes();
        assertPng(solid);
        assertPng(turned);
        assertFalse(Arrays.equals(plan, solid));
        assertFalse(Arrays.equals(turned, solid));
        Path gif = folder.resolve("solid.gif");
        Result result =
                session.run("export", file, "-o", gif.toString(), "--view", "solid", "--width", "200", "--rate", "2");
        assertEquals(0, result.code(), result.toString());
        assertEquals("GIF", new String(Files.readAllBytes(gif), 0, 3, StandardCharsets.US_ASCII));
    }

    @Test
    void fieldsDrawsAPictureForEachOverlayAndTellsTheTimes() throws IOException {
        Path out = folder.resolve("fields");
        Result result = session.run("fields", scene, "--task", "round", "--width", "200", "-o", out.toString());
        assertEquals(0, result.code(), result.toString());
        for (String key : List.of("layers", "region", "class", "clearance", "skeleton", "potential", "effort")) {
            assertPng(Files.readAllBytes(out.resolve(key + "-1.png")));
        }
        for (String stage : List.of("layers", "region", "nf2")) {
            assertTrue(
                    Pattern.compile("(?m)^" + stage + " +[0-9.]+ ms$")
                            .matcher(result.out())
                            .find(),
                    result.out());
        }
    }

    @Test
    void exportWritesEveryFormat() throws IOException {
        String file = recorded();
        Result csv = session.run("export", file, "--format", "csv", "-o", "-");
        assertEquals(0, csv.code(), csv.toString());
        assertTrue(
                csv.out().startsWith("frame,time,id,x,y,z,heading,ability"),
                csv.out().substring(0, 80));
        Path svg = folder.resolve("a.svg");
        assertEquals(0, session.run("export", file, "-o", svg.toString()).code());
        assertTrue(Files.readString(svg).contains("<svg"));
        assertFalse(Files.readString(svg).contains(">skeleton<"));
        String views = "potential,skeleton";
        assertEquals(
                0,
                session.run("export", file, "--show", views, "-o", svg.toString())
                        .code());
        assertTrue(Files.readString(svg).contains(">skeleton<"), "the legend names the view");
    }

    @Test
    void batchGivesTheSameRowsOnAnyNumberOfThreads() {
        String[] typed = {
            "batch",
            scene,
            "--task",
            "round",
            "--vary",
            "ordering=optimal,bounded(1.5)",
            "--vary",
            "preference.sidestep=1,off",
            "--seeds",
            "1..3",
            "--jobs",
            "1"
        };
        Result one = session.run(typed);
        assertEquals(0, one.code(), one.toString());
        assertEquals(1 + 2 * 2 * 3, one.out().lines().count());
        assertTrue(one.out().startsWith("task,ordering,preference.sidestep,seed,outcome,solved,energy,"), one.out());
        assertTrue(one.out().contains("\nround,bounded(1.5),off,3,found,true,"), one.out());
        typed[typed.length - 1] = "4";
        assertEquals(withoutTimes(one.out()), withoutTimes(session.run(typed).out()));
    }

    private static String withoutTimes(String table) {
        return table.replaceAll("(?m),[0-9.]+$", "");
    }

    @Test
    void batchSolvesEveryProblemOfAScenario() throws IOException {
        String map = written("tiny.map", "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n");
        String problems = written(
                "tiny.scen",
                "version 1\n0\ttiny.map\t4\t3\t0\t0\t3\t2\t5.00000000\n0\ttiny.map\t4\t3\t0\t0\t3\t0\t3.00000000\n");
        Result result = session.run("batch", map, "--problems", problems);
        assertEquals(0, result.code(), result.toString());
        assertTrue(
                result.out()
                        .matches("(?s)start,goal,length,optimal,expanded,micros\n"
                                + "0 0,3 2,5\\.00000000,5\\.0,\\d+,[0-9.]+\n0 0,3 0,3\\.00000000,3\\.0,\\d+,[0-9.]+\n"),
                result.out());
        assertTrue(result.err().contains("2 problems, 2 of optimal length"), result.err());
        String wrong = written("wrong.scen", "version 1\n0\ttiny.map\t4\t3\t0\t0\t3\t2\t4.50000000\n");
        Result other = session.run("batch", map, "--problems", wrong);
        assertEquals(1, other.code(), other.toString());
        assertTrue(other.err().contains("first other length: 0 0,3 2,5.00000000,4.5"), other.err());
    }

    @Test
    void importMakesASceneThatReadsBack() throws IOException {
        String map = written("tiny.map", "type octile\nheight 3\nwidth 4\nmap\n....\n.@@.\n....\n");
        Path out = folder.resolve("tiny.xml");
        assertEquals(0, session.run("import", map, "-o", out.toString()).code());
        Result check = session.run("check", out.toString());
        assertEquals(0, check.code(), check.toString());
    }

    @Test
    void recordTellsWhatChangedAndLeavesTheRestAlone() throws IOException {
        Path golden = Files.createDirectory(folder.resolve("golden"));
        Path file = golden.resolve("a.run");
        Files.copy(Path.of(recorded()), file);
        byte[] before = Files.readAllBytes(file);
        Result same = session.run("record", golden.toString());
        assertEquals("a.run: unchanged\n0 of 1 runs changed\n", same.out(), same.toString());
        assertArrayEquals(before, Files.readAllBytes(file));
    }

    @Test
    void withoutDisplayTheDefaultSceneIsPlannedAndDrawn() throws IOException {
        Result result = session.run();
        assertEquals(0, result.code(), result.toString());
        assertTrue(result.err().contains("there is no display"), result.err());
        assertTrue(result.out().contains(folder.resolve("courtyard.png").toString()), result.out());
        assertPng(Files.readAllBytes(folder.resolve("courtyard.png")));
        assertEquals(
                0,
                session.run("replay", folder.resolve("courtyard.run").toString())
                        .code());
    }

    @Test
    void nothingUnfinishedIsLeftBehind() throws IOException {
        recorded();
        session.run(
                "run",
                scene,
                "--task",
                "round",
                "-o",
                folder.resolve("no/x.run").toString());
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(
                    List.of(), files.filter(f -> f.toString().endsWith(".part")).toList());
        }
    }

    @Test
    void interruptedExportsLeaveNothing() throws IOException {
        String file = recorded();
        for (String format : List.of("gif", "pngs", "png", "svg", "csv")) {
            Path out = Files.createDirectory(folder.resolve("cut-" + format));
            Result result = session.run(
                    new byte[0],
                    true,
                    "export",
                    file,
                    "--format",
                    format,
                    "-o",
                    out.resolve("a." + format).toString());
            assertEquals(130, result.code(), format + ": " + result);
            assertEquals(List.of(), listed(out), format);
        }
        Path drawn = folder.resolve("cut-fields");
        Result result = session.run(new byte[0], true, "fields", scene, "--task", "round", "-o", drawn.toString());
        assertEquals(130, result.code(), result.toString());
        assertTrue(Files.notExists(drawn), "nothing was drawn");
    }

    @Test
    void filmCutOffInTheMiddleIsTakenAway() throws Exception {
        Path out = Files.createDirectory(folder.resolve("film"));
        int[] asked = {0};
        Run run = RunFile.read(Path.of(recorded()));
        ExportSettings settings = ExportSettings.DEFAULT.wide(200).until(() -> ++asked[0] > 6);
        assertThrows(InterruptedIOException.class, () -> Formats.exporter("pngs")
                .write(run, settings, out.resolve("a.png")));
        assertEquals(7, asked[0]);
        assertEquals(List.of(), listed(out));
    }

    private static List<String> listed(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(Path::toString).toList();
        }
    }

    @Test
    void lostOutputIsNoSuccess() {
        OutputStream full = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("No space left on device");
            }
        };
        for (String[] typed : List.of(
                new String[] {"run", scene, "--task", "round", "--json"},
                new String[] {"run", scene, "--task", "round", "-o", "-"},
                new String[] {"check", scene},
                new String[] {"--help"})) {
            Result result = session.run(full, typed);
            assertEquals(3, result.code(), List.of(typed) + ": " + result);
            assertTrue(result.err().contains("standard output cannot be written"), result.err());
        }
    }

    @Test
    void dashReadsRunsAndMapsFromStandardInput() throws IOException {
        byte[] run = Files.readAllBytes(Path.of(recorded()));
        Result replay = session.run(run, false, "replay", "-");
        assertTrue(replay.out().startsWith("round: solved: walk; "), replay.toString());
        Result csv = session.run(run, false, "export", "-", "--format", "csv", "-o", "-");
        assertTrue(csv.out().startsWith("frame,time,id"), csv.toString());
        Result bad = session.run(new byte[9], false, "replay", "-");
        assertEquals(3, bad.code(), bad.toString());
        assertTrue(bad.err().startsWith("troupe: standard input: not a ZIP"), bad.err());
        byte[] map = "type octile\nheight 1\nwidth 2\nmap\n..\n".getBytes(StandardCharsets.UTF_8);
        Result scene = session.run(map, false, "import", "-", "--format", "movingai", "-o", "-");
        assertEquals(0, scene.code(), scene.toString());
        assertTrue(scene.out().contains("<scene"), scene.out());
        assertTrue(scene.err().contains("has no task yet; write <journey id=\"go\" actor=\"walker\""), scene.err());
    }

    @Test
    void effortIsDrawnOnlyWhereTheSearchWas() throws IOException {
        Path out = folder.resolve("effort");
        Result result = session.run(
                "fields", "scenes/unified/courtyard.xml", "--show", "effort", "--width", "200", "-o", out.toString());
        assertEquals(0, result.code(), result.toString());
        assertEquals(List.of(out.resolve("effort-1.png").toString()), listed(out));
    }

    @Test
    void settingsThatMakeAnErrorAreBadUse() {
        assertUse("--set cell=0: the world's cell is 0; ", "run", scene, "--task", "round", "--set", "cell=0");
        assertUse("--set goal=20,4: round: ", "run", scene, "--task", "round", "--set", "seed=2", "--set", "goal=20,4");
        assertUse("--set preference.walk=off: ", "fields", scene, "--set", "preference.walk=off", "-o", "x");
        assertUse("--set start=NaN,1", "run", scene, "--set", "start=NaN,1");
    }

    @Test
    void checkTellsEveryMistakeOfTheFileItself() throws IOException {
        String wrong = written("wrong.xml", SCENE.replace("height=", "hight=").replace("actor=", "acter="));
        Result result = session.run("check", wrong);
        assertEquals(3, result.code(), result.toString());
        assertTrue(result.err().contains("wrong.xml:4: error: "), result.err());
        assertTrue(result.err().contains("wrong.xml:6: error: "), result.err());
        assertTrue(result.err().contains("wrong.xml:7: error: "), result.err());
    }

    @Test
    void cellOfNothingIsOneError() throws IOException {
        String flat = written("flat.xml", SCENE.replace("cell=\"0.1\"", "cell=\"0\""));
        Result result = session.run("check", flat);
        assertEquals(1, result.code(), result.toString());
        assertTrue(result.out().contains("flat.xml: error: the world's cell is 0; give a number"), result.out());
        assertTrue(result.out().endsWith("flat.xml: 1 error, 0 warnings\n"), result.out());
    }

    @Test
    void quietSaysNothingOfTheTask() {
        assertTrue(session.run("run", scene).err().contains("task 'round' of round, short"));
        assertEquals("", session.run("run", scene, "--quiet").err());
    }

    @Test
    void versionIsTold() {
        Result result = session.run("--version");
        assertEquals(0, result.code());
        assertTrue(result.out().matches("Troupe \\S+\n"), result.out());
    }

    @Test
    void sceneWithoutTaskSaysWhatToWrite() throws IOException {
        String idle = written("idle.xml", SCENE.replaceAll("<journey.*", ""));
        Result check = session.run("check", idle);
        assertEquals(0, check.code(), check.toString());
        assertTrue(check.out().contains("idle.xml: warning: the scene has no task"), check.out());
        assertInput("no task to plan; write <journey id=\"go\" actor=\"anna\"", "run", idle);
    }

    @Test
    void exportAndReplayShowTheSameInstantUnlessTold() {
        String file = recorded();
        assertArrayEquals(
                session.run("replay", file, "--png", "-").bytes(),
                session.run("export", file, "--format", "png", "-o", "-").bytes());
    }

    @Test
    void fileInThePlaceOfAFolderIsNamed() {
        assertInput("is a file; -o needs a folder", "fields", scene, "-o", scene);
    }

    private String recorded() {
        String file = folder.resolve("round.run").toString();
        Result result = session.run("run", scene, "--task", "round", "-o", file, "--quiet");
        assertEquals(0, result.code(), result.toString());
        assertEquals("", result.out());
        return file;
    }

    private static void assertPng(byte[] bytes) {
        assertArrayEquals(PNG, java.util.Arrays.copyOf(bytes, PNG.length));
    }

    private String written(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.writeString(file, text);
        return file.toString();
    }
}
