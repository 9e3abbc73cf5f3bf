package troupe.unified.cost;

import java.util.Arrays;
import java.util.BitSet;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.search.BucketQueue;

/**
 * Holds the memory of searches for the cost to go over one region, about 14 bytes per configuration; a generation
 * stamp takes the place of clearing, and what a step needs to know of a place is found when first asked for. One search
 * at a time owns it. Used by one thread at a time.
 */
public final class FieldMemory {
    /** How many stamps a generation has. */
    static final int STAMPS = 16;

    /** The stamp within a generation of a place that may be left in any direction. */
    static final int ANY = GridFrame.DIRECTIONS;

    /** The stamp within a generation of a place whose cost to go is known exactly; those below are open. */
    static final int SETTLED = ANY + 1;

    /** The greatest generation. */
    public static final int LAST_GENERATION = (Integer.MAX_VALUE >> 4) - 1;

    /** Bits of {@link #local(int)} above the eight of the legal steps: no other steps need to be looked at. */
    static final int PLAIN = 1 << 8;

    /** All eight steps are legal, and the place and its neighbours allow the same abilities. */
    static final int CALM = 1 << 9;

    /** The first of the bits that tell the standing abilities. */
    static final int ABILITIES = 10;

    /** A vault over the place promises no more than walking there, see {@link #found}. */
    private static final int IDLE = 1 << 12;

    /** What the place knows without its neighbours' {@link #IDLE} has been found. */
    private static final int BEGUN = 1 << 13;

    /** All has been found. */
    private static final int FOUND = 1 << 14;

    private static final int STANDING = Ability.WALK.bit() | Ability.SIDESTEP.bit();

    final Region region;
    final int[] offsets;

    /** The cost to go in units, valid where {@link #stamps} is of this generation. */
    final long[] toGo;

    /** The generation times {@link #STAMPS}, plus {@link #SETTLED}, the direction it was reached in, or {@link #ANY}. */
    final int[] stamps;

    private final short[] local;
    private final int spans;
    private final int[] columns;

    /** The cells beside crossings that are gaps; null where there are no vaults to be found idle. */
    private final BitSet gaps;

    final int[] targets = new int[Region.MAX_NEIGHBOURS];
    final int[] directions = new int[Region.MAX_NEIGHBOURS];
    final boolean relaxed;
    private BucketQueue open;
    private int queueBits = -1;
    private int generation;

    /**
     * Takes the memory. Cost O(size of the region).
     *
     * @param relaxed whether it is a widest region, where a step on a floor costs no more than one of a vault
     */
    public FieldMemory(Region region, boolean relaxed) {
        this.region = region;
        this.relaxed = relaxed;
        offsets = region.frame().offsets();
        toGo = new long[region.size()];
        stamps = new int[region.size()];
        local = new short[region.size()];
        spans = region.spanCount();
        columns = region.spans().columnAt();
        gaps = relaxed && region.size() > spans ? besideGaps() : null;
    }

    private BitSet besideGaps() {
        BitSet beside = new BitSet(region.frame().size());
        for (int q = spans; q < region.size(); q++) {
            if (region.kind(q) == Kind.GAP) {
                for (int offset : offsets) {
                    beside.set(region.cell(q) + offset);
                }
            }
        }
        return beside;
    }

    /** Returns what a step from a configuration needs to know: the legal steps, {@link #PLAIN}, {@link #CALM}, abilities. */
    int local(int q) {
        int known = local[q];
        return (known & FOUND) != 0 ? known : found(q);
    }

    /** Returns the standing abilities of a span. */
    int abilities(int q) {
        int known = local[q];
        return known != 0 ? known >> ABILITIES & STANDING : region.abilities(q);
    }

    /**
     * Tells whether a vault of the widest region over a place need not be looked at. Over a place that is calm, stable,
     * open to walking and among nine equal columns, a vault that promises no less than walking there is idle: all that it
     * is joined to can walk there as well, at no more cost.
     */
    boolean isIdle(int q) {
        return (begun(q) & IDLE) != 0;
    }

    /**
     * Finds all of a place. One that has only idle vaults around goes on as if there were no vaults: each of them would
     * be reached from it at no less than the place beneath is.
     */
    private int found(int q) {
        int known = begun(q) | FOUND;
        if ((known & (IDLE | PLAIN)) == IDLE && !gaps.get(region.cell(q)) && hasIdleAround(q)) {
            known |= PLAIN | CALM;
        }
        local[q] = (short) known;
        return known;
    }

    private int begun(int q) {
        int known = local[q];
        if (known != 0) {
            return known;
        }
        int abilities = q < spans ? region.abilities(q) : 0;
        known = BEGUN;
        if (abilities != 0) {
            known |= region.moves(q) | abilities << ABILITIES | (region.plain(q) ? PLAIN : 0);
            if ((known & 255) == 255 && isAlike(q, abilities)) {
                known |= (known & PLAIN) != 0 ? CALM : 0;
                known |= gaps != null && region.takesOff(q) && isEven(q) ? IDLE : 0;
            }
        }
        local[q] = (short) known;
        return known;
    }

    /** Tells whether the neighbours of a place that has all eight on its sheet allow the same abilities. */
    private boolean isAlike(int q, int abilities) {
        boolean alike = true;
        for (int d = 0; alike && d < GridFrame.DIRECTIONS; d++) {
            alike = region.abilities(q + offsets[d]) == abilities;
        }
        return alike;
    }

    /** Tells whether the nine columns around a place are the same. */
    private boolean isEven(int q) {
        int cell = region.cell(q);
        boolean even = true;
        for (int d = 0; even && d < GridFrame.DIRECTIONS; d++) {
            even = columns[cell + offsets[d]] == columns[cell];
        }
        return even;
    }

    private boolean hasIdleAround(int q) {
        boolean all = true;
        for (int d = 0; all && d < GridFrame.DIRECTIONS; d++) {
            all = isIdle(q + offsets[d]);
        }
        return all;
    }

    /** Hands the memory to a new search, empty, and returns the search's generation. */
    int begin(JourneyCosts costs) {
        if (generation == LAST_GENERATION) {
            Arrays.fill(stamps, 0);
            generation = 0;
        }
        generation++;
        int shift = costs.bucketBits();
        if (queueBits != shift) {
            queueBits = shift;
            open = new BucketQueue(shift, this::isSettled);
        }
        open.clear();
        return generation;
    }

    /** Returns the open places of the search that owns the memory. */
    BucketQueue open() {
        return open;
    }

    /** Tells whether the cost to go from a configuration is known exactly. */
    boolean isSettled(int configuration) {
        return stamps[configuration] == STAMPS * generation + SETTLED;
    }
}
