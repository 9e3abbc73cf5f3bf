package troupe.app.plan;

/**
 * Says whether the background thread plans, and how far it has come.
 *
 * @param done units of work done so far
 * @param share the share done in [0, 1], NaN if unknown
 */
public record Work(boolean planning, long done, double share) {
    /** Nothing is being planned. */
    public static final Work IDLE = new Work(false, 0, Double.NaN);
}
