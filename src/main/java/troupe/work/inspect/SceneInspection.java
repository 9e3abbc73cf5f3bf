package troupe.work.inspect;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import troupe.grid.GridLimitException;
import troupe.grid.region.Region;
import troupe.risk.plan.Ground;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Crowd;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;
import troupe.scene.check.Severity;
import troupe.scene.xml.SceneSource;
import troupe.unified.obstacle.Movable;
import troupe.unified.obstacle.Surroundings;
import troupe.work.view.Fields;

/**
 * Checks a scene as a whole: what {@link SceneChecks} finds, and, where that leaves no error, what needs the
 * grid: a start or a goal that stands in an obstacle, or that no layer carries. A goal under movable obstacles is
 * fine where the actor of the journey may move them. Of an encounter also walls that keep start and goal apart, and
 * as warnings avatars that walk through obstacles or begin where the actor is. Movable obstacles that rest on
 * nothing are warned of. Of a crowd each group whose goal nobody can stand at, that has no room to begin, or no way.
 */
public final class SceneInspection {
    private final Scene scene;
    private final Map<String, Integer> lines;
    private final Map<Actor, Optional<Standing>> regions = new HashMap<>();
    private final Map<Actor, Optional<Standing>> cleared = new HashMap<>();
    private final List<Problem> problems = new ArrayList<>();

    private SceneInspection(Scene scene, Map<String, Integer> lines) {
        this.scene = scene;
        this.lines = lines;
    }

    /** The configurations of an actor in a scene. */
    private record Standing(Scene scene, Region region) {
        /**
         * Finds the first obstacle over a place that reaches into the stretch of a body on a floor: above the
         * step, movables from the floor itself.
         */
        Optional<Obstacle> holding(Place place, double floor, double step, double high) {
            return scene.obstacles().stream()
                    .filter(o -> o.offset() < high && o.top() > (o.movable() ? floor : floor + step))
                    .filter(o -> o.outline().contains(place.x(), place.y()))
                    .findFirst();
        }
    }

    /** What is wrong with a place. */
    record Fault(String message, String cure) {}

    /** Returns all problems, worst first. Cost: one region or two for each actor and set of abilities in use. */
    public static List<Problem> check(SceneSource source) {
        List<Problem> first = SceneChecks.check(source.scene(), source.lines());
        if (first.stream().anyMatch(p -> p.severity() == Severity.ERROR)) {
            return first;
        }
        SceneInspection inspection = new SceneInspection(source.scene(), source.lines());
        for (Task task : source.scene().tasks()) {
            if (task instanceof Journey journey) {
                inspection.journey(journey);
            } else if (task instanceof Encounter encounter) {
                inspection.encounter(encounter);
            } else if (task instanceof Crowd crowd) {
                inspection.crowd(crowd);
            }
        }
        inspection.movables();
        if (source.scene().tasks().isEmpty()) {
            inspection.problems.add(new Problem(
                    Severity.WARNING,
                    "",
                    0,
                    "the scene has no task, so there is nothing to plan",
                    addTask(source.scene())));
        }
        List<Problem> all = new ArrayList<>(inspection.problems);
        all.addAll(first);
        all.sort(Comparator.comparing(Problem::severity));
        return List.copyOf(all);
    }

    /** Returns what to write into a scene that has no task, so that it can be planned. */
    public static String addTask(Scene scene) {
        String actor =
                scene.actors().isEmpty() ? "ACTOR" : scene.actors().get(0).id();
        return "write <journey id=\"go\" actor=\"" + actor
                + "\" start=\"X,Y\" goal=\"X,Y\"/> before </scene>, places in metres";
    }

    /** Warns of movable obstacles that rest on nothing. */
    private void movables() {
        Surroundings surroundings = new Surroundings(scene);
        for (int n = 0; n < scene.obstacles().size(); n++) {
            Obstacle obstacle = scene.obstacles().get(n);
            if (obstacle.movable()
                    && !surroundings.rests(
                            new Movable(n, obstacle, scene.world().cell(), 1))) {
                problems.add(new Problem(
                        Severity.WARNING,
                        obstacle.id(),
                        lines.getOrDefault(obstacle.id(), 0),
                        "it rests on nothing, so it cannot be moved: its bottom is at " + obstacle.offset() + " m",
                        "put three fifths of it on the ground, or on immovable obstacles of that height, or leave it"
                                + " if that is meant"));
            }
        }
    }

    private void journey(Journey journey) {
        if (!journey.preferences().allows(Ability.WALK)) {
            return;
        }
        Actor actor = Fields.able(scene, journey);
        if (!regions.containsKey(actor)) {
            regions.put(actor, ground(scene, journey, actor));
        }
        regions.get(actor).ifPresent(ground -> {
            fault("start", journey.start(), ground).ifPresent(fault -> report(journey, fault));
            fault("goal", journey.goal(), ground)
                    .flatMap(fault -> lasting(fault, journey, actor))
                    .ifPresent(fault -> report(journey, fault));
        });
    }

    private void encounter(Encounter encounter) {
        Actor actor = scene.actor(encounter.actor()).orElseThrow();
        try {
            Ground ground = new Ground(scene, actor, encounter.goal());
            Region region = ground.region();
            Standing standing = new Standing(scene, region);
            List<Fault> faults = new ArrayList<>();
            fault("start", encounter.start(), standing).ifPresent(faults::add);
            fault("goal", encounter.goal(), standing).ifPresent(faults::add);
            if (faults.isEmpty() && !ground.leads(region.locate(encounter.start()))) {
                double wide = 2 * region.actor().walk().radius() + scene.world().cell();
                faults.add(new Fault(
                        "walls keep the start " + text(encounter.start()) + " and the goal " + text(encounter.goal())
                                + " apart",
                        String.format(Locale.ROOT, "leave a gap of at least %.2f m for the actor", wide)));
            }
            faults.forEach(fault -> report(encounter, fault));
            AvatarInspection.of(scene, encounter, actor)
                    .forEach(p -> problems.add(new Problem(
                            Severity.WARNING,
                            encounter.id(),
                            lines.getOrDefault(encounter.id(), 0),
                            p.message(),
                            p.cure())));
        } catch (GridLimitException tooMuch) {
            report(encounter, new Fault(tooMuch.found(), tooMuch.cure()));
        }
    }

    /** Reports what keeps each group of a crowd from beginning, and what is odd about where it begins. */
    private void crowd(Crowd crowd) {
        try {
            CrowdInspection inspection = CrowdInspection.of(scene, crowd);
            inspection.faults().forEach(fault -> report(crowd, fault));
            int line = lines.getOrDefault(crowd.id(), 0);
            inspection
                    .oddities()
                    .forEach(odd ->
                            problems.add(new Problem(Severity.WARNING, crowd.id(), line, odd.message(), odd.cure())));
        } catch (GridLimitException tooMuch) {
            report(crowd, new Fault(tooMuch.found(), tooMuch.cure()));
        }
    }

    /** Returns what is left of a goal's fault once the actor has moved aside what it can. */
    private Optional<Fault> lasting(Fault fault, Journey journey, Actor actor) {
        if (actor.move().isEmpty() || scene.obstacles().stream().noneMatch(Obstacle::movable)) {
            return Optional.of(fault);
        }
        if (!cleared.containsKey(actor)) {
            Scene emptied = new Scene(
                    scene.title(),
                    scene.world(),
                    scene.obstacles().stream().filter(o -> !o.movable()).toList(),
                    scene.ditches(),
                    scene.actors(),
                    scene.tasks());
            cleared.put(actor, ground(emptied, journey, actor));
        }
        return cleared.get(actor).flatMap(ground -> fault("goal", journey.goal(), ground));
    }

    private Optional<Standing> ground(Scene built, Journey journey, Actor actor) {
        try {
            return Optional.of(new Standing(built, Region.of(built, actor)));
        } catch (GridLimitException tooMuch) {
            report(journey, new Fault(tooMuch.found(), tooMuch.cure()));
            return Optional.empty();
        }
    }

    private static Optional<Fault> fault(String which, Place place, Standing ground) {
        Region region = ground.region();
        String named = "the " + which + " " + text(place);
        String cure = "move the " + which + " to where the actor can stand";
        int q = region.locate(place);
        if (q < 0) {
            return Optional.of(new Fault("no layer carries " + named, cure));
        }
        double floor = region.elevation(q);
        double step = region.actor().stepHeight();
        if (place.z().isPresent() && Math.abs(place.z().getAsDouble() - floor) > step) {
            return Optional.of(new Fault(
                    "no layer carries " + named + "; floors there: " + floors(place, region),
                    "give it the z of one of these floors"));
        }
        if (!region.open(q)) {
            Optional<Obstacle> around =
                    ground.holding(place, floor, step, floor + region.actor().bodyHeight());
            String how = around.map(o -> " is inside obstacle '" + o.id() + "'")
                    .orElse(" leaves actor '" + region.actor().id() + "' no room to stand");
            return Optional.of(new Fault(named + how, cure));
        }
        if (place.z().isEmpty() && floor > step) {
            return ground.holding(place, 0, 0, step)
                    .filter(o -> new Way(region, o).isShut(q))
                    .map(o -> new Fault(
                            named + " is inside obstacle '" + o.id() + "', from whose top no way leads", cure));
        }
        return Optional.empty();
    }

    private static String floors(Place place, Region region) {
        Set<Double> floors = new TreeSet<>();
        int cell = region.frame().cellAt(place.x(), place.y());
        for (int q = cell; q < region.spanCount(); q += region.frame().size()) {
            if (region.spans().exists(q)) {
                floors.add(region.elevation(q));
            }
        }
        return String.join(", ", floors.stream().map(SceneInspection::number).toList());
    }

    private void report(Task task, Fault fault) {
        int line = lines.getOrDefault(task.id(), 0);
        problems.add(new Problem(Severity.ERROR, task.id(), line, fault.message(), fault.cure()));
    }

    static String text(Place place) {
        String xy = "(" + number(place.x()) + ", " + number(place.y());
        return place.z().isPresent() ? xy + ", " + number(place.z().getAsDouble()) + ")" : xy + ")";
    }

    private static String number(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e9
                ? Long.toString((long) value)
                : Double.toString(value);
    }

    /** Looks for a way that leaves the outline of an obstacle. */
    private record Way(Region region, Obstacle obstacle) {

        /** Tells whether every configuration that can be reached from {@code begin} lies over the obstacle. */
        boolean isShut(int begin) {
            BitSet seen = new BitSet(region.size());
            Deque<Integer> open = new ArrayDeque<>(List.of(begin));
            int[] targets = new int[Region.MAX_NEIGHBOURS];
            int[] directions = new int[Region.MAX_NEIGHBOURS];
            while (!open.isEmpty()) {
                int q = open.remove();
                if (!obstacle.outline().contains(region.x(q), region.y(q))) {
                    return false;
                }
                int count = region.neighbours(q, targets, directions);
                for (int i = 0; i < count; i++) {
                    if (!seen.get(targets[i])) {
                        seen.set(targets[i]);
                        open.add(targets[i]);
                    }
                }
            }
            return true;
        }
    }
}
