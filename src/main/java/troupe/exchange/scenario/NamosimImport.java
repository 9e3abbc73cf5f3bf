package troupe.exchange.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.Importer;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.World;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;
import troupe.scene.check.Severity;

/**
 * Reads a scene of navigation among movable obstacles from an SVG drawing of NAMOSIM: centimetres in units
 * of the {@code viewBox}, y down. Paths of type {@code wall} become obstacles of {@value #WALL_HEIGHT} m, those
 * of type {@code movable} movable ones of {@value #MOVABLE_HEIGHT} m and {@value #MOVABLE_MASS} kg; each agent of {@code namo_config} becomes an
 * actor that walks and moves things, the disc about its centroid that encloses its shape at any heading, grown
 * by {@code collision_margin_cm} where that is given; each of its goals becomes a journey from where it
 * stands. Attributes with a prefix are not read, as NAMOSIM does not.
 *
 * <p>Source: NAMOSIM (Chroma-CITI), the drawings of its scenarios. Deviations: curves are flattened, and a
 * robot or goal may be a group. Cost O(file + corners).
 */
public final class NamosimImport implements Importer {
    static final double WALL_HEIGHT = 3;
    static final double MOVABLE_HEIGHT = 0.8;
    /** Heavy enough that a detour of a few metres costs less than to push, as its planners have it. */
    static final double MOVABLE_MASS = 100;

    static final double BODY_HEIGHT = 1;
    static final double STEP_HEIGHT = 0.05;
    private static final double FOOT_RADIUS = 0.1;
    private static final double CENTIMETRES = 100;
    private static final int MAX_BYTES = 16 << 20;

    /** Makes the importer. */
    public NamosimImport() {}

    /** The most corners of all outlines of a drawing together, as many as a scene file may have. */
    private static final int MAX_CORNERS = 500_000;

    private static final Set<String> TYPES = Set.of("", "wall", "movable", "shape", "orientation");

    @Override
    public String name() {
        return "namosim";
    }

    @Override
    public String extension() {
        return "svg";
    }

    @Override
    public String about() {
        return "NAMOSIM drawing: walls, movable things, robots that walk and move, a journey for each goal";
    }

    @Override
    public Scene read(Path file) throws IOException, ExchangeException {
        try (InputStream in = Files.newInputStream(file)) {
            return read(in, String.valueOf(file.getFileName()));
        }
    }

    /** Reads a drawing from a stream, which stays open; {@code name} names it in messages and in the scene. */
    static Scene read(InputStream in, String name) throws IOException, ExchangeException {
        byte[] bytes = in.readNBytes(MAX_BYTES + 1);
        if (bytes.length > MAX_BYTES) {
            throw new ExchangeException(name, 0, 0, "more than " + MAX_BYTES + " bytes", "give a smaller file");
        }
        return new Reading(name, NamosimDrawing.read(bytes, name)).scene();
    }

    /** Turns one drawing into a scene. */
    private static final class Reading {
        private final String name;
        private final NamosimDrawing drawing;
        private final double minX;
        private final double maxY;
        private final World world;
        private final double margin;
        private final Map<String, Integer> lines = new HashMap<>();
        private final Map<String, Polygon> shapes = new HashMap<>();
        private int corners;

        Reading(String name, NamosimDrawing drawing) throws ExchangeException {
            this.name = name;
            this.drawing = drawing;
            double[] box = viewBox(drawing.viewBox());
            this.minX = box[0];
            this.maxY = box[1] + box[3];
            double width = box[2] / CENTIMETRES;
            double depth = box[3] / CENTIMETRES;
            this.world = drawing.cellSize().isEmpty()
                    ? World.of(width, depth)
                    : new World(width, depth, number(drawing.cellSize(), "cell_size_cm") / CENTIMETRES);
            this.margin =
                    drawing.margin().isEmpty() ? 0 : number(drawing.margin(), "collision_margin_cm") / CENTIMETRES;
        }

        private double[] viewBox(String text) throws ExchangeException {
            String[] words = text.strip().split("[\\s,]+");
            if (words.length != 4) {
                throw new ExchangeException(
                        name,
                        0,
                        0,
                        "viewBox is " + ExchangeException.quoted(text),
                        "give viewBox='0 0 WIDTH HEIGHT' in centimetres");
            }
            double[] box = new double[4];
            for (int i = 0; i < box.length; i++) {
                box[i] = number(words[i], "viewBox");
            }
            return box;
        }

        private double number(String text, String attribute) throws ExchangeException {
            try {
                double value = Double.parseDouble(text);
                if (Double.isFinite(value) && (value >= 0 || attribute.equals("viewBox"))) {
                    return value;
                }
            } catch (NumberFormatException e) {
                throw notANumber(text, attribute);
            }
            throw notANumber(text, attribute);
        }

        private ExchangeException notANumber(String text, String attribute) {
            return new ExchangeException(
                    name,
                    0,
                    0,
                    attribute + " is " + ExchangeException.quoted(text),
                    "give a number" + (attribute.equals("viewBox") ? "" : " from 0"));
        }

        Scene scene() throws ExchangeException {
            List<Obstacle> obstacles = new ArrayList<>();
            for (NamosimDrawing.Figure figure : drawing.figures()) {
                if (!TYPES.contains(figure.type())) {
                    throw wrong(
                            figure,
                            "type is " + ExchangeException.quoted(figure.type()),
                            "known are wall, movable, shape, orientation");
                }
                boolean movable = figure.type().equals("movable");
                if (movable || figure.type().equals("wall")) {
                    double height = movable ? MOVABLE_HEIGHT : WALL_HEIGHT;
                    double mass = movable ? MOVABLE_MASS : Obstacle.DEFAULT_MASS;
                    lines.putIfAbsent(figure.id(), figure.line());
                    obstacles.add(new Obstacle(figure.id(), "", outline(figure), 0, height, movable, mass, ""));
                }
            }
            Map<String, Actor> actors = new LinkedHashMap<>();
            List<Task> journeys = journeys(actors);
            return checked(new Scene(name, world, obstacles, List.of(), new ArrayList<>(actors.values()), journeys));
        }

        /** Makes a journey for each goal, and puts down the actors that they are for. */
        private List<Task> journeys(Map<String, Actor> actors) throws ExchangeException {
            if (drawing.goals().isEmpty()) {
                throw new ExchangeException(
                        name,
                        0,
                        0,
                        "no <goal> of an <agent> in a <namo_config>",
                        "name the robot and where it goes by the ids of their paths");
            }
            boolean several = drawing.goals().stream()
                            .map(NamosimDrawing.Goal::agent)
                            .distinct()
                            .count()
                    > 1;
            List<Task> journeys = new ArrayList<>();
            for (NamosimDrawing.Goal goal : drawing.goals()) {
                Polygon robot = shape(goal.agent(), "agent_id", goal.line());
                Point start = robot.centroid();
                Point end = shape(goal.goal(), "goal_id", goal.line()).centroid();
                actors.putIfAbsent(goal.agent(), robot(goal.agent(), robot, start));
                lines.putIfAbsent(goal.agent(), goal.line());
                String id = several ? goal.agent() + "-" + goal.goal() : goal.goal();
                lines.putIfAbsent(id, goal.line());
                journeys.add(Journey.of(id, goal.agent(), Place.of(start.x(), start.y()), Place.of(end.x(), end.y())));
            }
            return journeys;
        }

        /** Returns the outline of a robot or a goal. */
        private Polygon shape(String id, String attribute, int line) throws ExchangeException {
            Polygon known = shapes.get(id);
            if (known != null) {
                return known;
            }
            NamosimDrawing.Figure figure = drawing.shape(id);
            if (figure == null) {
                throw new ExchangeException(
                        name,
                        line,
                        0,
                        attribute + " is " + ExchangeException.quoted(id)
                                + ", and no path or group with a shape has that id",
                        "give it the id of one");
            }
            Polygon outline = outline(figure);
            if (outline.size() < 3) {
                throw wrong(figure, "the polygon has " + outline.size() + " corners", "give it at least 3");
            }
            shapes.put(id, outline);
            return outline;
        }

        private Actor robot(String id, Polygon shape, Point centre) {
            double radius = 0;
            for (int i = 0; i < shape.size(); i++) {
                double dx = shape.x(i) - centre.x();
                double dy = shape.y(i) - centre.y();
                radius = Math.max(radius, Math.sqrt(dx * dx + dy * dy));
            }
            Actor.Walk walk = Actor.Walk.DEFAULT;
            return new Actor(
                    id,
                    "",
                    "",
                    BODY_HEIGHT,
                    Math.min(FOOT_RADIUS, radius),
                    STEP_HEIGHT,
                    Actor.standard(id).maxBorder(),
                    new Actor.Walk(radius + margin, walk.energy(), walk.speed()),
                    Optional.empty(),
                    Optional.empty(),
                    Optional.empty(),
                    Optional.of(Actor.Move.DEFAULT));
        }

        /** Returns the outline of a figure in metres, y up, in the order of its corners. */
        private Polygon outline(NamosimDrawing.Figure figure) throws ExchangeException {
            if (!figure.tag().equals("path")) {
                throw wrong(figure, "<" + figure.tag() + "> is no path", "make a path of it");
            }
            if (figure.transformed()) {
                throw wrong(
                        figure,
                        "it is transformed, or a group around it is",
                        "apply the transform to the path's numbers");
            }
            double[] outline = PathData.read(figure.d(), (wrong, cure) -> wrong(figure, wrong, cure));
            corners += outline.length / 2;
            if (corners > MAX_CORNERS) {
                throw wrong(figure, "more than " + MAX_CORNERS + " corners in all", "give a simpler drawing");
            }
            for (int i = 0; i < outline.length; i += 2) {
                outline[i] = (outline[i] - minX) / CENTIMETRES;
                outline[i + 1] = (maxY - outline[i + 1]) / CENTIMETRES;
            }
            return Polygon.of(outline);
        }

        private ExchangeException wrong(NamosimDrawing.Figure figure, String wrong, String cure) {
            return new ExchangeException(
                    name, figure.line(), 0, ExchangeException.quoted(figure.id()) + ": " + wrong, cure);
        }

        /** Returns the scene if no check finds an error in it. */
        private Scene checked(Scene scene) throws ExchangeException {
            Optional<Problem> error = SceneChecks.check(scene, lines).stream()
                    .filter(p -> p.severity() == Severity.ERROR)
                    .findFirst();
            if (error.isPresent()) {
                Problem p = error.get();
                throw new ExchangeException(
                        name,
                        p.line(),
                        0,
                        (p.element().isEmpty() ? "" : ExchangeException.quoted(p.element()) + ": ") + p.message(),
                        p.cure());
            }
            return scene;
        }
    }
}
