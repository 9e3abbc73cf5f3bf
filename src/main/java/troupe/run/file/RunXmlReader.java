package troupe.run.file;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.xml.validation.Schema;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.scene.xml.StrictXml;
import troupe.scene.xml.XmlMistakes;
import troupe.search.Outcome;

/** Reads {@code run.xml}, checked against its schema while it is read; document types are refused. Used once. */
final class RunXmlReader extends DefaultHandler {
    private static final int MAX_DEPTH = 32;

    /** Values of a report or of a list that is being read. */
    private record Level(String name, Report.Builder report, List<Object> list) {}

    private final Deque<Level> levels = new ArrayDeque<>();
    private final List<Channel> channels = new ArrayList<>();
    private final List<String> parts = new ArrayList<>();
    private final List<Run.Leg> legs = new ArrayList<>();
    private final List<Run.Input> inputs = new ArrayList<>();
    private final Map<String, String> settings = new LinkedHashMap<>();
    private Locator locator;
    private String program;
    private String task;
    private long seed;
    private Outcome outcome;
    private Report report;
    private String sceneHash;
    private double rate;
    private int count;
    private String digest;

    private RunXmlReader() {}

    /**
     * Reads a manifest.
     *
     * @throws RunException if it is not well-formed, does not follow the schema, or is of another version
     */
    static RunManifest read(byte[] xml) throws RunException {
        RunXmlReader reader = new RunXmlReader();
        try {
            StrictXml.parse(xml, Optional.of(Compiled.SCHEMA), reader);
            return reader.manifest();
        } catch (SAXParseException e) {
            throw new RunException("run.xml:" + e.getLineNumber() + ":" + e.getColumnNumber() + ": " + plain(e), e);
        } catch (SAXException | IOException e) {
            throw new RunException("run.xml: " + plain(e), e);
        }
    }

    /** Holds the compiled schema, which is immutable and serves any thread. */
    private static final class Compiled {
        static final Schema SCHEMA = StrictXml.schema(RunXmlReader.class.getResource("/troupe/run/run.xsd"));
    }

    private static String plain(Exception e) {
        return oneLine(
                XmlMistakes.of(XmlMistakes.bare(String.valueOf(e.getMessage()))).message());
    }

    static String oneLine(String text) {
        String line = text.replaceAll("\\p{Cntrl}+", " ").trim();
        return line.length() > 200 ? line.substring(0, 200) + "…" : line;
    }

    private RunManifest manifest() {
        return new RunManifest(
                program, task, seed, settings, outcome, report, sceneHash, rate, count, digest, channels, parts, legs,
                inputs);
    }

    @Override
    public void setDocumentLocator(Locator given) {
        locator = given;
    }

    @Override
    public void error(SAXParseException e) throws SAXException {
        throw e;
    }

    @Override
    public void startElement(String uri, String name, String qualified, Attributes attributes) throws SAXException {
        switch (name) {
            case "run" -> run(attributes);
            case "setting" -> settings.put(attributes.getValue("key"), attributes.getValue("value"));
            case "outcome" -> outcome(attributes);
            case "report" -> open(attributes, new Level(attributes.getValue("name"), Report.builder(), null));
            case "list" -> open(attributes, new Level(attributes.getValue("name"), null, new ArrayList<>()));
            case "text" -> value(attributes, attributes.getValue("value"));
            case "truth" -> value(attributes, attributes.getValue("value").equals("true"));
            case "whole" -> value(attributes, whole(attributes, "value"));
            case "number" -> value(attributes, number(attributes, "value"));
            case "scene" -> sceneHash = attributes.getValue("sha256");
            case "frames" -> frames(attributes);
            case "channel" -> channels.add(channel(attributes));
            case "part" -> parts.add(attributes.getValue("sha256"));
            case "leg" -> legs.add(leg(attributes));
            case "input" ->
                inputs.add(new Run.Input(
                        whole(attributes, "step"), attributes.getValue("key"), number(attributes, "value")));
            default -> throw at("unknown element " + name);
        }
    }

    @Override
    public void endElement(String uri, String name, String qualified) throws SAXException {
        if (!name.equals("report") && !name.equals("list")) {
            return;
        }
        Level level = levels.pop();
        Object value = level.list() != null ? level.list() : level.report().build();
        if (levels.isEmpty()) {
            report = (Report) value;
        } else {
            put(level.name(), value);
        }
    }

    private void run(Attributes a) throws SAXException {
        String version = a.getValue("version");
        if (!version.equals(RunManifest.VERSION)) {
            throw at("format version " + version + "; this program reads version " + RunManifest.VERSION);
        }
        program = a.getValue("program");
        task = a.getValue("task");
        seed = whole(a, "seed");
    }

    private void outcome(Attributes a) throws SAXException {
        String reason = a.getValue("reason");
        outcome = switch (a.getValue("word")) {
            case "found" -> Outcome.FOUND;
            case "infeasible" -> new Outcome.Infeasible(reason == null ? "" : reason);
            case "exhausted" -> Outcome.EXHAUSTED;
            case "cancelled" -> Outcome.CANCELLED;
            default -> Outcome.RUNNING;
        };
    }

    private void frames(Attributes a) throws SAXException {
        rate = number(a, "rate");
        count = (int) whole(a, "count");
        digest = a.getValue("digest");
    }

    private Channel channel(Attributes a) throws SAXException {
        return new Channel(
                a.getValue("name"),
                a.getValue("unit"),
                Channel.Type.valueOf(a.getValue("type")),
                a.getValue("owner"),
                (int) whole(a, "width"));
    }

    private Run.Leg leg(Attributes a) throws SAXException {
        List<double[]> points = new ArrayList<>();
        String text = a.getValue("points");
        if (!text.isEmpty()) {
            for (String triple : text.split(" ", -1)) {
                points.add(point(triple));
            }
        }
        return new Run.Leg(
                a.getValue("actor"),
                a.getValue("ability"),
                a.getValue("what"),
                number(a, "begin"),
                number(a, "end"),
                number(a, "energy"),
                List.copyOf(points));
    }

    private double[] point(String triple) throws SAXException {
        String[] numbers = triple.split(",", -1);
        if (numbers.length != 3) {
            throw at("point '" + triple + "' of a leg; needs x,y,z");
        }
        return new double[] {finite(numbers[0]), finite(numbers[1]), finite(numbers[2])};
    }

    private void open(Attributes attributes, Level level) throws SAXException {
        if (levels.size() == MAX_DEPTH) {
            throw at("report nested deeper than " + MAX_DEPTH);
        }
        if (!levels.isEmpty()) {
            checkName(attributes);
        }
        levels.push(level);
    }

    private void value(Attributes attributes, Object value) throws SAXException {
        checkName(attributes);
        put(attributes.getValue("name"), value);
    }

    private void checkName(Attributes attributes) throws SAXException {
        boolean named = attributes.getValue("name") != null;
        if (named != (levels.element().report() != null)) {
            throw at(named ? "a name within a list" : "a report value without a name");
        }
    }

    private void put(String name, Object value) throws SAXException {
        Level level = levels.element();
        if (level.list() != null) {
            level.list().add(value);
            return;
        }
        try {
            level.report().put(name, value);
        } catch (IllegalArgumentException e) {
            throw at(e.getMessage());
        }
    }

    private long whole(Attributes a, String name) throws SAXException {
        try {
            return Long.parseLong(a.getValue(name).trim());
        } catch (NumberFormatException e) {
            throw at(name + " '" + a.getValue(name) + "'; needs a whole number");
        }
    }

    private double number(Attributes a, String name) throws SAXException {
        return finite(a.getValue(name));
    }

    private double finite(String text) throws SAXException {
        try {
            double value = Double.parseDouble(text);
            if (Double.isFinite(value)) {
                return value;
            }
        } catch (NumberFormatException e) {
            // told below, like what is not finite
        }
        throw at("'" + text + "'; needs a finite number");
    }

    private SAXParseException at(String message) {
        return new SAXParseException(message, locator);
    }
}
