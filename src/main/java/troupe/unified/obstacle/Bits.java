package troupe.unified.obstacle;

/** Sets and reads rows of bits kept in a shared array of words. */
public final class Bits {
    private Bits() {}

    /** Sets the bits {@code [from, to)} of the row that begins at word {@code base}. */
    public static void set(long[] words, int base, int from, int to) {
        if (from >= to) {
            return;
        }
        int first = base + (from >> 6);
        int last = base + (to - 1 >> 6);
        long low = -1L << from;
        long high = -1L >>> -to;
        if (first == last) {
            words[first] |= low & high;
            return;
        }
        words[first] |= low;
        for (int w = first + 1; w < last; w++) {
            words[w] = -1L;
        }
        words[last] |= high;
    }

    /** Tells whether a bit of the row that begins at word {@code base} is set. */
    static boolean get(long[] words, int base, int at) {
        return (words[base + (at >> 6)] >>> at & 1) != 0;
    }

    /** Returns the first set bit from {@code from} on, {@code end} if there is none before it. */
    static int next(long[] words, int base, int from, int end) {
        int at = from;
        while (at < end) {
            long word = words[base + (at >> 6)] >>> at;
            if (word != 0) {
                return Math.min(end, at + Long.numberOfTrailingZeros(word));
            }
            at = (at | 63) + 1;
        }
        return end;
    }

    /** Returns the first clear bit from {@code from} on, {@code end} if there is none before it. */
    static int nextClear(long[] words, int base, int from, int end) {
        int at = from;
        while (at < end) {
            long word = ~words[base + (at >> 6)] >>> at;
            if (word != 0) {
                return Math.min(end, at + Long.numberOfTrailingZeros(word));
            }
            at = (at | 63) + 1;
        }
        return end;
    }
}
