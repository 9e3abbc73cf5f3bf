package troupe.risk.plan;

import java.util.Arrays;

/**
 * Holds the discs that the actor must not touch: avatars whose path is certain, stamped into place and time up to
 * the horizon, and uncertain ones where they stand at the present instant. Positions are in metres, times in
 * seconds from now. Used by one thread at a time; allocates nothing after its making.
 */
public final class Hazards {
    /** Seconds between the stamps of a path. */
    public static final double STAMP = 0.05;
    /** So long an uncertain avatar counts as standing where it is. */
    public static final double PRESENT = 0.1;

    private final double[] reach;
    private final double[] xs;
    private final double[] ys;
    private final int[] stamps;
    private final int most;

    /**
     * Makes hazards that are nowhere yet.
     *
     * @param reach for each, how near its middle may come to the actor's
     * @param horizon seconds that are looked ahead
     */
    public Hazards(double[] reach, double horizon) {
        this.reach = reach.clone();
        this.most = (int) Math.ceil(horizon / STAMP) + 1;
        this.xs = new double[reach.length * most];
        this.ys = new double[xs.length];
        this.stamps = new int[reach.length];
    }

    /** Takes every hazard away. */
    public void clear() {
        Arrays.fill(stamps, 0);
    }

    /** Returns the most stamps of a path. */
    public int most() {
        return most;
    }

    /** Sets where a hazard is at stamp {@code k}; NaN where it is not there. Stamps are set in order from 0. */
    public void stamp(int hazard, int k, double x, double y) {
        xs[hazard * most + k] = x;
        ys[hazard * most + k] = y;
        stamps[hazard] = k + 1;
    }

    /** Tells whether the actor touches a hazard at a place and time. Cost O(hazards). */
    public boolean hits(double x, double y, double seconds) {
        int k = (int) Math.max(0, Math.rint(seconds / STAMP));
        for (int h = 0; h < reach.length; h++) {
            if (k < stamps[h]) {
                double dx = x - xs[h * most + k];
                double dy = y - ys[h * most + k];
                if (dx * dx + dy * dy < reach[h] * reach[h]) {
                    return true;
                }
            }
        }
        return false;
    }
}
