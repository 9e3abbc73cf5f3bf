package troupe.search;

/** Says how a search, or any task, stands. Nothing found is an answer, never null and never an exception. */
public sealed interface Outcome {
    Outcome FOUND = new Found();
    Outcome RUNNING = new Running();
    Outcome EXHAUSTED = new Exhausted();
    Outcome CANCELLED = new Cancelled();

    /** What was asked for was found. */
    record Found() implements Outcome {}

    /** There is no answer; {@code reason} says why, in words that a person can act on. */
    record Infeasible(String reason) implements Outcome {}

    /** The budget of work given in the settings ran out before an answer. */
    record Exhausted() implements Outcome {}

    /** It was cancelled. */
    record Cancelled() implements Outcome {}

    /** It has more to do. */
    record Running() implements Outcome {}

    /** Tells whether more work can still change this outcome. */
    default boolean isRunning() {
        return this instanceof Running;
    }

    /** Tells whether an answer was found. */
    default boolean isFound() {
        return this instanceof Found;
    }

    /** Returns the word for it in reports: {@code found}, {@code infeasible}, … */
    default String word() {
        return getClass().getSimpleName().toLowerCase(java.util.Locale.ROOT);
    }
}
