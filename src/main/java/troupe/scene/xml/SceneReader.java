package troupe.scene.xml;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import javax.xml.validation.Schema;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;
import troupe.geometry.Polygon;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Journey;
import troupe.scene.Numbers;
import troupe.scene.Obstacle;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.World;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.scene.setting.ActorForm;
import troupe.scene.setting.Orderings;

/**
 * Reads one scene file, validated against the schema while it streams. DTDs, entities and external
 * references are refused.
 */
final class SceneReader extends DefaultHandler {
    /** After so many mistakes the rest of a file is not looked at. */
    private static final int MAX_PROBLEMS = 50;

    /** The most elements of a file, abilities and preferences included. */
    private static final int MAX_ELEMENTS = 100_000;

    /** Elements may be nested so deep: groups of a crowd lie in each other. */
    private static final int MAX_DEPTH = 64;

    /** The most corners of all polygons of a file together. */
    private static final int MAX_CORNERS = 500_000;

    private static final Schema SCHEMA = StrictXml.schema(SceneReader.class.getResource("/troupe/scene/scene.xsd"));

    private static final Pattern FACET = Pattern.compile("^cvc-(pattern|enumeration|datatype|.*clusive)-valid");

    private final String name;
    private final List<Problem> problems = new ArrayList<>();
    private final Map<String, Integer> lines = new HashMap<>();
    private final List<Obstacle> obstacles = new ArrayList<>();
    private final List<Ditch> ditches = new ArrayList<>();
    private final List<Actor> actors = new ArrayList<>();
    private final List<Task> tasks = new ArrayList<>();
    private Locator locator;
    private String facet = "";
    private int elements;
    private int depth;
    private int corners;
    private String title = "";
    private World world;
    private ActorForm form;
    private Names actorNames;
    private Journey journey;
    private EncounterForm encounter;
    private final Optional<Path> folder;
    private CrowdXml crowd;

    /** Makes a reader; files beside the scene are looked for in {@code folder}, if there is one. */
    SceneReader(String name, Optional<Path> folder) {
        this.name = name;
        this.folder = folder;
    }

    /** Tells that an attribute is missing that the validator has already missed. */
    private static final class MissingAttributeException extends IllegalArgumentException {
        MissingAttributeException(String attribute) {
            super(attribute);
        }
    }

    private record Names(String id, String label, String colour) {}

    SceneSource read(byte[] bytes) throws SceneException, IOException {
        try {
            StrictXml.parse(bytes, Optional.of(SCHEMA), this);
        } catch (SAXParseException e) {
            if (problems.isEmpty()) {
                fatal(e.getLineNumber(), e.getColumnNumber(), e);
            }
        } catch (SAXException | IOException e) {
            // malformed UTF-8 comes as an IOException of the decoder; the bytes themselves are in memory
            boolean placed = locator != null && locator.getLineNumber() > 0;
            fatal(placed ? locator.getLineNumber() : 1, placed ? locator.getColumnNumber() : 1, e);
        }
        if (!problems.isEmpty()) {
            throw new SceneException(name, problems);
        }
        return new SceneSource(new Scene(title, world, obstacles, ditches, actors, tasks), lines);
    }

    /** Returns the text of an error on one line, without codes and namespaces, long values cut. */
    private static String message(Exception e) {
        String text = e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
        return XmlMistakes.bare(text)
                .replaceAll("\\{?\"" + SceneXml.NAMESPACE + "\":([\\w.-]+)\\}?", "$1")
                .replaceAll("'([^'\\s]{40})[^'\\s]+'", "'$1…'")
                .replaceAll("\\s+", " ");
    }

    private void problem(int line, int column, String element, String message, String cure) {
        String place = column > 0 ? "column " + column + ": " : "";
        problems.add(new Problem(Severity.ERROR, element, Math.max(line, 0), place + message, cure));
    }

    private void fatal(int line, int column, Exception e) {
        XmlMistakes.Mistake mistake = XmlMistakes.of(message(e));
        problem(Math.max(line, 1), Math.max(column, 1), "", mistake.message(), mistake.cure());
    }

    @Override
    public void setDocumentLocator(Locator given) {
        locator = given;
    }

    @Override
    public void error(SAXParseException e) throws SAXException {
        if (FACET.matcher(e.getMessage()).find()) {
            // the validator says first what is wrong with the value, then of which attribute
            facet = " " + message(e);
            return;
        }
        XmlMistakes.Mistake mistake = XmlMistakes.of(message(e) + facet);
        problem(e.getLineNumber(), e.getColumnNumber(), "", mistake.message(), mistake.cure());
        facet = "";
        if (problems.size() >= MAX_PROBLEMS) {
            throw e;
        }
    }

    @Override
    public void fatalError(SAXParseException e) throws SAXException {
        fatal(e.getLineNumber(), e.getColumnNumber(), e);
        throw e;
    }

    @Override
    public void startElement(String uri, String element, String qualified, Attributes attributes) throws SAXException {
        if (++elements > MAX_ELEMENTS) {
            throw new SAXException("more than " + MAX_ELEMENTS + " elements; split the scene");
        }
        if (++depth > MAX_DEPTH) {
            throw new SAXException("elements nested more than " + MAX_DEPTH + " deep");
        }
        String id = text(attributes, "id", "");
        if (!id.isEmpty()) {
            lines.putIfAbsent(id, locator.getLineNumber());
        }
        try {
            start(element, id, attributes);
        } catch (MissingAttributeException e) {
            if (problems.isEmpty()) {
                throw new IllegalStateException("the schema lets " + e.getMessage() + " be absent", e);
            }
        } catch (SceneException e) {
            problem(locator.getLineNumber(), locator.getColumnNumber(), id, "<" + element + ">: " + e.getMessage(), "");
        } catch (IllegalArgumentException e) {
            problem(locator.getLineNumber(), locator.getColumnNumber(), id, "<" + element + ">: " + e.getMessage(), "");
        }
        if (corners > MAX_CORNERS) {
            throw new SAXException("more than " + MAX_CORNERS + " corners in all; split the scene");
        }
    }

    private void start(String element, String id, Attributes a) throws SceneException {
        switch (element) {
            case "scene" -> title = text(a, "title", "");
            case "world" -> world = world(a);
            case "obstacle" -> obstacles.add(obstacle(id, a));
            case "ditch" -> ditches.add(new Ditch(id, text(a, "label", ""), outline(a), number(a, "depth", 0)));
            case "actor" -> startActor(id, a);
            case "journey" -> journey = journey(id, a);
            case "prefer" -> prefer(a);
            case "encounter" -> encounter = new EncounterForm(id, a::getValue, folder);
            case "avatar", "head", "track", "tracks" -> meet(element, id, a);
            case "crowd" -> crowd = new CrowdXml(id, a);
            case "weights", "relation", "group" -> crowdPart(element, id, a);
            default -> ability(element, a);
        }
    }

    /** Reads a part of an encounter; of one that could not be read itself nothing is read. */
    private void meet(String element, String id, Attributes a) throws SceneException {
        if (encounter == null) {
            return;
        }
        switch (element) {
            case "avatar" -> encounter.startAvatar(id, a::getValue);
            case "head" -> encounter.head(a::getValue);
            case "track" -> encounter.track(a::getValue);
            default -> encounter.tracks(a::getValue);
        }
    }

    private static World world(Attributes a) {
        World plain = World.of(number(a, "width", 0), number(a, "depth", 0));
        return new World(plain.width(), plain.depth(), number(a, "cell", plain.cell()));
    }

    private Polygon outline(Attributes a) {
        Polygon outline = Numbers.polygon(required(a, "points"));
        corners += outline.size();
        return outline;
    }

    private Obstacle obstacle(String id, Attributes a) {
        return new Obstacle(
                id,
                text(a, "label", ""),
                outline(a),
                number(a, "offset", 0),
                number(a, "height", 0),
                List.of("true", "1").contains(text(a, "movable", "").strip()),
                number(a, "mass", Obstacle.DEFAULT_MASS),
                text(a, "colour", ""));
    }

    private void startActor(String id, Attributes a) {
        actorNames = new Names(id, text(a, "label", ""), text(a, "colour", ""));
        form = ActorForm.bare();
        for (String attribute : ActorForm.BODY) {
            form.setBody(attribute, number(a, attribute, form.body(attribute)));
        }
    }

    private void ability(String element, Attributes a) {
        for (Ability ability : Ability.values()) {
            if (ability.key().equals(element) && form != null) {
                form.add(ability);
                for (String attribute : ActorForm.names(ability)) {
                    if (a.getValue(attribute) != null) {
                        form.set(ability, attribute, number(a, attribute, 0));
                    }
                }
            }
        }
    }

    private static Journey journey(String id, Attributes a) {
        return new Journey(
                id,
                text(a, "label", ""),
                text(a, "actor", ""),
                Numbers.place(required(a, "start")),
                Numbers.place(required(a, "goal")),
                Preferences.NEUTRAL,
                Orderings.ordering(text(a, "ordering", "optimal")),
                word(a, "spread", Journey.Spread.BREADTH),
                word(a, "manipulation", Journey.Manipulation.GRIP),
                (int) whole(a, "headings", Journey.DEFAULT_HEADINGS),
                (int) whole(a, "slice", Journey.DEFAULT_SLICE),
                whole(a, "expansions", Journey.DEFAULT_EXPANSIONS),
                (int) whole(a, "spaces", Journey.DEFAULT_SPACES),
                whole(a, "seed", 1));
    }

    private void crowdPart(String element, String id, Attributes a) {
        if (crowd == null) {
            return;
        }
        switch (element) {
            case "weights" -> crowd.weights(a);
            case "relation" -> crowd.relation(a);
            default -> corners += crowd.startGroup(id, a);
        }
    }

    private void prefer(Attributes a) {
        if (journey == null) {
            return;
        }
        Preferences preferences = journey.preferences();
        for (Ability ability : Ability.values()) {
            String factor = a.getValue(ability.key());
            if (factor != null) {
                preferences = preferences.with(ability, Orderings.factor(factor));
            }
        }
        journey = journey.preferring(preferences);
    }

    @Override
    public void endElement(String uri, String element, String qualified) {
        depth--;
        if (element.equals("actor") && form != null) {
            actors.add(form.actor(actorNames.id(), actorNames.label(), actorNames.colour()));
            form = null;
        } else if (element.equals("journey") && journey != null) {
            tasks.add(journey);
            journey = null;
        } else if (element.equals("avatar") && encounter != null) {
            endAvatar();
        } else if (element.equals("encounter") && encounter != null) {
            tasks.add(encounter.encounter());
            encounter = null;
        } else if (element.equals("group") && crowd != null) {
            crowd.endGroup();
        } else if (element.equals("crowd") && crowd != null) {
            tasks.add(crowd.crowd());
            crowd = null;
        }
    }

    private void endAvatar() {
        try {
            encounter.endAvatar();
        } catch (IllegalArgumentException e) {
            problem(locator.getLineNumber(), locator.getColumnNumber(), "", "<avatar>: " + e.getMessage(), "");
        }
    }

    private static String text(Attributes attributes, String attribute, String absent) {
        String value = attributes.getValue(attribute);
        return value == null ? absent : value;
    }

    /** Returns the constant that an attribute names; the one for absence if it names none, as the validator has told. */
    private static <E extends Enum<E>> E word(Attributes attributes, String attribute, E absent) {
        String value = text(attributes, attribute, "").strip();
        for (E constant : absent.getDeclaringClass().getEnumConstants()) {
            if (constant.name().toLowerCase(Locale.ROOT).equals(value)) {
                return constant;
            }
        }
        return absent;
    }

    private static String required(Attributes attributes, String attribute) {
        String value = attributes.getValue(attribute);
        if (value == null) {
            throw new MissingAttributeException(attribute);
        }
        return value;
    }

    private static double number(Attributes attributes, String attribute, double absent) {
        String value = attributes.getValue(attribute);
        return value == null ? absent : named(attribute, () -> Numbers.number(value));
    }

    private static long whole(Attributes attributes, String attribute, long absent) {
        String value = attributes.getValue(attribute);
        return value == null ? absent : named(attribute, () -> Numbers.whole(value));
    }

    private static <T> T named(String attribute, java.util.function.Supplier<T> reading) {
        try {
            return reading.get();
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(attribute + ": " + e.getMessage(), e);
        }
    }
}
