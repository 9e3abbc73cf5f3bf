package troupe.risk.forecast;

/**
 * Expects how an avatar goes on from the positions it has had: Avatars, equations 1 and 2. Speeds are in m/s.
 * Used by one thread at a time; allocates nothing after its making.
 *
 * <p>Deviations: the changes are those of velocity, newest first, where the paper's text speaks of positions, so
 * that all terms have one unit; changes further back than the history count as none; the speed is capped, as on
 * noisy tracks the sum overshoots.
 */
public final class Expectation {
    private final double step;
    private final double[] xs;
    private final double[] ys;
    private double vx;
    private double vy;

    /**
     * Makes an expectation at rest.
     *
     * @param history earlier positions to look at, the n of equation 1, at least 1
     * @param step seconds between positions
     */
    public Expectation(int history, double step) {
        this.step = step;
        this.xs = new double[history + 1];
        this.ys = new double[history + 1];
    }

    /**
     * Finds the expected velocity after a history; 0 if that holds fewer than two positions.
     *
     * @param most the highest speed, above 0
     * @return whether anything has been seen at all
     */
    public boolean of(History history, double most) {
        int count = history.resample(step, xs, ys);
        expect(xs, ys, count, most);
        return count > 0;
    }

    /** Finds the expected velocity from positions {@code step} seconds apart, the newest first. */
    void expect(double[] atX, double[] atY, int count, double most) {
        vx = 0;
        vy = 0;
        if (count < 2) {
            return;
        }
        vx = (atX[0] - atX[1]) / step;
        vy = (atY[0] - atY[1]) / step;
        double weight = 1;
        for (int i = 0; i + 2 < count; i++) {
            // the velocity from position i + 1 to i, less the one before it
            vx += weight * (atX[i] - 2 * atX[i + 1] + atX[i + 2]) / step;
            vy += weight * (atY[i] - 2 * atY[i + 1] + atY[i + 2]) / step;
            weight /= 2;
        }
        double speed = Math.sqrt(vx * vx + vy * vy);
        if (speed > most) {
            vx *= most / speed;
            vy *= most / speed;
        }
    }

    /** Returns the x of the expected velocity. */
    public double vx() {
        return vx;
    }

    /** Returns the y of the expected velocity. */
    public double vy() {
        return vy;
    }
}
