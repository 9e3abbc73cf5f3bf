package troupe.risk.forecast;

/**
 * Keeps the last positions of one avatar, and gives them back at equal distances in time: straight lines between
 * what was seen. Times are in seconds, positions in metres. Used by one thread at a time; allocates nothing after
 * its making.
 */
public final class History {
    private final double[] times;
    private final double[] xs;
    private final double[] ys;
    private int count;
    private int next;

    /** Makes an empty history with room for {@code capacity} positions, at least 1; older ones are forgotten. */
    public History(int capacity) {
        if (capacity < 1) {
            throw new IllegalArgumentException("capacity=" + capacity + "; needs at least 1");
        }
        times = new double[capacity];
        xs = new double[capacity];
        ys = new double[capacity];
    }

    /** Forgets everything. */
    public void clear() {
        count = 0;
    }

    /**
     * Adds where the avatar is seen at a time later than all before.
     *
     * @throws IllegalArgumentException if the time is not later
     */
    public void see(double time, double x, double y) {
        if (count > 0 && !(time > times[last(0)])) {
            throw new IllegalArgumentException("time=" + time + "; needs one after " + times[last(0)]);
        }
        times[next] = time;
        xs[next] = x;
        ys[next] = y;
        next = (next + 1) % times.length;
        count = Math.min(count + 1, times.length);
    }

    /** Returns the x in metres of the newest position; meaningless before anything has been seen. */
    double x() {
        return xs[last(0)];
    }

    /** Returns the y in metres of the newest position; meaningless before anything has been seen. */
    double y() {
        return ys[last(0)];
    }

    private int last(int back) {
        return Math.floorMod(next - 1 - back, times.length);
    }

    /**
     * Gives the positions now, {@code step} seconds ago, twice that, and so on, as far as the history goes and the
     * arrays hold: a position at the instant of the oldest or later.
     *
     * @return how many there are; 0 if nothing has been seen
     */
    public int resample(double step, double[] toX, double[] toY) {
        if (count == 0) {
            return 0;
        }
        double now = times[last(0)];
        double oldest = times[last(count - 1)];
        int back = 0;
        for (int i = 0; i < toX.length; i++) {
            double time = now - i * step;
            if (time < oldest - 1e-9) {
                return i;
            }
            while (back < count - 1 && times[last(back)] > time + 1e-9) {
                back++;
            }
            int a = last(back);
            int b = back == 0 ? a : last(back - 1);
            double span = times[b] - times[a];
            double share = span > 0 ? Math.max(0, (time - times[a]) / span) : 0;
            toX[i] = xs[a] + share * (xs[b] - xs[a]);
            toY[i] = ys[a] + share * (ys[b] - ys[a]);
        }
        return toX.length;
    }
}
