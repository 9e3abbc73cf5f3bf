package troupe.work.view;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.stream.Stream;
import troupe.exchange.Formats;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.grid.field.Nf2;
import troupe.grid.layer.Layers;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.run.Engine;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.FrameRecorder;
import troupe.run.view.Aspect;
import troupe.run.view.GridOverlays;
import troupe.run.view.Overlay;
import troupe.scene.Actor;
import troupe.scene.Crowd;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.search.Outcome;
import troupe.work.Tasks;

/** Computes the fields of the grid core for one task, stage by stage, as overlays and with their times. */
public final class Fields {
    /** The keys of what the search of a task adds to the grid. */
    private static final List<String> SEARCHED = List.of("effort", "triggers", "expected-path", "instance");

    /** The keys of the goal's potential and what it spreads along. */
    private static final List<String> GUIDES = List.of("skeleton", "potential");

    /** The keys of what can be shown: those of the grid, and what the search of the task adds. */
    public static final List<String> KEYS =
            Stream.concat(GridOverlays.KEYS.stream(), SEARCHED.stream()).toList();

    /** How long a stage took; {@code millis} is wall time. */
    public record Stage(String name, double millis) {}

    /** Tells that a task does not offer what is chosen of its views. */
    public static final class ChoiceException extends IllegalArgumentException {
        ChoiceException(String message) {
            super(message);
        }
    }

    private static final long SLICE = 5_000;

    private final List<List<Overlay>> overlays = new ArrayList<>();
    private final List<Stage> stages = new ArrayList<>();
    private final List<String> missing = new ArrayList<>();
    private final List<Aspect> aspects = new ArrayList<>();
    private final List<Integer> chosen = new ArrayList<>();
    private final BooleanSupplier stopped;

    private Fields(BooleanSupplier stopped) {
        this.stopped = stopped;
    }

    /**
     * Computes what the given keys need, to the end.
     *
     * @param keys some of {@link #KEYS}
     * @throws IllegalArgumentException if the scene lacks the task, or a key is unknown
     */
    public static Fields of(Scene scene, String taskId, List<String> keys) {
        try {
            return of(scene, taskId, keys, Map.of(), () -> false);
        } catch (InterruptedIOException e) {
            throw new IllegalStateException("stopped without being told to", e);
        }
    }

    /**
     * Computes what the given keys need.
     *
     * @param keys some of {@link #KEYS}
     * @param choices of aspects of the task, by key, from 1; those left out are 1. With any, the views of the grid
     *     are those of the choice, too
     * @param stopped tells whether to end early; asked before each stage
     * @throws InterruptedIOException if the work was to end early
     * @throws ChoiceException if the task lacks an aspect or a choice
     * @throws IllegalArgumentException if the scene lacks the task, or a key is unknown
     */
    public static Fields of(
            Scene scene, String taskId, List<String> keys, Map<String, Integer> choices, BooleanSupplier stopped)
            throws InterruptedIOException {
        Task task = scene.task(taskId)
                .orElseThrow(() -> new IllegalArgumentException(
                        "unknown task '" + taskId + "'; the scene has " + Tasks.ids(scene)));
        Fields fields = new Fields(stopped);
        if (task instanceof Journey journey) {
            fields.compute(scene, journey, keys, choices);
        } else if (task instanceof Crowd) {
            fields.crowd(scene, taskId, keys, choices);
        }
        return fields;
    }

    private void compute(Scene scene, Journey journey, List<String> keys, Map<String, Integer> choices)
            throws InterruptedIOException {
        RegionBuilder builder = new RegionBuilder(scene, able(scene, journey));
        Layers layers = timed("layers", builder::layers);
        Region region = timed("region", builder::region);
        Region open = withoutMovables(scene, region);
        int goal = open.locate(journey.goal());
        boolean reachable = goal >= 0 && open.open(goal);
        boolean wanted = choices.isEmpty() && (keys.contains("skeleton") || keys.contains("potential"));
        Nf2 nf2 = wanted && reachable ? timed("nf2", () -> new Nf2(open).compute(goal, journey.spread())) : null;
        GridOverlays grid = new GridOverlays(region, layers);
        GridOverlays guide = open == region ? grid : new GridOverlays(open, layers);
        boolean searched = !choices.isEmpty() || keys.stream().anyMatch(SEARCHED::contains);
        List<Overlay> views = searched ? search(scene, journey, choices) : List.of();
        for (String key : keys) {
            proceed();
            boolean own = SEARCHED.contains(key) || !choices.isEmpty();
            List<Overlay> found = own ? searched(key, views, grid) : (GUIDES.contains(key) ? guide : grid).of(key, nf2);
            proceed();
            if (found.isEmpty()) {
                missing.add(key + ": nothing to show");
            }
            byStorey(found);
        }
    }

    /** Lets the engine of a crowd place everybody, and asks it for its views. */
    private void crowd(Scene scene, String task, List<String> keys, Map<String, Integer> choices)
            throws InterruptedIOException {
        Engine engine = Tasks.start(scene, task);
        Outcome outcome = timed("placing", () -> engine.step(1));
        choose(engine, choices);
        for (String key : keys) {
            List<Overlay> found = timed(key, () -> engine.overlays(chosen, key::equals));
            if (found.isEmpty()) {
                boolean none = outcome instanceof Outcome.Infeasible;
                missing.add(key + ": " + (none ? ((Outcome.Infeasible) outcome).reason() : "nothing to show"));
            }
            byStorey(found);
        }
    }

    /** Returns the region in which the goal's potential is made: without what the actor may move. */
    private static Region withoutMovables(Scene scene, Region region) {
        Region open = region;
        for (int i = 0; i < scene.obstacles().size() && region.actor().move().isPresent(); i++) {
            open = scene.obstacles().get(i).movable() ? open.without(i) : open;
        }
        return open;
    }

    private static List<Overlay> searched(String key, List<Overlay> views, GridOverlays grid) {
        return key.equals("effort")
                ? effort(views, grid)
                : views.stream().filter(o -> o.key().equals(key)).toList();
    }

    private void proceed() throws InterruptedIOException {
        if (stopped.getAsBoolean()) {
            throw new InterruptedIOException("interrupted; nothing was drawn");
        }
    }

    /** Returns the views of the search to its end, of what is chosen. */
    private List<Overlay> search(Scene scene, Journey journey, Map<String, Integer> choices)
            throws InterruptedIOException {
        Engine engine = Tasks.start(scene, journey.id());
        timed("search", () -> {
            while (engine.step(SLICE).isRunning() && !stopped.getAsBoolean()) {
                // the next slice
            }
            return engine;
        });
        proceed();
        choose(engine, choices);
        return engine.overlays(chosen);
    }

    private void choose(Engine engine, Map<String, Integer> choices) {
        Set<String> left = new TreeSet<>(choices.keySet());
        while (chosen.size() < engine.aspects(chosen).size()) {
            Aspect aspect = engine.aspects(chosen).get(chosen.size());
            int count = aspect.choices().size();
            int choice = choices.getOrDefault(aspect.key(), 1);
            if (choice < 1 || choice > count) {
                throw new ChoiceException(aspect.key() + "=" + choice + "; needs 1 to " + count);
            }
            left.remove(aspect.key());
            chosen.add(choice - 1);
            aspects.add(aspect);
        }
        if (!left.isEmpty()) {
            List<String> known = aspects.stream().map(Aspect::key).toList();
            throw new ChoiceException(String.join(", ", left) + "; needs "
                    + (known.isEmpty() ? "a task that offers a choice" : "one of " + String.join(", ", known)));
        }
    }

    /** Returns the effort of a search by storey; a storey in which nothing was searched is left out. */
    private static List<Overlay> effort(List<Overlay> views, GridOverlays grid) {
        Map<Integer, Overlay.Field> storeys = new TreeMap<>();
        for (Overlay overlay : views) {
            if (overlay.key().equals("effort") && overlay instanceof Overlay.Field field && holdsAnything(field)) {
                storeys.merge(grid.storey(field.layer()), field, Fields::together);
            }
        }
        List<Overlay> found = new ArrayList<>();
        storeys.forEach((storey, f) -> found.add(new Overlay.Field(f.key(), storey, f.frame(), f.values(), f.scale())));
        return found;
    }

    private static boolean holdsAnything(Overlay.Field field) {
        for (float value : field.values()) {
            if (!Float.isNaN(value)) {
                return true;
            }
        }
        return false;
    }

    /** Joins the fields of two layers of one storey: layers that do not lie over each other. */
    private static Overlay.Field together(Overlay.Field below, Overlay.Field above) {
        float[] values = below.values().clone();
        for (int i = 0; i < values.length; i++) {
            values[i] = Float.isNaN(above.values()[i]) ? values[i] : above.values()[i];
        }
        return new Overlay.Field(below.key(), below.layer(), below.frame(), values, below.scale());
    }

    private void byStorey(List<Overlay> found) {
        Map<Integer, List<Overlay>> sorted = new TreeMap<>();
        found.forEach(
                o -> sorted.computeIfAbsent(o.layer(), k -> new ArrayList<>()).add(o));
        overlays.addAll(sorted.values());
    }

    /** Returns the actor of a journey without the abilities that its preferences switch off. */
    public static Actor able(Scene scene, Journey journey) {
        Actor actor = scene.actor(journey.actor())
                .orElseThrow(() -> new IllegalArgumentException(
                        "journey '" + journey.id() + "' names the unknown actor '" + journey.actor() + "'"));
        return actor.under(journey.preferences());
    }

    private <T> T timed(String name, Supplier<T> work) throws InterruptedIOException {
        proceed();
        long begin = System.nanoTime();
        T result = work.get();
        stages.add(new Stage(name, (System.nanoTime() - begin) * 1e-6));
        return result;
    }

    /** Returns the overlays, those of one key and storey together, in the order asked for. */
    public List<List<Overlay>> overlays() {
        return List.copyOf(overlays);
    }

    /** Returns the times of the stages that were needed. */
    public List<Stage> stages() {
        return List.copyOf(stages);
    }

    /** Returns what could be chosen of the views of the search; none if it was not needed or offers nothing. */
    public List<Aspect> aspects() {
        return List.copyOf(aspects);
    }

    /** Returns what was chosen of each aspect, from 0. */
    public List<Integer> chosen() {
        return List.copyOf(chosen);
    }

    /** Returns a line for each key that has nothing to show. */
    public List<String> missing() {
        return List.copyOf(missing);
    }

    /**
     * Draws overlays over a scene as a PNG file.
     *
     * @param task the task whose start and goal are shown
     * @param width pixels
     */
    public static void draw(Scene scene, String task, List<Overlay> shown, int width, Path file)
            throws IOException, ExchangeException {
        Run blank = new Run(
                scene,
                task,
                Outcome.RUNNING,
                Report.builder().build(),
                new FrameRecorder(1, List.of()).frames(),
                List.of(),
                List.of());
        ExportSettings settings = ExportSettings.DEFAULT.wide(width).with(shown);
        Formats.exporter("png").write(blank, settings, file);
    }
}
