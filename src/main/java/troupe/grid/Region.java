package troupe.grid;

import troupe.scene.Actor;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Holds every configuration of one actor profile in a scene, its class, the abilities usable there, and
 * which steps between configurations are legal. Immutable; may be shared between threads.
 *
 * <p>A configuration is an int {@code q}: first the spans, {@code 0 <= q < spanCount()}, numbered
 * {@code sheet * frame().size() + cell}; then the crossings, {@code spanCount() <= q < size()}. A
 * configuration is open if some ability can be used there; the reachable region is the open ones.
 *
 * <p>Legal steps join open configurations of neighbouring cells. Between spans: floors within a step and
 * room for the body under both ceilings above the higher one; a diagonal needs both its straight
 * neighbours open and joined to both ends (on spans). Between a span and a crossing: the span's floor
 * within a step of the take-off floor. Between crossings: same kind, same take-off floor. A diagonal to or
 * from a crossing needs, over each straight neighbour, a span or crossing that is joined to both ends. The
 * relation is symmetric.
 */
public final class Region {
    /** The most legal neighbours that a configuration has. */
    public static final int MAX_NEIGHBOURS = 512;

    private final Actor actor;
    private final GridFrame frame;
    private final Spans spans;
    private final int cells;
    private final int spanCount;
    private final byte[] kinds;
    private final byte[] abilities;
    private final byte[] moves;
    private final int[] offsets;

    Region(Actor actor, Spans spans, Standing standing) {
        this.actor = actor;
        this.frame = spans.frame();
        this.spans = spans;
        this.cells = frame.size();
        this.spanCount = spans.size();
        this.kinds = standing.kinds();
        this.abilities = standing.abilities();
        this.offsets = frame.offsets();
        for (int q = 0; q < spanCount; q++) {
            if (abilities[q] == 0 && kinds[q] != Kind.ABSENT) {
                kinds[q] = Kind.FORBIDDEN;
            }
        }
        this.moves = Moves.compute(actor, spans, abilities);
    }

    /** Builds the region of an actor that has already lost the abilities which preferences switch off. */
    public static Region of(Scene scene, Actor actor) {
        return new RegionBuilder(scene, actor).region();
    }

    /** Returns the actor profile. */
    public Actor actor() {
        return actor;
    }

    /** Returns the frame. */
    public GridFrame frame() {
        return frame;
    }

    /** Returns the spans. */
    public Spans spans() {
        return spans;
    }

    /** Returns the number of span ids; ids from here on are crossings. */
    public int spanCount() {
        return spanCount;
    }

    /** Returns the number of configurations: spans and crossings. */
    public int size() {
        return spanCount;
    }

    /** Returns the cell over which a configuration lies. */
    public int cell(int q) {
        return q % cells;
    }

    /** Returns the x of a configuration in metres. */
    public double x(int q) {
        return frame.centreX(frame.col(cell(q)));
    }

    /** Returns the y of a configuration in metres. */
    public double y(int q) {
        return frame.centreY(frame.row(cell(q)));
    }

    /** Returns the elevation in metres: the floor of a span, NaN if absent; the take-off floor of a crossing. */
    public double elevation(int q) {
        return spans.floor(q);
    }

    /** Returns the class, one of {@link Kind}. */
    public byte kind(int q) {
        return kinds[q];
    }

    /** Returns the bit mask ({@link troupe.scene.Ability#bit}) of the abilities usable there; 0 where none is. */
    public int abilities(int q) {
        return abilities[q];
    }

    /** Tells whether some ability can be used there. */
    public boolean open(int q) {
        return abilities[q] != 0;
    }

    /**
     * Returns the directions (bit d for direction d of {@link GridFrame}) in which the legal neighbour of a
     * span is {@code q + offset(d)}, the span of the same sheet; 0 for a crossing.
     */
    public int moves(int q) {
        return moves[q] & 0xff;
    }

    /** Tells whether {@link #moves} gives all legal neighbours. */
    public boolean plain(int q) {
        return true;
    }

    /**
     * Finds all legal neighbours, ascending by direction, then id.
     *
     * @param targets receives the neighbours; at least {@link #MAX_NEIGHBOURS} long
     * @param directions receives the direction of each; as long
     * @return how many there are
     */
    public int neighbours(int q, int[] targets, int[] directions) {
        int count = 0;
        int mask = moves(q);
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            if ((mask >> d & 1) != 0) {
                targets[count] = q + offsets[d];
                directions[count++] = d;
            }
        }
        return count;
    }

    /**
     * Returns the configuration at a place: the span whose floor is nearest to {@code z} (the lower of two
     * equally near), without {@code z} the lowest; -1 if the cell holds no span.
     */
    public int locate(Place place) {
        int cell = frame.cellAt(place.x(), place.y());
        if (cell < 0) {
            return -1;
        }
        int best = -1;
        for (int q = cell; q < spanCount; q += cells) {
            if (spans.exists(q)
                    && (best < 0
                            || place.z().isPresent()
                                    && Math.abs(elevation(q) - place.z().getAsDouble())
                                            < Math.abs(
                                                    elevation(best) - place.z().getAsDouble()))) {
                best = q;
            }
        }
        return best;
    }
}
