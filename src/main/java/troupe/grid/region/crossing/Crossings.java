package troupe.grid.region.crossing;

import java.util.Arrays;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;

/**
 * Holds the crossings of a region, ascending by cell, then take-off level, then kind, and where each
 * cell's begin: one bit per cell tells which hold any, and counted bits where theirs begin. Immutable.
 */
public final class Crossings {
    /** No crossings at all. */
    public static final Crossings NONE = new Crossings(0, new long[0]);

    private final long[] keys;
    private final long[] over;
    private final int[] before;
    private final int[] starts;

    /** Takes distinct ascending keys of {@link #key} for a frame of {@code size} cells. */
    public Crossings(int size, long[] keys) {
        this.keys = keys;
        this.over = new long[keys.length == 0 ? 0 : (size >> 6) + 1];
        this.before = new int[over.length];
        int cells = 0;
        for (int i = 0; i < keys.length; i++) {
            if (i == 0 || cell(i) != cell(i - 1)) {
                over[cell(i) >> 6] |= 1L << cell(i);
                cells++;
            }
        }
        for (int w = 1; w < over.length; w++) {
            before[w] = before[w - 1] + Long.bitCount(over[w - 1]);
        }
        this.starts = new int[cells + 1];
        int next = 0;
        for (int i = 0; i < keys.length; i++) {
            if (i == 0 || cell(i) != cell(i - 1)) {
                starts[next++] = i;
            }
        }
        starts[cells] = keys.length;
    }

    /** Packs a crossing so that keys sort as crossings are numbered. */
    public static long key(int cell, int level, byte kind) {
        return (long) cell << 32 | (long) level << 1 | (kind == Kind.JUMPABLE ? 1 : 0);
    }

    /** Returns the cell in a key. */
    public static int cell(long key) {
        return (int) (key >>> 32);
    }

    /** Returns the level in a key. */
    public static int level(long key) {
        return (int) (key >>> 1) & 0x7fff_ffff;
    }

    /** Returns the kind in a key. */
    public static byte kind(long key) {
        return (key & 1) == 0 ? Kind.GAP : Kind.JUMPABLE;
    }

    /** Returns the keys, ascending; the array itself. */
    public long[] keys() {
        return keys;
    }

    /** Returns how many there are. */
    public int size() {
        return keys.length;
    }

    /** Returns the cell over which a crossing lies. */
    public int cell(int i) {
        return cell(keys[i]);
    }

    /** Returns the take-off floor of a crossing. */
    public int level(int i) {
        return level(keys[i]);
    }

    /** Returns the kind of a crossing. */
    public byte kind(int i) {
        return kind(keys[i]);
    }

    /** Returns the ability bits of a crossing. */
    public int abilities(int i) {
        return ((keys[i] & 1) == 0 ? Ability.STRIDE : Ability.VAULT).bit();
    }

    /** Returns how many cells have crossings over them. */
    public int cells() {
        return starts.length - 1;
    }

    /** Returns the first crossing over the n-th cell that has some; the last ones end at {@code size()}. */
    public int start(int n) {
        return starts[n];
    }

    /** Returns the first crossing over a cell or a later one; those over it end before {@code first(cell + 1)}. */
    public int first(int cell) {
        if (over.length == 0) {
            return 0;
        }
        int w = cell >> 6;
        return starts[before[w] + Long.bitCount(over[w] & (1L << cell) - 1)];
    }

    /** Returns the crossing over a cell of a take-off level and kind, -1 if there is none. */
    public int find(int cell, int level, byte kind) {
        if (over.length == 0 || (over[cell >> 6] >> cell & 1) == 0) {
            return -1;
        }
        long key = key(cell, level, kind);
        for (int i = first(cell); i < keys.length && keys[i] <= key; i++) {
            if (keys[i] == key) {
                return i;
            }
        }
        return -1;
    }

    /** Returns the keys of two ascending lists that share none, ascending. */
    public static long[] merged(long[] some, long[] others) {
        long[] merged = new long[some.length + others.length];
        int next = 0;
        int count = 0;
        for (long key : others) {
            while (next < some.length && some[next] < key) {
                merged[count++] = some[next++];
            }
            merged[count++] = key;
        }
        System.arraycopy(some, next, merged, count, some.length - next);
        return merged;
    }

    /** Returns the distinct keys of a list in ascending order. */
    public static long[] sorted(long[] keys, int count) {
        long[] sorted = Arrays.copyOf(keys, count);
        Arrays.sort(sorted);
        int distinct = 0;
        for (int i = 0; i < count; i++) {
            if (distinct == 0 || sorted[distinct - 1] != sorted[i]) {
                sorted[distinct++] = sorted[i];
            }
        }
        return distinct == count ? sorted : Arrays.copyOf(sorted, distinct);
    }
}
