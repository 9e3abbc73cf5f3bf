package troupe.work.batch;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import troupe.run.Digest;
import troupe.run.Engine;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;
import troupe.scene.check.Severity;
import troupe.scene.setting.Settings;
import troupe.search.Outcome;
import troupe.work.Tasks;

/**
 * Plans one task under all combinations of settings and seeds. The rows come in the order of the cases,
 * first axis slowest, seed fastest, and do not depend on the number of threads; times apart.
 */
public final class Batch {
    private static final long SLICE = 20_000;
    /** The most combinations of one batch. */
    public static final int MAX_CASES = 1_000_000;

    /** A setting that is varied. */
    public record Axis(String key, List<String> values) {

        /** Copies the values and checks that there is one. */
        public Axis {
            values = List.copyOf(values);
            if (values.isEmpty()) {
                throw new IllegalArgumentException("setting " + key + " is varied over no value");
            }
        }
    }

    /** One combination: the value of each axis, in order, and the seed. */
    public record Case(List<String> values, long seed) {}

    /** What came of a case; {@code millis} is wall time. */
    public record Row(Case of, Outcome outcome, Report report, int frames, String digest, double millis) {}

    private final Scene scene;
    private final String task;
    private final List<Axis> axes;
    private final List<Case> cases;

    /**
     * Makes a batch and checks the scene that every combination of settings gives.
     *
     * @throws IllegalArgumentException if a setting is unknown or refuses a value, a combination makes the scene
     *     wrong, or there are more than {@link #MAX_CASES} combinations
     */
    public Batch(Scene scene, String task, List<Axis> axes, List<Long> seeds) {
        this.scene = scene;
        this.task = task;
        this.axes = List.copyOf(axes);
        long count = seeds.size();
        for (Axis axis : axes) {
            count *= axis.values().size();
            if (count > MAX_CASES) {
                throw new IllegalArgumentException("more than " + MAX_CASES + " combinations");
            }
        }
        List<Case> all = new ArrayList<>();
        combine(new ArrayList<>(), seeds, all);
        this.cases = List.copyOf(all);
        cases.stream().filter(one -> one.seed() == cases.get(0).seed()).forEach(this::check);
    }

    private void check(Case one) {
        for (Problem problem : SceneChecks.check(scene(one))) {
            if (problem.severity() == Severity.ERROR) {
                throw new IllegalArgumentException(settings(one) + ": " + problem.describe());
            }
        }
    }

    private String settings(Case one) {
        List<String> words = new ArrayList<>();
        for (int i = 0; i < axes.size(); i++) {
            words.add(axes.get(i).key() + "=" + one.values().get(i));
        }
        return String.join(" ", words);
    }

    private void combine(List<String> chosen, List<Long> seeds, List<Case> all) {
        if (chosen.size() == axes.size()) {
            seeds.forEach(seed -> all.add(new Case(List.copyOf(chosen), seed)));
            return;
        }
        for (String value : axes.get(chosen.size()).values()) {
            chosen.add(value);
            combine(chosen, seeds, all);
            chosen.remove(chosen.size() - 1);
        }
    }

    private Scene scene(Case one) {
        Scene changed = scene;
        for (int i = 0; i < axes.size(); i++) {
            changed = Settings.apply(
                    changed, task, axes.get(i).key(), one.values().get(i));
        }
        return Settings.apply(changed, task, "seed", Long.toString(one.seed()));
    }

    /** Returns the axes. */
    public List<Axis> axes() {
        return axes;
    }

    /** Returns the number of cases. */
    public int size() {
        return cases.size();
    }

    /**
     * Plans every case on {@code jobs} threads and hands the rows over, in order, on the calling thread.
     * When {@code cancelled} says so, work ends, and rows of unfinished cases are left out.
     */
    public void run(int jobs, BooleanSupplier cancelled, Consumer<Row> rows) {
        List<Callable<Row>> pieces = new ArrayList<>();
        cases.forEach(one -> pieces.add(() -> plan(one, cancelled)));
        Ordered.run(pieces, jobs, cancelled, row -> {
            boolean whole = !row.outcome().equals(Outcome.CANCELLED);
            if (whole) {
                rows.accept(row);
            }
            return whole;
        });
    }

    private Row plan(Case one, BooleanSupplier cancelled) {
        long begin = System.nanoTime();
        Engine engine = Tasks.start(scene(one), task);
        while (engine.step(SLICE).isRunning()) {
            if (cancelled.getAsBoolean()) {
                engine.cancel();
            }
        }
        double millis = (System.nanoTime() - begin) * 1e-6;
        Run run = engine.run();
        return new Row(one, run.outcome(), run.report(), run.frames().count(), Digest.of(run.frames()), millis);
    }
}
