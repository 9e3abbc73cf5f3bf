package troupe.unified.search;

import java.util.Arrays;
import java.util.BitSet;
import troupe.grid.GridFrame;
import troupe.grid.region.Kind;
import troupe.grid.region.Region;
import troupe.scene.Ability;
import troupe.search.BucketQueue;
import troupe.search.LabelPool;
import troupe.search.MinHeap;

/**
 * Holds the memory that searches over one region need, about 26 bytes per configuration, so that
 * thousands of problems share it: a generation stamp takes the place of clearing. One search at a time
 * owns it; the next one takes it over. Used by one thread at a time.
 */
public final class JourneyWorkspace {
    /** How many stamps a generation has. */
    static final int STAMPS = 16;

    /** The stamp within a generation of a place that may be left in any direction. */
    static final int ANY = GridFrame.DIRECTIONS;

    /** The stamp within a generation of a place whose cost to go is known exactly; those below are open. */
    static final int SETTLED = ANY + 1;

    /** The next label of a label that has been dominated. */
    static final int DOMINATED = -2;

    /** Bits of {@link #local} above the eight of the legal steps: all steps stay on the sheet. */
    static final int PLAIN = 1 << 8;

    /** All eight steps are legal, and the place and its neighbours allow the same abilities. */
    static final int CALM = 1 << 9;

    /** The first of the bits that tell the standing abilities. */
    static final int ABILITIES = 10;

    /** A vault over the place promises no more than walking there, see {@link #findIdle}. */
    static final int IDLE = 1 << 12;

    private static final int STANDING = Ability.WALK.bit() | Ability.SIDESTEP.bit();
    private static final int LAST_GENERATION = (Integer.MAX_VALUE >> 4) - 1;

    final Region region;

    /** The region over which the cost to go is found. */
    final Region widest;

    final int[] offsets;

    /** The cost to go in units, valid where {@link #toGoStamp} is of this generation. */
    final long[] toGo;

    /** The generation times {@link #STAMPS}, plus {@link #SETTLED}, the direction it was reached in, or {@link #ANY}. */
    final int[] toGoStamp;

    /** The first label of each configuration of the region. */
    final ChainTable chains;

    final LabelPool labels = new LabelPool(1024);
    final MinHeap heap = new MinHeap(1024);
    final int[] targets = new int[Region.MAX_NEIGHBOURS];
    final int[] directions = new int[Region.MAX_NEIGHBOURS];

    /** What a step from each configuration needs to know: the legal steps, {@link #PLAIN}, {@link #CALM}, abilities. */
    final short[] local;

    private BucketQueue forward;
    private BucketQueue backward;
    private int queueBits = -1;
    private int generation;

    /** Takes the memory for searches in which no obstacle is moved. Cost O(size of the region), once. */
    public JourneyWorkspace(Region region) {
        this(region, region);
    }

    /**
     * Takes the memory for searches over a region and what it can be changed to.
     *
     * @param region the region of the scene as it stands
     * @param widest the region that holds every way over any search space, for the cost to go
     */
    public JourneyWorkspace(Region region, Region widest) {
        this.region = region;
        this.widest = widest;
        GridFrame frame = region.frame();
        offsets = frame.offsets();
        toGo = new long[widest.size()];
        toGoStamp = new int[widest.size()];
        chains = new ChainTable(region.size());
        local = new short[widest.size()];
        for (int q = 0; q < local.length; q++) {
            if (widest.open(q)) {
                local[q] = (short) local(q);
            }
        }
        if (widest != region && widest.size() > widest.spanCount()) {
            findIdle();
        }
    }

    /**
     * Finds where no vault of the widest region needs to be looked at. Over a place that is calm, stable, open to
     * walking and among nine equal columns, a vault that promises no less than walking there is idle: all that it
     * is joined to can walk there as well, at no more cost. So a place that has only such ones around goes on as if
     * there were no vaults: each of them would be reached from it at no less than the place beneath is.
     */
    private void findIdle() {
        int spans = widest.spanCount();
        int[] columns = widest.spans().columnAt();
        for (int q = 0; q < spans; q++) {
            if ((local[q] & 255) == 255 && widest.takesOff(q) && isEven(q, columns)) {
                local[q] |= IDLE;
            }
        }
        BitSet gaps = new BitSet(spans);
        for (int q = spans; q < widest.size(); q++) {
            if (widest.kind(q) == Kind.GAP) {
                int cell = widest.cell(q);
                for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
                    gaps.set(cell + offsets[d]);
                }
            }
        }
        for (int q = 0; q < spans; q++) {
            if ((local[q] & (IDLE | PLAIN)) == IDLE && !gaps.get(widest.cell(q)) && hasAround(q, IDLE)) {
                local[q] |= PLAIN | CALM;
            }
        }
    }

    /** Tells whether the nine columns around a place are the same, and its neighbours allow the same abilities. */
    private boolean isEven(int q, int[] columns) {
        int cell = widest.cell(q);
        boolean even = true;
        for (int d = 0; even && d < GridFrame.DIRECTIONS; d++) {
            even = columns[cell + offsets[d]] == columns[cell]
                    && (local[q + offsets[d]] >> ABILITIES & STANDING) == (local[q] >> ABILITIES & STANDING);
        }
        return even;
    }

    private boolean hasAround(int q, int bit) {
        boolean all = true;
        for (int d = 0; all && d < GridFrame.DIRECTIONS; d++) {
            all = (local[q + offsets[d]] & bit) != 0;
        }
        return all;
    }

    private int local(int q) {
        int moves = widest.moves(q);
        int abilities = widest.abilities(q);
        int bits = moves | (abilities & STANDING) << ABILITIES;
        if (widest.plain(q)) {
            bits |= PLAIN;
            boolean calm = moves == 255;
            for (int d = 0; calm && d < GridFrame.DIRECTIONS; d++) {
                calm = widest.abilities(q + offsets[d]) == abilities;
            }
            bits |= calm ? CALM : 0;
        }
        return bits;
    }

    /** Returns the region that the memory is for. */
    public Region region() {
        return region;
    }

    /** Hands the memory to a new search, empty, and returns the search's generation. */
    int begin(JourneyCosts costs) {
        if (generation == LAST_GENERATION) {
            Arrays.fill(toGoStamp, 0);
            chains.clear();
            generation = 0;
        }
        generation++;
        int shift = Math.max(0, costs.unitBits() - 6);
        if (queueBits != shift) {
            queueBits = shift;
            forward = new BucketQueue(shift, label -> labels.next(label) == DOMINATED);
            backward = new BucketQueue(shift, this::isSettled);
        }
        forward.clear();
        backward.clear();
        heap.clear();
        labels.clear();
        return generation;
    }

    /** Tells whether the cost to go from a configuration is known exactly. */
    boolean isSettled(int configuration) {
        return toGoStamp[configuration] == STAMPS * generation + SETTLED;
    }

    BucketQueue forward() {
        return forward;
    }

    BucketQueue backward() {
        return backward;
    }

    /** Asserts that no other search has taken the memory over since. */
    void check(int owner) {
        if (owner != generation) {
            throw new IllegalStateException("another search has taken over the workspace of this one");
        }
    }
}
