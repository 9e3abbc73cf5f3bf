package troupe.app.look;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.exchange.Formats;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.run.Run;
import troupe.run.SampleRuns;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.scene.xml.TrackTable;

/** Gives the studio bad files of every kind and looks for English in what it tells a person who reads Chinese. */
class FailuresTest {
    private static final Texts CHINESE = new Texts(Locale.TRADITIONAL_CHINESE);
    /** What is quoted from a file, and the names of commands, may be in any language. */
    private static final Pattern QUOTED = Pattern.compile("「[^」]*」|<[^>]*>|\"[^\"]*\"|troupe \\w+|\\S*/\\S*");

    private static final Pattern ENGLISH = Pattern.compile("[A-Za-z]{2,}[:;]? [a-z'(]{2,}");
    private static final String HEAD =
            "<scene xmlns=\"urn:troupe:scene:1\"><world width=\"10\" depth=\"10\"/><actor id=\"a\"><walk/></actor>";
    private static final String DITCH = "<ditch id=\"a\" points=\"1,1 2,1 2,2\" depth=\"1\"/>";
    private static final String JOURNEY = "<journey id=\"j\" actor=\"a\" start=\"1,1\" goal=\"2,2\"/>";
    private static final String MEETING = "<encounter id=\"e\" actor=\"a\" start=\"1,1\" goal=\"2,2\">";
    private static final List<String> SCENES = List.of(
            "",
            "text",
            "<svg/>",
            "<scene xmlns=\"urn:troupe:scene:1\"/>",
            HEAD,
            HEAD + "<foo/></scene>",
            HEAD + "words</scene>",
            HEAD + DITCH + "</scene>more",
            HEAD + DITCH.replace("/>", "><b/></ditch>") + "</scene>",
            HEAD + DITCH.replace("depth", "wet") + "</scene>",
            HEAD + DITCH.replace("\"1\"", "\"deep\"") + "</scene>",
            HEAD + DITCH.replace("\"1\"", "1") + "</scene>",
            HEAD + DITCH.replace("2,1", "2;1") + "</scene>",
            HEAD + DITCH.replace("2,1", "NaN,1") + "</scene>",
            HEAD + DITCH.replace("1,1 2,1 2,2", "") + "</scene>",
            HEAD + DITCH.replace("1,1 ", "1,1 ".repeat(20_000)) + "</scene>",
            HEAD + DITCH.replace("id=\"a\"", "id=\"a\" colour=\"red\"") + "</scene>",
            HEAD + "<obstacle id=\"o\" points=\"1,1 2,1 2,2\" height=\"1\" movable=\"perhaps\"/></scene>",
            HEAD + "<actor id=\"b\">".repeat(80),
            HEAD + DITCH.repeat(100_001) + "</scene>",
            HEAD + JOURNEY.replace("1,1", "1") + "</scene>",
            HEAD + JOURNEY.replace("/>", " spread=\"x\"/>") + "</scene>",
            HEAD + JOURNEY.replace("/>", " headings=\"9999999999\"/>") + "</scene>",
            HEAD + JOURNEY.replace("/>", " headings=\"many\"/>") + "</scene>",
            HEAD + JOURNEY.replace("/>", " ordering=\"best\"/>") + "</scene>",
            HEAD + JOURNEY.replace("/>", "><prefer walk=\"-1\"/></journey>") + "</scene>",
            HEAD + MEETING + "<tracks file=\"none.csv\"/></encounter></scene>",
            HEAD + MEETING + "<tracks file=\"../none.csv\"/></encounter></scene>",
            HEAD + MEETING + "<avatar id=\"b\" start=\"1,1\"><track points=\"0,1,1\"/></avatar></encounter></scene>",
            HEAD + MEETING + "<avatar id=\"b\"><track points=\"0,1\"/></avatar></encounter></scene>",
            HEAD + MEETING + "<avatar id=\"b\"><head to=\"1,1\"/></avatar></encounter></scene>",
            HEAD + MEETING + "<avatar id=\"b\" radius=\"wide\"/></encounter></scene>",
            HEAD + "<crowd id=\"c\"><group id=\"g\" count=\"x\" spawn=\"1\"/></crowd></scene>",
            HEAD + "<crowd id=\"c\"><group id=\"g\" count=\"2\" spawn=\"1,1 2,1 2,2\" goal=\"5\"/></crowd></scene>");
    private static final List<String> TABLES = List.of(
            "1,2,3",
            "1,2,3,4",
            "# fps=0\n1,2,3,4",
            "# fps=fast\n1,2,3,4",
            "# fps=25\n1,x,3,4",
            "# fps=25\n1,1.5,3,4",
            "# fps=25\n1,1,1e300,4",
            "# fps=25\n1,1,1,4\n1,1,1,4");
    private static final String MAP = "type octile\nheight 3\nwidth 4\nmap\n.@@.\n.@@G\nTSWO\n";
    private static final List<String> MAPS = List.of(
            "",
            "text",
            "// Game: another",
            "type octile\n",
            "type octile\nheight 3\nheight 3\nwidth 4\nmap\n",
            "type octile\nmap\n",
            "type octile\nheight 60000\nwidth 60000\nmap\n",
            MAP.replace("width 4", "width 0"),
            MAP.replace("height 3", "height tall"),
            MAP.replace("height 3", "tall"),
            MAP.replace(".@@G", ".@@"),
            MAP.replace(".@@G", ".@@x"),
            MAP.replace("TSWO\n", ""),
            MAP + "....\n",
            MAP.replace("map\n", ""),
            "type octile\nheight 1000\nwidth 1000\nmap\n"
                    + (".@".repeat(500) + "\n" + "@.".repeat(500) + "\n").repeat(500));
    private static final String DRAWING = """
            <svg viewBox="0 0 400 200" xmlns="http://www.w3.org/2000/svg" xmlns:namo="namo">
              <namo_config cell_size_cm="5.0"><agent agent_id="robot"><goal goal_id="there"/></agent></namo_config>
              <path id="wall" type="wall" d="M 0,0 H 400 v 10 l -400,0 z"/>
              <path id="box" type="movable" d="m 100 50 40 0 0 40 h -40 z"/>
              <path id="robot" type="shape" d="M 40,100 60,80 80,100 60,120 Z"/>
              <path id="there" type="shape" d="M 290,90 h20 v20 h-20 z"/>
            </svg>
            """;
    private static final List<String> DRAWINGS = List.of(
            "",
            "text",
            "<scene/>",
            "<svg",
            "<svg/>",
            DRAWING.substring(0, 300),
            DRAWING + "more",
            "<!DOCTYPE svg [<!ENTITY a \"b\">]>" + DRAWING,
            "<?xml version=\"1.0\" encoding=\"none\"?>" + DRAWING,
            "<?xml version=\"7\"?>" + DRAWING,
            "<?xml version=\"1.0\" encoding=\"UTF-16\"?>" + DRAWING,
            DRAWING.replace("</svg>", "</g>"),
            DRAWING.replace("</svg>", "<g>".repeat(80)),
            DRAWING.replace("</svg>", "<g/>".repeat(100_001) + "</svg>"),
            DRAWING.replace("</svg>", "<a:b/></svg>"),
            DRAWING.replace("</svg>", "<" + "long".repeat(100) + "></svg>"),
            DRAWING.replace("</svg>", "&amp &b; & </svg>"),
            DRAWING.replace("</svg>", "<g id=\"a\" id=\"b\"/></svg>"),
            DRAWING.replace("</svg>", "<g id=a/></svg>"),
            DRAWING.replace("</svg>", "<g id=\"<\"/></svg>"),
            DRAWING.replace("</svg>", "\u0001</svg>"),
            DRAWING.replace("</svg>", "<!-- a -- b --></svg>"),
            DRAWING.replace("</svg>", "]]></svg>"),
            DRAWING.replace("0 0 400 200", ""),
            DRAWING.replace("0 0 400 200", "0 0 wide 200"),
            DRAWING.replace("0 0 400 200", "0 0 -400 200"),
            DRAWING.replace("5.0", "x"),
            DRAWING.replace("5.0", "500"),
            DRAWING.replace("cell_size_cm=\"5.0\"", "collision_margin_cm=\"-3\""),
            DRAWING.replace("<goal goal_id=\"there\"/>", ""),
            DRAWING.replace("agent_id=\"robot\"", "agent_id=\"nobody\""),
            DRAWING.replace("goal_id=\"there\"", ""),
            DRAWING.replace("\"movable\"", "\"moveable\""),
            DRAWING.replace("<path id=\"box\"", "<rect id=\"box\""),
            DRAWING.replace("id=\"box\"", "id=\"box\" transform=\"scale(2)\""),
            DRAWING.replace("id=\"box\"", ""),
            DRAWING.replace("id=\"box\"", "id=\"wall\""),
            DRAWING.replace("id=\"box\"", "id=\"a box\""),
            DRAWING.replace("H 400 v", "A 400 v"),
            DRAWING.replace("l -400,0 z", "l -400, z"),
            DRAWING.replace("l -400,0 z", "l -400"),
            DRAWING.replace("l -400,0 z", "l -400,0 # z"),
            DRAWING.replace("M 0,0 H", "H"),
            DRAWING.replace("H 400", "H 1e999"),
            DRAWING.replace("H 400", "H 1e300"),
            DRAWING.replace("h -40 z", "h -40 z M 9 9 z"),
            DRAWING.replace("h -40 z", "h -40 z 9 9"),
            DRAWING.replace("h -40 z", "h1v1".repeat(5_001)),
            DRAWING.replace("0 40 h -40", "-40 40 h 40"),
            DRAWING.replace("m 100 50 40 0 0 40 h -40 z", "M 0,0 9,9"),
            DRAWING.replace("M 40,100 60,80 80,100 60,120 Z", "M 40,100 60,80"),
            DRAWING.replace("</svg>", "<path type=\"movable\" d=\"M0 0C5e5 0 0 5e5 5 5\"/>".repeat(200) + "</svg>"));

    @TempDir
    Path folder;

    private final Set<String> english = new TreeSet<>();
    private int told;

    private void look(Path file, Exception failure) {
        String line = CHINESE.tell(Failures.line(file, failure));
        told++;
        if (ENGLISH.matcher(QUOTED.matcher(line.replace(file.toString(), "")).replaceAll("「」"))
                .find()) {
            english.add(line);
        }
    }

    private void readScene(Path file) throws IOException {
        try {
            SceneXml.read(file);
        } catch (SceneException e) {
            look(file, e);
            e.problems().forEach(p -> look(file, new IOException(p.message())));
        }
    }

    private Path file(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name), text);
    }

    @Test
    void badScenesAreToldInChinese() throws IOException {
        for (String text : SCENES) {
            readScene(file("a.xml", text));
        }
        readScene(Files.write(folder.resolve("b.xml"), new byte[] {'<', (byte) 0xff, (byte) 0xfe}));
        assertTrue(told >= 2 * SCENES.size(), told + " told");
        assertEquals(Set.of(), english);
    }

    @Test
    void badTablesAreToldInChinese() throws IOException {
        for (String text : TABLES) {
            Path file = file("a.csv", text);
            try (var in = Files.newInputStream(file)) {
                TrackTable.read(in, file.toString(), OptionalDouble.empty());
            } catch (SceneException e) {
                look(file, e);
            }
        }
        assertEquals(TABLES.size(), told);
        assertEquals(Set.of(), english);
    }

    @Test
    void damagedScenesAreToldInChinese() throws IOException {
        long seed = Long.getLong("seed", 11);
        byte[] good = Files.readAllBytes(Path.of("scenes/risk/crossing.xml"));
        Random random = new Random(seed);
        for (int i = 0; i < 200; i++) {
            readScene(Files.write(folder.resolve("a.xml"), damaged(good, random)));
        }
        assertTrue(told > 100, told + " told");
        assertEquals(Set.of(), english, "seed " + seed);
    }

    @Test
    void damagedRunsAreToldInChinese() throws IOException {
        long seed = Long.getLong("seed", 12);
        Path file = folder.resolve("a.run");
        RunFile.write(SampleRuns.run(6), file);
        byte[] good = Files.readAllBytes(file);
        Random random = new Random(seed);
        for (int i = 0; i < 600; i++) {
            Files.write(file, damaged(good, random));
            try {
                RunFile.read(file);
            } catch (RunException e) {
                look(file, e);
            }
        }
        assertTrue(told > 300, told + " told");
        assertEquals(Set.of(), english, "seed " + seed);
    }

    private void bring(Path file) throws IOException {
        try {
            Formats.importerFor(file).orElseThrow().read(file);
        } catch (ExchangeException e) {
            look(file, e);
        }
    }

    @Test
    void badFilesOfOthersAreToldInChinese() throws IOException {
        for (String text : MAPS) {
            bring(file("a.map", text));
        }
        for (String text : DRAWINGS) {
            bring(file("a.svg", text));
        }
        bring(Files.write(folder.resolve("a.svg"), new byte[] {'<', (byte) 0xff, (byte) 0xfe}));
        for (String name : List.of("a.map", "a.svg")) {
            try (RandomAccessFile large =
                    new RandomAccessFile(folder.resolve(name).toFile(), "rw")) {
                large.setLength(40L << 20);
            }
            bring(folder.resolve(name));
        }
        assertEquals(MAPS.size() + DRAWINGS.size() + 3, told);
        assertEquals(Set.of(), english);
    }

    @Test
    void damagedFilesOfOthersAreToldInChinese() throws IOException {
        long seed = Long.getLong("seed", 13);
        Random random = new Random(seed);
        for (int i = 0; i < 300; i++) {
            byte[] map = MAP.getBytes(StandardCharsets.UTF_8);
            bring(Files.write(folder.resolve("a.map"), damaged(map, random)));
            byte[] drawing = DRAWING.getBytes(StandardCharsets.UTF_8);
            bring(Files.write(folder.resolve("a.svg"), damaged(drawing, random)));
        }
        assertTrue(told > 300, told + " told");
        assertEquals(Set.of(), english, "seed " + seed);
    }

    private static byte[] damaged(byte[] good, Random random) {
        byte[] bad = random.nextInt(6) == 0 ? Arrays.copyOf(good, random.nextInt(good.length)) : good.clone();
        byte[] letters = " <>/\"=ab1,&-".getBytes(StandardCharsets.US_ASCII);
        for (int n = 1 + random.nextInt(3); n > 0 && bad.length > 0; n--) {
            bad[random.nextInt(bad.length)] = letters[random.nextInt(letters.length)];
        }
        return bad;
    }

    @Test
    void filesThatCannotBeUsedAreToldInChinese() throws IOException {
        Path none = folder.resolve("none").resolve("a.xml");
        List<Exception> failures = new ArrayList<>();
        failures.add(new AccessDeniedException(none.toString()));
        failures.add(new FileSystemException(none.toString(), null, "No space left on device"));
        failures.add(new FileSystemException(none.toString()));
        failures.forEach(failure -> look(none, failure));
        try {
            SceneXml.read(none);
        } catch (IOException | SceneException e) {
            look(none, e);
        }
        Run run = SampleRuns.run(2);
        for (Path target : List.of(none, folder)) {
            try {
                RunFile.write(run, target);
            } catch (IOException e) {
                look(target, e);
            }
        }
        assertEquals(6, told);
        assertEquals(Set.of(), english);
        assertEquals("找不到檔案 " + none, CHINESE.tell("there is no file " + none));
    }

    @Test
    void exportsThatCannotBeMadeAreToldInChinese() throws IOException {
        ExportSettings large = ExportSettings.DEFAULT.wide(8000);
        for (String format : List.of("pedpy", "gif", "png", "pngs", "svg", "csv", "mel", "blender")) {
            Path target = folder.resolve("none").resolve("a");
            try {
                Formats.exporter(format).write(SampleRuns.run(0), large, target);
            } catch (IOException | ExchangeException e) {
                look(target, e);
            }
        }
        assertTrue(told >= 6, told + " told");
        assertEquals(Set.of(), english);
    }
}
