package troupe.risk.plan;

import java.util.Arrays;

/**
 * Holds a path in place and time: points in metres with the time in seconds at which each is reached, and the
 * configuration whose cell holds it. Between points one moves straight and evenly; two points at one place are a
 * wait. Mutable, used by one thread at a time; it grows and never shrinks.
 */
public final class TimedPath {
    private double[] xs = new double[256];
    private double[] ys = new double[256];
    private double[] ts = new double[256];
    private int[] qs = new int[256];
    private int size;

    /** Makes a path without a point. */
    public TimedPath() {}

    /** Forgets every point. */
    public void clear() {
        size = 0;
    }

    /** Adds a point at a time not before the last one's. */
    public void add(double x, double y, double t, int q) {
        if (size == xs.length) {
            xs = Arrays.copyOf(xs, 2 * size);
            ys = Arrays.copyOf(ys, 2 * size);
            ts = Arrays.copyOf(ts, 2 * size);
            qs = Arrays.copyOf(qs, 2 * size);
        }
        xs[size] = x;
        ys[size] = y;
        ts[size] = t;
        qs[size++] = q;
    }

    /** Adds the points {@code from} to before {@code to} of another path, {@code later} seconds later. */
    public void add(TimedPath other, int from, int to, double later) {
        for (int i = from; i < to; i++) {
            add(other.xs[i], other.ys[i], other.ts[i] + later, other.qs[i]);
        }
    }

    /** Becomes equal to another path. */
    public void set(TimedPath other) {
        clear();
        add(other, 0, other.size, 0);
    }

    /** Turns the order of the points round; their times stay with them. */
    void reverse() {
        for (int i = 0, j = size - 1; i < j; i++, j--) {
            double x = xs[i];
            double y = ys[i];
            double t = ts[i];
            int q = qs[i];
            xs[i] = xs[j];
            ys[i] = ys[j];
            ts[i] = ts[j];
            qs[i] = qs[j];
            xs[j] = x;
            ys[j] = y;
            ts[j] = t;
            qs[j] = q;
        }
    }

    /** Puts off all points but the first, so that the way to the second one is no faster than a speed in m/s. */
    void hurryNot(double speed) {
        if (size < 2) {
            return;
        }
        double later = length(0, 1) / speed - (ts[1] - ts[0]);
        for (int i = 1; i < size && later > 0; i++) {
            ts[i] += later;
        }
    }

    /** Returns the number of points. */
    public int size() {
        return size;
    }

    /** Returns the x of a point. */
    public double x(int i) {
        return xs[i];
    }

    /** Returns the y of a point. */
    public double y(int i) {
        return ys[i];
    }

    /** Returns the time of a point. */
    public double t(int i) {
        return ts[i];
    }

    /** Returns the configuration of a point. */
    public int q(int i) {
        return qs[i];
    }

    /** Returns the last point at or before a time; 0 if there is none. Cost O(log size). */
    public int at(double time) {
        int low = 0;
        int high = size - 1;
        while (low < high) {
            int middle = (low + high + 1) >>> 1;
            if (ts[middle] <= time) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return low;
    }

    /** Returns the x at a time, that of the nearer end outside. */
    public double xAt(double time) {
        return between(xs, time);
    }

    /** Returns the y at a time, that of the nearer end outside. */
    public double yAt(double time) {
        return between(ys, time);
    }

    private double between(double[] values, double time) {
        int i = at(time);
        if (i + 1 >= size || time <= ts[i]) {
            return values[i];
        }
        double share = (time - ts[i]) / (ts[i + 1] - ts[i]);
        return values[i] + share * (values[i + 1] - values[i]);
    }

    /** Returns the configuration that holds the place at a time, or that of the point next to it. */
    public int qAt(double time) {
        int i = at(time);
        boolean nearer = i + 1 < size && time - ts[i] > ts[i + 1] - time;
        return qs[nearer ? i + 1 : i];
    }

    /** Returns the length in metres. */
    public double length() {
        return length(0, size - 1);
    }

    /** Returns the length in metres between two points. */
    public double length(int from, int to) {
        double sum = 0;
        for (int i = from + 1; i <= to; i++) {
            double dx = xs[i] - xs[i - 1];
            double dy = ys[i] - ys[i - 1];
            sum += Math.sqrt(dx * dx + dy * dy);
        }
        return sum;
    }

    /** Takes away what lies before a time, so that the path begins there. */
    public void begin(double time) {
        int i = at(time);
        if (size == 0 || time <= ts[i]) {
            return;
        }
        double x = xAt(time);
        double y = yAt(time);
        int q = qAt(time);
        int from = i + 1 < size ? i : i + 1;
        if (from == size) {
            size = 0;
            add(x, y, time, q);
            return;
        }
        int left = size - from;
        System.arraycopy(xs, from, xs, 0, left);
        System.arraycopy(ys, from, ys, 0, left);
        System.arraycopy(ts, from, ts, 0, left);
        System.arraycopy(qs, from, qs, 0, left);
        size = left;
        xs[0] = x;
        ys[0] = y;
        ts[0] = time;
        qs[0] = q;
    }
}
