package troupe.grid.region;

import java.util.Arrays;

/**
 * Holds the crossings of a region, ascending by cell, then take-off level, then kind, and where each
 * cell's begin. Immutable once built.
 */
final class Crossings {
    /** No crossings at all. */
    static final Crossings NONE = new Crossings(0, new long[0], 0);

    private final int[] cells;
    private final int[] levels;
    private final byte[] kinds;
    private final int[] first;

    /** Unpacks {@code count} keys of {@link #key} for a frame of {@code size} cells. */
    Crossings(int size, long[] keys, int count) {
        long[] sorted = Arrays.copyOf(keys, count);
        Arrays.sort(sorted);
        this.cells = new int[count];
        this.levels = new int[count];
        this.kinds = new byte[count];
        this.first = new int[count == 0 ? 0 : size + 1];
        for (int i = 0; i < count; i++) {
            cells[i] = (int) (sorted[i] >>> 32);
            levels[i] = (int) (sorted[i] >>> 1) & 0x7fff_ffff;
            kinds[i] = (sorted[i] & 1) == 0 ? Kind.GAP : Kind.JUMPABLE;
            first[cells[i] + 1]++;
        }
        for (int cell = 1; cell < first.length; cell++) {
            first[cell] += first[cell - 1];
        }
    }

    /** Packs a crossing so that keys sort as crossings are numbered. */
    static long key(int cell, int level, byte kind) {
        return (long) cell << 32 | (long) level << 1 | (kind == Kind.JUMPABLE ? 1 : 0);
    }

    int size() {
        return cells.length;
    }

    int cell(int i) {
        return cells[i];
    }

    int level(int i) {
        return levels[i];
    }

    byte kind(int i) {
        return kinds[i];
    }

    /** Returns the first crossing over a cell; those over it end before {@code first(cell + 1)}. */
    int first(int cell) {
        return first.length == 0 ? 0 : first[cell];
    }

    /** Returns the crossing over a cell of a take-off level and kind, -1 if there is none. */
    int find(int cell, int level, byte kind) {
        for (int i = first(cell), end = first(cell + 1); i < end; i++) {
            if (levels[i] == level && kinds[i] == kind) {
                return i;
            }
        }
        return -1;
    }
}
