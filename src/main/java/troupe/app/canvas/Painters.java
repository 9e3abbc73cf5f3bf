package troupe.app.canvas;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.stream.Stream;
import troupe.app.look.Look;
import troupe.app.plan.Plan;
import troupe.app.plan.Views;
import troupe.app.session.OverlayChoice;
import troupe.app.session.RunViews;
import troupe.grid.GridFrame;
import troupe.paint.field.OverlayPainter;
import troupe.paint.motion.RunPainter;
import troupe.paint.picture.Legend;
import troupe.run.Run;
import troupe.run.view.Overlay;
import troupe.scene.Task;
import troupe.work.view.MomentViews;

/**
 * Makes the painters of a plan on a background thread, because tracing the contours of a field takes
 * longer than a frame. Of several requests that wait only the newest is met; what has been made is shown even if a
 * newer request has come since, or a run that grows would never be seen.
 */
final class Painters implements AutoCloseable {

    /** The painters of one plan. Fields of numbers are filled only where they are the one thing shown. */
    record Prepared(Optional<RunPainter> run, List<OverlayPainter> overlays, boolean field, Legend legend) {}

    /** What painters were made of; views are equal only if their list is the same. */
    private record Made(Views views, Set<String> keys, int layer) {
        @Override
        public boolean equals(Object other) {
            return other instanceof Made m
                    && views.overlays() == m.views.overlays()
                    && keys.equals(m.keys)
                    && layer == m.layer;
        }

        @Override
        public int hashCode() {
            return System.identityHashCode(views.overlays());
        }
    }

    private final Look look;
    private final Executor eventThread;
    private final Consumer<Prepared> taker;
    private final ExecutorService worker = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "painters");
        thread.setDaemon(true);
        return thread;
    });
    private volatile long newest;
    private long forgotten;
    private Made made;
    private List<OverlayPainter> painters = List.of();

    /** Makes painters for a look; {@code taker} gets them on the event thread. */
    Painters(Look look, Executor eventThread, Consumer<Prepared> taker) {
        this.look = look;
        this.eventThread = eventThread;
        this.taker = taker;
    }

    /** Drops what is being made, because another scene is shown. */
    void forget() {
        forgotten = newest;
    }

    /** Asks for the painters of what is shown of a plan. */
    void request(Plan plan, OverlayChoice choice) {
        long request = ++newest;
        Set<String> keys = choice.keys();
        int layer = choice.layer();
        Task task = RunViews.task(plan).orElse(null);
        int level = RunViews.level(choice);
        double ahead = RunViews.aheadSeconds(task, choice);
        worker.execute(() -> {
            if (request == newest) {
                List<Overlay> samples = RunViews.keys(plan).stream()
                        .filter(keys::contains)
                        .flatMap(key -> sample(task, key, ahead).stream())
                        .toList();
                Prepared prepared = prepare(plan, keys, layer, samples, level);
                eventThread.execute(() -> {
                    if (request > forgotten) {
                        taker.accept(prepared);
                    }
                });
            }
        });
    }

    /** Returns the painters of views, those of the last time while a run grows under the same ones. */
    private List<OverlayPainter> painters(Made what, List<Overlay> shown, boolean filled) {
        if (!what.equals(made)) {
            made = what;
            painters = shown.stream()
                    .map(o -> new OverlayPainter(o, look.theme(), filled))
                    .toList();
        }
        return painters;
    }

    /** Returns what stands in the legend for a view that is made for each moment. */
    private static Optional<Overlay> sample(Task task, String key, double ahead) {
        if (key.equals(MomentViews.BEFORE) || key.equals(MomentViews.EXPECTED)) {
            return Optional.of(new Overlay.Lines(key, 0, List.of()));
        }
        return MomentViews.scale(task, key, ahead)
                .map(scale -> new Overlay.Field(key, 0, new GridFrame(0, 0, 1, 1, 1), new float[] {Float.NaN}, scale));
    }

    private Prepared prepare(Plan plan, Set<String> keys, int layer, List<Overlay> samples, int level) {
        List<Overlay> shown = plan.overlays().stream()
                .filter(o -> keys.contains(o.key()) && !RunViews.replaces(plan, o.key()))
                .filter(o -> layer == OverlayChoice.ALL_LAYERS || o.layer() == layer)
                .map(o -> leading(plan, o))
                .toList();
        boolean filled = shown.stream().map(Overlay::key).distinct().count() == 1;
        List<OverlayPainter> painters = painters(new Made(plan.views(), keys, layer), shown, filled);
        Optional<Run> run = plan.run().filter(r -> keys.contains(OverlayChoice.PLAN));
        List<Overlay> named = Stream.concat(samples.stream(), shown.stream())
                .map(Overlay::key)
                .distinct()
                .map(key -> merged(Stream.concat(samples.stream(), shown.stream())
                        .filter(o -> o.key().equals(key))
                        .toList()))
                .toList();
        Legend legend = Legend.of(run.orElse(null), named, filled || shown.isEmpty(), look.theme(), this::word);
        boolean field = filled && shown.stream().anyMatch(o -> o instanceof Overlay.Field);
        return new Prepared(
                run.map(r -> new RunPainter(r, look.theme(), level, keys.contains(OverlayChoice.TRAILS))),
                painters,
                field,
                legend);
    }

    /** Returns a view without the lines that lie where no way leads to the goal, such as on the tops of walls. */
    private static Overlay leading(Plan plan, Overlay overlay) {
        if (!(overlay instanceof Overlay.Lines lines)
                || !lines.key().equals("skeleton")
                || plan.overlays().stream().noneMatch(o -> o.key().equals("potential"))) {
            return overlay;
        }
        Optional<Overlay> potential = plan.overlays().stream()
                .filter(o -> o.key().equals("potential") && o.layer() == lines.layer())
                .findFirst();
        List<double[]> leading = lines.lines().stream()
                .filter(line -> potential.isPresent() && leads((Overlay.Field) potential.get(), line))
                .toList();
        return new Overlay.Lines(lines.key(), lines.layer(), leading);
    }

    private static boolean leads(Overlay.Field potential, double[] line) {
        int middle = line.length / 4 * 2;
        int cell = potential.frame().cellAt(line[middle], line[middle + 1]);
        return cell >= 0 && Float.isFinite(potential.values()[cell]);
    }

    /** Returns one view for the legend out of those of several layers: with every word that one of them uses. */
    private static Overlay merged(List<Overlay> layers) {
        if (layers.size() == 1 || !(layers.get(0) instanceof Overlay.Field first)) {
            return layers.get(0);
        }
        int length = layers.stream()
                .mapToInt(o -> ((Overlay.Field) o).values().length)
                .sum();
        float[] values = new float[length];
        int at = 0;
        for (Overlay overlay : layers) {
            float[] part = ((Overlay.Field) overlay).values();
            System.arraycopy(part, 0, values, at, part.length);
            at += part.length;
        }
        return new Overlay.Field(first.key(), first.layer(), first.frame(), values, first.scale());
    }

    private String word(String key) {
        if (key.startsWith("layer ")) {
            return look.texts().format("legend.layer", key.substring("layer ".length()));
        }
        return look.texts().get("legend." + key, look.texts().get("word." + key, key.replace('-', ' ')));
    }

    @Override
    public void close() {
        worker.shutdown();
    }
}
