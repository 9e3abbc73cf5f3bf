package troupe.run;

import java.util.List;
import java.util.function.Predicate;
import troupe.run.view.Aspect;
import troupe.run.view.Overlay;
import troupe.search.Outcome;

/**
 * Works on one task. Every planner is driven through this interface: by the studio, the command line,
 * the tests and the benchmarks. An engine is used by one thread at a time; what it hands out is
 * immutable.
 */
public interface Engine {

    /**
     * Does at most {@code budget} units of work (expansions, steps of simulation; at least 1) and says
     * how the task stands. The result does not depend on how the work is sliced. Calling it after the
     * end does nothing.
     */
    Outcome step(long budget);

    /** Returns how the task stands, without working. */
    Outcome outcome();

    /** Ends the work with the outcome {@code Cancelled}, unless it has ended already. */
    void cancel();

    /** Returns the units of work done so far, and an estimate in [0, 1] of the share done, NaN if unknown. */
    Progress progress();

    /** Returns the views of the work so far; never null, may be empty. Cost: up to that of a field. */
    List<Overlay> overlays();

    /**
     * Returns the respects in which there are several sets of views to choose from; none unless the planner has
     * some. What a later aspect offers may depend on what is chosen of those before it.
     *
     * @param chosen the choice of each aspect in their order, from 0; may be shorter, and what an aspect lacks
     *     counts as its first choice ({@link Aspect#chosen})
     */
    default List<Aspect> aspects(List<Integer> chosen) {
        return List.of();
    }

    /** Returns the views of a choice of {@link #aspects}; of no choice those of {@link #overlays()}. */
    default List<Overlay> overlays(List<Integer> chosen) {
        return overlays();
    }

    /**
     * Returns the views of a choice as far as they are wanted, those that are costly at least; others may be among
     * them.
     *
     * @param wanted which ones, by their keys
     */
    default List<Overlay> overlays(List<Integer> chosen, Predicate<String> wanted) {
        return overlays(chosen);
    }

    /** Returns the run as far as it has come: the frames so far and the report. */
    Run run();

    /** How far a task has come. */
    record Progress(long work, double share) {}

    /** Works until the end and returns the run. */
    default Run finish() {
        while (step(100_000).isRunning()) {
            // each slice is bounded; the loop ends with the task
        }
        return run();
    }
}
