package troupe.work.batch;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.LongStream;
import troupe.risk.study.RandomEncounters;
import troupe.risk.study.Walkers;
import troupe.run.Digest;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.scene.Encounter;
import troupe.scene.Scene;
import troupe.search.Outcome;
import troupe.work.Tasks;

/**
 * Runs many encounters, each by every method, side by side. The rows come in the order of the cases, the methods of
 * one case next to each other, and do not depend on the number of threads; times apart.
 */
public final class EncounterBatch {
    private static final long SLICE = 100;

    /** One encounter: its name in the table, its scene and task, and the seconds of the person it stands for, NaN if none. */
    public record Case(String name, Scene scene, String task, double recorded) {}

    /** What came of a case by a method. */
    public record Row(Case of, Encounter.Method method, Run run, String digest) {}

    private final List<Case> cases;
    private final List<Encounter.Method> methods;

    /** Makes a batch of cases. */
    public EncounterBatch(List<Case> cases, List<Encounter.Method> methods) {
        this.cases = List.copyOf(cases);
        this.methods = List.copyOf(methods);
    }

    /** Returns the random encounters of seeds, from the first to the last. */
    public static List<Case> random(long first, long last) {
        return LongStream.rangeClosed(first, last)
                .mapToObj(seed ->
                        new Case(Long.toString(seed), RandomEncounters.scene(seed), RandomEncounters.TASK, Double.NaN))
                .toList();
    }

    /** Returns the encounters of at most {@code most} recorded walkers. */
    public static List<Case> walkers(Walkers walkers, int most) {
        return walkers.choose(most).stream()
                .map(w -> new Case(Long.toString(w.id()), w.scene(), Walkers.TASK, w.seconds()))
                .toList();
    }

    /** Returns the number of rows. */
    public int size() {
        return cases.size() * methods.size();
    }

    /**
     * Runs all on {@code jobs} threads and hands the rows over, in order, on the calling thread. When
     * {@code cancelled} says so, work ends, and rows of unfinished cases are left out.
     */
    public void run(int jobs, BooleanSupplier cancelled, Consumer<Row> rows) {
        List<Callable<Row>> pieces = new ArrayList<>();
        for (Case one : cases) {
            for (Encounter.Method method : methods) {
                pieces.add(() -> row(one, method, cancelled));
            }
        }
        Ordered.run(pieces, jobs, cancelled, row -> {
            boolean whole = !row.run().outcome().equals(Outcome.CANCELLED);
            if (whole) {
                rows.accept(row);
            }
            return whole;
        });
    }

    private static Row row(Case one, Encounter.Method method, BooleanSupplier cancelled) {
        Encounter encounter = (Encounter) one.scene().task(one.task()).orElseThrow();
        Engine engine = Tasks.start(one.scene().with(encounter.with(method)), one.task());
        while (engine.step(SLICE).isRunning()) {
            if (cancelled.getAsBoolean()) {
                engine.cancel();
            }
        }
        Run run = engine.run();
        return new Row(one, method, run, Digest.of(run.frames()));
    }
}
