package troupe.crowd.ground;

import java.util.Arrays;
import troupe.grid.GridFrame;
import troupe.grid.layer.Column;
import troupe.grid.region.Region;
import troupe.scene.Actor;
import troupe.scene.Crowd;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Tells where agents of one radius can stand and how they can step: in the reachable region, within one span's legal
 * neighbours, and so that the disc keeps clear of every wall. Far from walls the clearance field decides, near them
 * the polygons do (Crowd section 3.4, which looks up a cell only). Immutable; serves any thread.
 */
public final class Terrain {
    /** Half the diagonal of a cell of edge 1, and a little for the rounding of the clearance field. */
    private static final double HALF_DIAGONAL = 0.7073;
    /** The bit of a span whose neighbours are listed one by one. */
    private static final int LISTED = 1 << 8;
    /** The bit of a span anywhere over whose cell the disc keeps clear of walls. */
    private static final int ROOMY = 1 << 9;
    /** The bit of a span whose floor is at elevation 0. */
    private static final int GROUND = 1 << 10;
    /** The bit of a span so near to walls that nobody can pass an agent there. */
    private static final int TIGHT = 1 << 11;

    /** The radii of clearance from which others can pass somebody. */
    private static final double PASSED = 4;

    private final Region region;
    private final GridFrame frame;
    private final Walls walls;
    private final double radius;
    private final double bodyHeight;
    private final double stepHeight;
    private final int cells;
    private final int[] offsets;
    private final float[] clearance;
    /** For each span the legal directions of a plain one as bits 0 to 7, and the bits below. */
    private final short[] legal;

    private final int[] slots;
    private int[] targets;

    /** Builds the region of a crowd's agents of one radius. Cost: that of a region and its clearance. */
    public Terrain(Scene scene, Crowd crowd, double radius) {
        this.radius = radius;
        this.bodyHeight = crowd.manner().bodyHeight();
        this.stepHeight = crowd.manner().stepHeight();
        this.region = Region.of(scene, body(crowd, radius));
        this.frame = region.frame();
        this.cells = frame.size();
        this.offsets = frame.offsets();
        this.walls = new Walls(scene, frame, radius);
        this.clearance = new float[region.spanCount()];
        this.legal = new short[clearance.length];
        int[] found = null;
        int special = 0;
        for (int q = 0; q < clearance.length; q++) {
            if (region.open(q)) {
                clearance[q] = region.clearance(q);
                legal[q] = (short) word(q);
                if (!region.plain(q)) {
                    found = found == null ? filled(clearance.length) : found;
                    found[q] = special++;
                }
            } else {
                clearance[q] = -1;
            }
        }
        this.slots = found;
        this.targets = new int[special * GridFrame.DIRECTIONS];
        if (found != null) {
            findTargets();
        }
    }

    private int word(int q) {
        int word = region.plain(q) ? region.moves(q) : LISTED;
        if (clearance[q] >= radius + HALF_DIAGONAL * frame.cell()) {
            word |= ROOMY;
        }
        if (clearance[q] < PASSED * radius) {
            word |= TIGHT;
        }
        return region.elevation(q) == 0 ? word | GROUND : word;
    }

    private static Actor body(Crowd crowd, double radius) {
        Actor plain = Actor.walker("agent", radius, Math.min(0.1, radius / 2));
        return new Actor(
                plain.id(),
                plain.label(),
                plain.colour(),
                crowd.manner().bodyHeight(),
                plain.footRadius(),
                crowd.manner().stepHeight(),
                plain.maxBorder(),
                plain.walk(),
                plain.sidestep(),
                plain.stride(),
                plain.vault(),
                plain.move());
    }

    private static int[] filled(int size) {
        int[] made = new int[size];
        Arrays.fill(made, -1);
        return made;
    }

    private void findTargets() {
        Arrays.fill(targets, -1);
        int[] found = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        for (int q = 0; q < slots.length; q++) {
            if (slots[q] >= 0) {
                int count = region.neighbours(q, found, directions);
                for (int k = 0; k < count; k++) {
                    targets[slots[q] * GridFrame.DIRECTIONS + directions[k]] = found[k];
                }
            }
        }
    }

    /** Returns the region. */
    public Region region() {
        return region;
    }

    /** Returns the radius in metres of the agents. */
    public double radius() {
        return radius;
    }

    /** Returns the number of spans; they are numbered as in the region. */
    public int size() {
        return clearance.length;
    }

    /** Tells whether an agent's centre may be over a span. */
    public boolean open(int q) {
        return clearance[q] >= 0;
    }

    /** Returns the clearance in metres at the centre of an open span's cell, -1 of a closed one. */
    public double clearance(int q) {
        return clearance[q];
    }

    /** Returns the elevation in metres of a span's floor. */
    public double elevation(int q) {
        return (legal[q] & GROUND) != 0 ? 0 : region.elevation(q);
    }

    /** Tells whether the disc keeps clear of walls wherever its centre is over a span's cell. */
    public boolean roomy(int q) {
        return (legal[q] & ROOMY) != 0;
    }

    /** Tells whether an agent over a span stands in a door or the like, where nobody can pass it. */
    public boolean tight(int q) {
        return (legal[q] & TIGHT) != 0;
    }

    /** Returns the open span that a step in a direction of {@link GridFrame} leads to, -1 if none is legal. */
    public int neighbour(int q, int d) {
        int word = legal[q];
        if ((word & LISTED) == 0) {
            return (word >> d & 1) == 0 ? -1 : q + offsets[d];
        }
        return targets[slots[q] * GridFrame.DIRECTIONS + d];
    }

    /** Returns the open span after a step that is known to be legal, as {@link #neighbour} does, but sooner. */
    int after(int q, int d) {
        return slots == null ? q + offsets[d] : neighbour(q, d);
    }

    /**
     * Returns the open span at a place where the disc keeps clear of walls, -1 if there is none.
     *
     * @param place in metres; without elevation the lowest floor counts
     */
    public int stand(Place place) {
        int q = region.locate(place);
        return q >= 0 && q < clearance.length && open(q) && clear(q, place.x(), place.y()) ? q : -1;
    }

    /**
     * Returns the span over which a disc comes to stand that moves from a span to {@code (x, y)} metres in at most
     * one cell's length; -1 if the step is not legal.
     *
     * @param roomy whether {@code q} is {@link #roomy}, which who moves knows without looking
     */
    public int step(int q, boolean roomy, double x, double y) {
        // no index is divided: a step leads at most one cell away, so the difference of the indices tells which way
        int apart = frame.index(frame.colAt(x), frame.rowAt(y)) - (q < cells ? q : q % cells);
        if (apart == 0) {
            return roomy || clear(q, x, y) ? q : -1;
        }
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            if (offsets[d] == apart) {
                int to = neighbour(q, d);
                return to >= 0 && clear(to, x, y) ? to : -1;
            }
        }
        return -1;
    }

    /** Returns the direction of {@link GridFrame} of a step of -1, 0 or 1 columns and rows, not both 0. */
    static int direction(int dc, int dr) {
        if (dr == 0) {
            return dc > 0 ? 0 : 2;
        }
        if (dc == 0) {
            return dr > 0 ? 1 : 3;
        }
        return dr > 0 ? dc > 0 ? 4 : 5 : dc > 0 ? 7 : 6;
    }

    private boolean clear(int q, double x, double y) {
        if (roomy(q)) {
            return true;
        }
        double floor = region.elevation(q);
        return walls.clear(
                q < cells ? q : q % cells,
                x,
                y,
                radius,
                floor + stepHeight + Column.SAME,
                floor + bodyHeight - Column.SAME);
    }

    /** Tells whether the straight way between two spans' cells leads over legal steps only. Cost O(its cells). */
    public boolean sees(int from, int to) {
        int a = from % cells;
        int b = to % cells;
        int col = frame.col(a);
        int row = frame.row(a);
        int dx = frame.col(b) - col;
        int dy = frame.row(b) - row;
        int steps = Math.max(Math.abs(dx), Math.abs(dy));
        int q = from;
        int atCol = 0;
        int atRow = 0;
        for (int k = 1; k <= steps; k++) {
            int nextCol = Math.floorDiv(2 * k * dx + steps, 2 * steps);
            int nextRow = Math.floorDiv(2 * k * dy + steps, 2 * steps);
            q = neighbour(q, direction(nextCol - atCol, nextRow - atRow));
            if (q < 0) {
                return false;
            }
            atCol = nextCol;
            atRow = nextRow;
        }
        return q == to;
    }
}
