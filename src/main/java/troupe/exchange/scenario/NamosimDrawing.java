package troupe.exchange.scenario;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;
import troupe.exchange.format.ExchangeException;
import troupe.scene.xml.StrictXml;
import troupe.scene.xml.XmlMistakes;

/**
 * Reads the parts of an SVG drawing that NAMOSIM looks at, in the order of the file: its size, its typed
 * paths, its groups and its {@code namo_config}. Elements are known by their local names, so that any prefix
 * does; attributes with a prefix belong to other programs. What is in {@code defs} is not drawn and not read.
 * DTDs, entities and external references are refused. Used once, by one thread.
 */
final class NamosimDrawing extends DefaultHandler {
    private static final int MAX_ELEMENTS = 100_000;
    private static final int MAX_DEPTH = 64;
    private static final String NOT_UTF = "the file is not UTF-8 text";
    private static final String SAVE_AS_UTF = "save it as UTF-8";
    /** What to do about a scene file does not help with a drawing. */
    private static final Pattern OF_SCENES = Pattern.compile("\\bscene\\b|\\btroupe\\b");

    private static final Pattern LONG_NAME = Pattern.compile("([^\\s<>\"=/;&]{40})[^\\s<>\"=/;&]+");

    private static final Set<String> OTHER_SHAPES =
            Set.of("rect", "circle", "ellipse", "line", "polyline", "polygon", "use", "text", "image");

    private final String name;
    private final Deque<Open> open = new ArrayDeque<>();
    private final List<Figure> figures = new ArrayList<>();
    private final Map<String, Figure> paths = new HashMap<>();
    private final Map<String, Figure> shapesByGroup = new HashMap<>();
    private final List<Goal> goals = new ArrayList<>();
    private Locator locator;
    private int elements;
    private int hidden;
    private String agent = "";
    private String viewBox = "";
    private String cellSize = "";
    private String margin = "";

    private NamosimDrawing(String name) {
        this.name = name;
    }

    /** An element that has begun: its id if it is a group, else nothing, and whether it or one around it is transformed. */
    private record Open(String tag, String group, boolean transformed) {}

    /** A path, or another shape with a type that only paths may have. */
    record Figure(String tag, String id, String type, String d, int line, boolean transformed) {}

    /** A goal that the configuration gives to an agent. */
    record Goal(String agent, String goal, int line) {}

    /**
     * Reads a drawing.
     *
     * @throws ExchangeException if it is no well-formed XML, no SVG, or too large
     */
    static NamosimDrawing read(byte[] bytes, String name) throws ExchangeException {
        NamosimDrawing drawing = new NamosimDrawing(name);
        try {
            StrictXml.parse(bytes, Optional.empty(), drawing);
        } catch (SAXParseException e) {
            XmlMistakes.Mistake mistake = mistake(e);
            throw new ExchangeException(
                    name, e.getLineNumber(), e.getColumnNumber(), mistake.message(), mistake.cure());
        } catch (SAXException e) {
            XmlMistakes.Mistake mistake = mistake(e);
            throw e.getException() instanceof ExchangeException own
                    ? own
                    : drawing.wrong(mistake.message(), mistake.cure());
        } catch (IOException e) {
            // the bytes are in memory: only malformed characters come as an IOException
            throw drawing.wrong(NOT_UTF, SAVE_AS_UTF);
        }
        return drawing;
    }

    /** Says what the parser found in words that can be told in other languages, and what to do. */
    private static XmlMistakes.Mistake mistake(SAXException e) {
        String said = String.valueOf(e.getMessage());
        if (said.startsWith("DOCTYPE ")) {
            return new XmlMistakes.Mistake("the drawing has a DOCTYPE", "take the document type out");
        }
        XmlMistakes.Mistake mistake = XmlMistakes.of(said);
        if (mistake.message().equals(NOT_UTF)) {
            return new XmlMistakes.Mistake(NOT_UTF, SAVE_AS_UTF);
        }
        boolean foreign =
                mistake.cure().isEmpty() || OF_SCENES.matcher(mistake.cure()).find();
        String cure = foreign ? "give a whole SVG file" : mistake.cure();
        if (mistake.message().equals(said)) {
            return new XmlMistakes.Mistake("the XML cannot be read", cure);
        }
        String message = mistake.message().replace("</scene>", "</svg>");
        return new XmlMistakes.Mistake(withoutLongNames(message), withoutLongNames(cure));
    }

    private static String withoutLongNames(String text) {
        return LONG_NAME.matcher(text).replaceAll("$1…");
    }

    private ExchangeException wrong(String wrong, String cure) {
        return new ExchangeException(name, locator == null ? 0 : Math.max(0, locator.getLineNumber()), 0, wrong, cure);
    }

    /** Returns the text of the root's {@code viewBox}, empty if it has none. */
    String viewBox() {
        return viewBox;
    }

    /** Returns the text of {@code cell_size_cm}, empty if there is none. */
    String cellSize() {
        return cellSize;
    }

    /** Returns the text of {@code collision_margin_cm}, empty if there is none. */
    String margin() {
        return margin;
    }

    /** Returns paths and typed shapes in the order of the file. */
    List<Figure> figures() {
        return figures;
    }

    /** Returns the goals in the order of the file. */
    List<Goal> goals() {
        return goals;
    }

    /** Finds the path with an id, or the path of type {@code shape} in the group with that id; null if there is none. */
    Figure shape(String id) {
        Figure path = paths.get(id);
        return path == null ? shapesByGroup.get(id) : path;
    }

    @Override
    public void setDocumentLocator(Locator given) {
        locator = given;
    }

    @Override
    public void startElement(String uri, String tag, String qualified, Attributes attributes) throws SAXException {
        if (open.isEmpty() && !tag.equals("svg")) {
            throw new SAXException(
                    wrong("the file begins with <" + shortened(tag) + ">", "give an SVG drawing of NAMOSIM"));
        }
        if (++elements > MAX_ELEMENTS) {
            throw new SAXException(wrong("more than " + MAX_ELEMENTS + " elements", "give a simpler drawing"));
        }
        if (open.size() == MAX_DEPTH) {
            throw new SAXException(wrong("elements nested more than " + MAX_DEPTH + " deep", "give a simpler drawing"));
        }
        boolean outside = !open.isEmpty() && open.peek().transformed();
        boolean transformed = outside || !value(attributes, "transform").isBlank();
        open.push(new Open(tag, tag.equals("g") ? value(attributes, "id") : "", transformed));
        hidden += tag.equals("defs") ? 1 : 0;
        if (hidden == 0) {
            element(tag, attributes, transformed);
        }
    }

    private void element(String tag, Attributes attributes, boolean transformed) {
        switch (tag) {
            case "svg" -> viewBox = open.size() == 1 ? value(attributes, "viewBox") : viewBox;
            case "namo_config" -> {
                cellSize = value(attributes, "cell_size_cm");
                margin = value(attributes, "collision_margin_cm");
            }
            case "agent" -> agent = value(attributes, "agent_id");
            case "goal" -> goals.add(new Goal(agent, value(attributes, "goal_id"), locator.getLineNumber()));
            case "path" -> path(attributes, transformed);
            default -> {
                if (OTHER_SHAPES.contains(tag) && !value(attributes, "type").isEmpty()) {
                    figures.add(figure(tag, attributes, transformed));
                }
            }
        }
    }

    private void path(Attributes attributes, boolean transformed) {
        Figure figure = figure("path", attributes, transformed);
        figures.add(figure);
        paths.putIfAbsent(figure.id(), figure);
        if (figure.type().equals("shape")) {
            for (Open around : open) {
                if (!around.group().isEmpty()) {
                    shapesByGroup.putIfAbsent(around.group(), figure);
                }
            }
        }
    }

    private Figure figure(String tag, Attributes attributes, boolean transformed) {
        return new Figure(
                tag,
                value(attributes, "id"),
                value(attributes, "type"),
                value(attributes, "d"),
                locator.getLineNumber(),
                transformed);
    }

    private static String value(Attributes attributes, String attribute) {
        String value = attributes.getValue("", attribute);
        return value == null ? "" : value;
    }

    private static String shortened(String text) {
        return text.length() > 40 ? text.substring(0, 40) + "…" : text;
    }

    @Override
    public void endElement(String uri, String tag, String qualified) {
        hidden -= open.pop().tag().equals("defs") ? 1 : 0;
        agent = tag.equals("agent") ? "" : agent;
    }

    @Override
    public void error(SAXParseException e) throws SAXException {
        throw e;
    }
}
