package troupe.work.batch;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.scenario.MovingAiMap;
import troupe.exchange.scenario.MovingAiProblems.Problem;
import troupe.grid.region.Region;
import troupe.scene.Actor;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.search.Outcome;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.cost.JourneyQuery;
import troupe.unified.search.JourneyPath;
import troupe.unified.search.JourneySearch;
import troupe.unified.search.JourneyWorkspace;

/**
 * Solves every problem of a MovingAI scenario over one region of its map, and compares lengths. The
 * region is built once; the time of a problem holds both its searches, forward and cost-to-go.
 */
public final class ProblemBatch {
    /** The tolerance in metres for lengths that were rounded to two decimals in the file. */
    public static final double ROUGH = 0.01;
    /** The relative tolerance for other lengths. */
    public static final double FINE = 1e-5;

    private static final int CHUNK = 64;
    /** Expansions between two looks at whether the work is cancelled, some milliseconds. */
    private static final long SLICE = 100_000;

    private final List<Problem> problems;
    private final Region region;
    private final boolean rough;

    /**
     * What came of a problem; {@code length} is NaN where no way was found. {@code micros} is wall time.
     */
    public record Row(Problem problem, Outcome outcome, double length, long expanded, double micros) {}

    /**
     * Builds the region of the map.
     *
     * @throws IllegalArgumentException if a problem is of a map of another size
     */
    public ProblemBatch(MovingAiMap map, List<Problem> problems) throws ExchangeException {
        this.problems = List.copyOf(problems);
        for (Problem p : problems) {
            if (p.width() != map.width() || p.height() != map.height()) {
                throw new IllegalArgumentException("problem of a map of " + p.width() + " x " + p.height()
                        + "; the map is " + map.width() + " x " + map.height());
            }
        }
        Scene scene = map.scene();
        this.region = Region.of(scene, scene.actor(MovingAiMap.ACTOR).orElseThrow());
        this.rough = problems.stream().allMatch(p -> isRounded(p.length()));
    }

    private static boolean isRounded(double length) {
        return Math.abs(length * 100 - Math.rint(length * 100)) < 1e-6;
    }

    /** Tells whether a length equals the file's, within what the file's rounding allows. */
    public boolean equal(Row row) {
        double tolerance = rough ? ROUGH : FINE * Math.max(1, row.problem().length());
        return Math.abs(row.length() - row.problem().length()) <= tolerance;
    }

    /** Returns the number of problems. */
    public int size() {
        return problems.size();
    }

    /**
     * Solves every problem on {@code jobs} threads and hands the rows over, in order, on the calling thread.
     * When {@code cancelled}, which is asked from all threads, says so, the problems in work are dropped; the
     * rows handed over are then the first ones without a gap.
     */
    public void run(int jobs, BooleanSupplier cancelled, Consumer<Row> rows) {
        ThreadLocal<JourneyWorkspace> work = ThreadLocal.withInitial(() -> new JourneyWorkspace(region));
        List<Callable<List<Row>>> chunks = new ArrayList<>();
        for (int next = 0; next < problems.size(); next += CHUNK) {
            List<Problem> chunk = problems.subList(next, Math.min(next + CHUNK, problems.size()));
            chunks.add(() -> solve(chunk, work.get(), cancelled));
        }
        int[] handed = {0};
        Ordered.run(chunks, jobs, cancelled, done -> {
            done.forEach(rows);
            handed[0] += done.size();
            return handed[0] % CHUNK == 0 && !done.isEmpty();
        });
    }

    /** Returns the rows of the problems up to the one at which the work was cancelled. */
    private List<Row> solve(List<Problem> chunk, JourneyWorkspace work, BooleanSupplier cancelled) {
        Actor actor = region.actor();
        JourneyCosts costs =
                new JourneyCosts(actor, Preferences.NEUTRAL, region.frame().cell());
        List<Row> rows = new ArrayList<>();
        for (Problem problem : chunk) {
            Row row = solve(problem, work, costs, cancelled);
            if (row.outcome().isRunning()) {
                break;
            }
            rows.add(row);
        }
        return rows;
    }

    private Row solve(Problem problem, JourneyWorkspace work, JourneyCosts costs, BooleanSupplier cancelled) {
        int start = region.locate(problem.start());
        int goal = region.locate(problem.goal());
        if (start < 0 || goal < 0 || !region.open(start) || !region.open(goal)) {
            Outcome blocked = new Outcome.Infeasible("start or goal is blocked");
            return new Row(problem, blocked, Double.NaN, 0, 0);
        }
        long begin = System.nanoTime();
        JourneySearch search = new JourneySearch(work, costs, JourneyQuery.optimal(start, goal));
        Outcome outcome = search.outcome();
        while (outcome.isRunning() && !cancelled.getAsBoolean()) {
            outcome = search.step(SLICE);
        }
        double length = search.path().map(JourneyPath::length).orElse(Double.NaN);
        double micros = (System.nanoTime() - begin) * 1e-3;
        return new Row(problem, outcome, length, search.expanded(), micros);
    }

    /** Returns the value below which the given share of the values lies; 0 for no values. */
    public static double quantile(double[] values, double share) {
        if (values.length == 0) {
            return 0;
        }
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[(int) Math.min(sorted.length - 1L, (long) (share * sorted.length))];
    }
}
