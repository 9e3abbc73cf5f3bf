package troupe.grid.region.ground;

import java.util.BitSet;
import troupe.grid.layer.Spans;

/** Tells where a movable obstacle bars walking, without a region in which it stands there. Immutable. */
public final class WalkBar {
    private final Solid solid;
    private final Spans spans;
    private final BitSet cells = new BitSet();

    /** Stamps the cells that are too near to a solid. Cost O(cells near). */
    public WalkBar(Solid solid, Spans spans) {
        this.solid = solid;
        this.spans = spans;
        int[] runs = solid.cover();
        for (int i = 0; i < runs.length; i += 2) {
            cells.set(runs[i], runs[i + 1]);
        }
    }

    /** Tells whether one cannot walk on a span over a cell because of it. */
    public boolean bars(int q, int cell) {
        return cells.get(cell) && solid.blocks(spans.floor(q));
    }
}
