package troupe.work;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Stream;
import troupe.exchange.ExchangeException;
import troupe.exchange.ExportSettings;
import troupe.exchange.Formats;
import troupe.grid.field.Nf2;
import troupe.grid.layer.Layers;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.run.Engine;
import troupe.run.FrameRecorder;
import troupe.run.GridOverlays;
import troupe.run.Overlay;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.search.Outcome;

/** Computes the fields of the grid core for one task, stage by stage, as overlays and with their times. */
public final class Fields {
    /** The keys of what can be shown: those of the grid, and what the search of the task adds. */
    public static final List<String> KEYS =
            Stream.concat(GridOverlays.KEYS.stream(), Stream.of("effort")).toList();

    /** How long a stage took; {@code millis} is wall time. */
    public record Stage(String name, double millis) {}

    private final List<List<Overlay>> overlays = new ArrayList<>();
    private final List<Stage> stages = new ArrayList<>();
    private final List<String> missing = new ArrayList<>();

    private Fields() {}

    /**
     * Computes what the given keys need.
     *
     * @param keys some of {@link #KEYS}
     * @throws IllegalArgumentException if the scene lacks the task, or a key is unknown
     */
    public static Fields of(Scene scene, String taskId, List<String> keys) {
        Task task = scene.task(taskId)
                .orElseThrow(() -> new IllegalArgumentException(
                        "unknown task '" + taskId + "'; the scene has " + Tasks.ids(scene)));
        Fields fields = new Fields();
        if (task instanceof Journey journey) {
            fields.compute(scene, journey, keys);
        }
        return fields;
    }

    private void compute(Scene scene, Journey journey, List<String> keys) {
        RegionBuilder builder = new RegionBuilder(scene, able(scene, journey));
        Layers layers = timed("layers", builder::layers);
        Region region = timed("region", builder::region);
        int goal = region.locate(journey.goal());
        boolean reachable = goal >= 0 && region.open(goal);
        boolean wanted = keys.contains("skeleton") || keys.contains("potential");
        Nf2 nf2 = wanted && reachable ? timed("nf2", () -> new Nf2(region).compute(goal, journey.spread())) : null;
        GridOverlays grid = new GridOverlays(region, layers);
        for (String key : keys) {
            List<Overlay> found = key.equals("effort") ? effort(scene, journey) : grid.of(key, nf2);
            if (found.isEmpty()) {
                missing.add(key + ": nothing to show");
            }
            byStorey(found);
        }
    }

    private List<Overlay> effort(Scene scene, Journey journey) {
        Engine engine = Tasks.start(scene, journey.id());
        timed("search", engine::finish);
        return engine.overlays().stream().filter(o -> o.key().equals("effort")).toList();
    }

    private void byStorey(List<Overlay> found) {
        Map<Integer, List<Overlay>> sorted = new TreeMap<>();
        found.forEach(
                o -> sorted.computeIfAbsent(o.layer(), k -> new ArrayList<>()).add(o));
        overlays.addAll(sorted.values());
    }

    /** Returns the actor of a journey without the abilities that its preferences switch off. */
    static Actor able(Scene scene, Journey journey) {
        Actor actor = scene.actor(journey.actor())
                .orElseThrow(() -> new IllegalArgumentException(
                        "journey '" + journey.id() + "' names the unknown actor '" + journey.actor() + "'"));
        return actor.under(journey.preferences());
    }

    private <T> T timed(String name, Supplier<T> work) {
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
