package troupe.grid.layer;

import java.util.Arrays;

/**
 * Holds the solids over one spot, merged: stretches {@code [bottom, top]} in metres from below, the first
 * of them the ground, which reaches down without end. Two stretches that overlap or lie less than
 * {@link #CLOSE} apart are one. Immutable; equal contents are equal.
 */
public final class Column {
    /** Gaps below this many metres close. */
    public static final double CLOSE = 1e-3;

    /** Heights in metres that differ by no more than this are the same height. */
    public static final double SAME = 1e-9;

    private final double ground;
    private final double[] bottoms;
    private final double[] tops;

    private Column(double ground, double[] bottoms, double[] tops) {
        this.ground = ground;
        this.bottoms = bottoms;
        this.tops = tops;
    }

    /** Makes the column that is solid all the way up. */
    public static Column rock() {
        return ground(Double.POSITIVE_INFINITY);
    }

    /** Makes the column of bare ground at an elevation. */
    public static Column ground(double elevation) {
        return new Column(elevation, new double[] {Double.NEGATIVE_INFINITY}, new double[] {elevation});
    }

    /** Returns this column with a solid put in. */
    public Column with(double bottom, double top) {
        int first = 0;
        while (first < tops.length && tops[first] + CLOSE <= bottom) {
            first++;
        }
        int last = first;
        double low = bottom;
        double high = top;
        while (last < tops.length && bottoms[last] < top + CLOSE) {
            low = Math.min(low, bottoms[last]);
            high = Math.max(high, tops[last]);
            last++;
        }
        int count = tops.length - (last - first) + 1;
        return new Column(ground, spliced(bottoms, first, last, count, low), spliced(tops, first, last, count, high));
    }

    private static double[] spliced(double[] old, int first, int last, int count, double value) {
        double[] changed = new double[count];
        System.arraycopy(old, 0, changed, 0, first);
        changed[first] = value;
        System.arraycopy(old, last, changed, first + 1, old.length - last);
        return changed;
    }

    /** Returns the elevation of the bare ground, ditches counted and obstacles not. */
    public double ground() {
        return ground;
    }

    /** Returns the number of merged stretches, at least 1. */
    public int size() {
        return tops.length;
    }

    /** Returns the elevation in metres at which a stretch begins, counted from the lowest. */
    public double bottom(int i) {
        return bottoms[i];
    }

    /** Returns the elevation in metres at which a stretch ends. */
    public double top(int i) {
        return tops[i];
    }

    /** Returns where the free stretch above solid {@code i} ends; infinite above the last. */
    public double ceiling(int i) {
        return i + 1 < bottoms.length ? bottoms[i + 1] : Double.POSITIVE_INFINITY;
    }

    /** Returns the highest top that does not lie above {@code limit}; minus infinity if there is none. */
    public double highestTop(double limit) {
        double highest = Double.NEGATIVE_INFINITY;
        for (double top : tops) {
            if (top <= limit + SAME) {
                highest = top;
            }
        }
        return highest;
    }

    /** Tells whether a solid reaches into the open stretch {@code (low, high)}. */
    public boolean meets(double low, double high) {
        for (int i = 0; i < tops.length; i++) {
            if (bottoms[i] < high - SAME && tops[i] > low + SAME) {
                return true;
            }
        }
        return false;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Column c
                && ground == c.ground
                && Arrays.equals(bottoms, c.bottoms)
                && Arrays.equals(tops, c.tops);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(tops) + Arrays.hashCode(bottoms);
    }
}
