package troupe.grid;

/**
 * Says that a scene is beyond what a grid can hold: too many floors above each other, too many different
 * stacks of obstacles, or too many crossings over one cell. The message is one line with what was found and
 * the cure. Planners turn it into an outcome, checks into a problem.
 */
public final class GridLimitException extends IllegalArgumentException {
    private static final long serialVersionUID = 1;

    private final String found;
    private final String cure;

    /** Makes the exception from what was found and what to do about it. */
    public GridLimitException(String found, String cure) {
        super(found + "; " + cure);
        this.found = found;
        this.cure = cure;
    }

    /** Returns what is too much, without the cure. */
    public String found() {
        return found;
    }

    /** Returns what a person can do. */
    public String cure() {
        return cure;
    }
}
