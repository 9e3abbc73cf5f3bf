package troupe.unified.search;

import java.util.Optional;
import troupe.grid.region.Reach;
import troupe.grid.region.Region;
import troupe.search.BucketQueue;
import troupe.search.LabelPool;
import troupe.search.MinHeap;
import troupe.unified.cost.FieldMemory;
import troupe.unified.cost.JourneyCosts;

/**
 * Holds the memory that searches over one region need, about 26 bytes per configuration, so that
 * thousands of problems share it: a generation stamp takes the place of clearing. One search at a time
 * owns it; the next one takes it over. Used by one thread at a time.
 */
public final class JourneyWorkspace {
    /** The next label of a label that has been dominated. */
    static final int DOMINATED = -2;

    final Region region;

    /** The region over which the cost to go is found. */
    final Region widest;

    /** What is known already to hang together in the region. */
    final Optional<Reach> around;

    final int[] offsets;

    /** The memory of the search for the cost to go. */
    final FieldMemory field;

    /** The first label of each configuration of the region. */
    final ChainTable chains;

    final LabelPool labels = new LabelPool(1024);
    final MinHeap heap = new MinHeap(1024);
    final int[] targets = new int[Region.MAX_NEIGHBOURS];
    final int[] directions = new int[Region.MAX_NEIGHBOURS];

    private BucketQueue forward;
    private int queueBits = -1;
    private int generation;

    /** Takes the memory for searches in which no obstacle is moved. Cost O(size of the region), once. */
    public JourneyWorkspace(Region region) {
        this(region, region, Optional.empty());
    }

    /**
     * Takes the memory for searches over a region and what it can be changed to.
     *
     * @param region the region of the scene as it stands
     * @param widest the region that holds every way over any search space, for the cost to go
     * @param around what is known already to hang together in the region as it stands
     */
    public JourneyWorkspace(Region region, Region widest, Optional<Reach> around) {
        this.region = region;
        this.widest = widest;
        this.around = around;
        offsets = region.frame().offsets();
        field = new FieldMemory(widest, widest != region);
        chains = new ChainTable(region.size());
    }

    /** Returns the region that the memory is for. */
    public Region region() {
        return region;
    }

    /** Hands the memory to a new search, empty, and returns the search's generation. */
    int begin(JourneyCosts costs) {
        if (generation == FieldMemory.LAST_GENERATION) {
            chains.clear();
            generation = 0;
        }
        generation++;
        int shift = costs.bucketBits();
        if (queueBits != shift) {
            queueBits = shift;
            forward = new BucketQueue(shift, label -> labels.next(label) == DOMINATED);
        }
        forward.clear();
        heap.clear();
        labels.clear();
        return generation;
    }

    BucketQueue forward() {
        return forward;
    }

    /** Asserts that no other search has taken the memory over since. */
    void check(int owner) {
        if (owner != generation) {
            throw new IllegalStateException("another search has taken over the workspace of this one");
        }
    }
}
