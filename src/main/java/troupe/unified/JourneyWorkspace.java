package troupe.unified;

import java.util.Arrays;
import troupe.grid.GridFrame;
import troupe.grid.Region;
import troupe.search.BucketQueue;
import troupe.search.LabelPool;
import troupe.search.MinHeap;

/**
 * Holds the memory that searches over one region need, about 24 bytes per configuration, so that
 * thousands of problems share it: a generation stamp takes the place of clearing. One search at a time
 * owns it; the next one takes it over. Used by one thread at a time.
 */
public final class JourneyWorkspace {
    private static final int LAST_GENERATION = 1 << 29;

    final Region region;
    final int[] offsets;

    /** The cost to go in units, valid where {@link #toGoStamp} is of this generation. */
    final long[] toGo;

    /** Twice the generation where the cost to go is open, one more where it is settled. */
    final int[] toGoStamp;

    /** The first label of each configuration, valid where {@link #chainStamp} is of this generation. */
    final int[] chain;

    final int[] chainStamp;

    final LabelPool labels = new LabelPool(1024);
    final MinHeap heap = new MinHeap(1024);
    final int[] targets = new int[Region.MAX_NEIGHBOURS];
    final int[] directions = new int[Region.MAX_NEIGHBOURS];

    private BucketQueue forward;
    private BucketQueue backward;
    private int queueBits = -1;
    private int generation;

    /** Takes the memory for a region. Cost O(size of the region), once. */
    public JourneyWorkspace(Region region) {
        this.region = region;
        GridFrame frame = region.frame();
        offsets = frame.offsets();
        toGo = new long[region.size()];
        toGoStamp = new int[region.size()];
        chain = new int[region.size()];
        chainStamp = new int[region.size()];
    }

    /** Returns the region that the memory is for. */
    public Region region() {
        return region;
    }

    /** Hands the memory to a new search, empty, and returns the search's generation. */
    int begin(JourneyCosts costs) {
        if (generation == LAST_GENERATION) {
            Arrays.fill(toGoStamp, 0);
            Arrays.fill(chainStamp, 0);
            generation = 0;
        }
        generation++;
        int shift = Math.max(0, costs.unitBits() - 3);
        if (queueBits != shift) {
            queueBits = shift;
            forward = new BucketQueue(shift);
            backward = new BucketQueue(shift);
        }
        forward.clear();
        backward.clear();
        heap.clear();
        labels.clear();
        return generation;
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
