package troupe.grid.region.crossing;

/**
 * Walks the straight segment between two cell centres through the cells whose open inside it crosses, in
 * integers. A segment through the common corner of four cells crosses the two it comes from and goes to only.
 * The same cells are walked from either end. Short-lived, for one walk.
 */
public final class Straight {
    private final int twiceDx;
    private final int twiceDy;
    private final int stepX;
    private final int stepY;
    private final int end;
    private int at;
    private int side;

    /**
     * Begins a walk at index {@code begin} to the end that lies {@code dx} columns and {@code dy} rows
     * further, where a row is {@code stride} indices.
     */
    public Straight(int begin, int dx, int dy, int stride) {
        this.twiceDx = 2 * Math.abs(dx);
        this.twiceDy = 2 * Math.abs(dy);
        this.stepX = dx < 0 ? -1 : 1;
        this.stepY = dy < 0 ? -stride : stride;
        this.end = begin + dx + dy * stride;
        this.at = begin;
        this.side = Math.abs(dy) - Math.abs(dx);
    }

    /** Goes on to the next cell; returns whether that lies between the two ends. Not to be called at the end. */
    public boolean next() {
        int before = side;
        if (before <= 0) {
            side += twiceDy;
            at += stepX;
        }
        if (before >= 0) {
            side -= twiceDx;
            at += stepY;
        }
        return at != end;
    }

    /** Returns the index of the cell that the walk has come to. */
    public int at() {
        return at;
    }
}
