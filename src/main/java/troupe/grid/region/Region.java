package troupe.grid.region;

import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReferenceArray;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.Window;
import troupe.grid.layer.Column;
import troupe.grid.layer.Spans;
import troupe.grid.region.crossing.CrossingFinder;
import troupe.grid.region.crossing.Crossings;
import troupe.grid.region.crossing.Pruning;
import troupe.grid.region.crossing.Straight;
import troupe.grid.region.crossing.WidestVaults;
import troupe.grid.region.ground.Clearance;
import troupe.grid.region.ground.Kind;
import troupe.grid.region.ground.Solid;
import troupe.grid.region.ground.Structure;
import troupe.grid.region.ground.WalkBar;
import troupe.grid.region.ground.Words;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
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
public final class Region implements StepRelation {
    /** The most legal neighbours that a configuration has. */
    public static final int MAX_NEIGHBOURS = 512;

    /** More obstacles that stand elsewhere are not worth a patch. */
    private static final int MOST_PATCHED = 2;

    private final Structure structure;
    private final Solid[] movables;
    private final Actor actor;
    private final GridFrame frame;
    private final Spans spans;
    private final Words words;
    private final Crossings crossings;
    private final Clearance clearance;
    private final int cells;
    private final int spanCount;
    private final int[] offsets;
    private final TargetBand[] bands;
    private final TargetBand.Source source;
    private final AtomicReferenceArray<Region> without;

    /** Builds the region of a structure with movable obstacles where they stand; null where one is not there. */
    Region(Structure structure, Solid[] movables) {
        this(structure, movables, fresh(structure, movables, false));
    }

    /** Builds the region that bounds those of all placements of the movable obstacles of a structure. */
    static Region widest(Structure structure) {
        boolean relaxed = structure.actor().vault().isPresent();
        return new Region(structure, structure.none(), fresh(structure, structure.none(), relaxed));
    }

    private Region(Structure structure, Solid[] movables, Parts parts) {
        this.structure = structure;
        this.movables = movables;
        this.actor = structure.actor();
        this.spans = structure.spans();
        this.frame = spans.frame();
        this.cells = frame.size();
        this.spanCount = spans.size();
        this.offsets = frame.offsets();
        this.words = parts.words();
        this.crossings = parts.crossings();
        this.bands = parts.bands();
        this.clearance = new Clearance(structure, movables);
        this.without = new AtomicReferenceArray<>(movables.length);
        this.source = TargetBand.Source.of(words, crossings, parts.neighbours(), frame, spanCount);
    }

    /** What a region computes or shares. */
    private record Parts(Words words, Crossings crossings, Neighbours neighbours, TargetBand[] bands) {}

    private static Parts fresh(Structure structure, Solid[] movables, boolean relaxed) {
        Spans spans = structure.spans();
        GridFrame frame = spans.frame();
        Window whole = new Window(0, 0, frame.cols(), frame.rows());
        Words words = structure.standing().words();
        structure.standing().bar(movables, whole, words);
        Crossings crossings = Crossings.NONE;
        if (structure.crosses()) {
            CrossingFinder finder = new CrossingFinder(structure, movables, words);
            finder.findAll(!relaxed);
            long[] found = finder.found();
            crossings = new Crossings(
                    frame.size(), relaxed ? Crossings.merged(found, new WidestVaults(structure, words).find()) : found);
        }
        new Moves(spans, words, new Joints(structure.actor(), spans, words)).compute(whole);
        Neighbours neighbours = new Neighbours(structure.actor(), spans, crossings, words);
        neighbours.markNear(whole);
        TargetBand[] bands = new TargetBand[relaxed ? 0 : TargetBand.bands(frame)];
        Arrays.setAll(bands, band -> new TargetBand());
        return new Parts(words, crossings, neighbours, bands);
    }

    /** Returns the region of a scene that differs in the outlines of movable obstacles only; built anew if in many of them. */
    Region at(Structure other) {
        Solid[] there = other.movables();
        int moved = 0;
        for (int i = 0; i < there.length; i++) {
            if (there[i] != null && movables[i] != null && there[i].outline().equals(movables[i].outline())) {
                there[i] = movables[i];
            } else if (there[i] != null || movables[i] != null) {
                moved++;
            }
        }
        return moved > MOST_PATCHED ? new Region(other, there) : patched(other, there);
    }

    private Region patched(Structure other, Solid[] changed) {
        RegionPatch patch = new RegionPatch(other, movables, words, crossings, changed);
        patch.run();
        return new Region(
                other, changed, new Parts(patch.words(), patch.crossings(), patch.neighbours(), patch.bands(bands)));
    }

    /** Builds the region of an actor that has already lost the abilities which preferences switch off. */
    public static Region of(Scene scene, Actor actor) {
        return new RegionBuilder(scene, actor).region();
    }

    /**
     * Returns the region in which a movable obstacle stands at an outline, whether it was there before or not,
     * and everything else is as here.
     *
     * @param obstacle its index among the obstacles of the scene
     * @throws IllegalArgumentException if there is no movable obstacle of that index
     */
    public Region with(int obstacle, Polygon outline) {
        if (outline(obstacle).equals(Optional.of(outline))) {
            return this;
        }
        Solid[] changed = movables.clone();
        changed[obstacle] = structure.placed(obstacle, outline);
        return patched(structure, changed);
    }

    /**
     * Returns the region in which some movable obstacles are not there, and everything else is as here. That without a
     * single one is kept, because a search asks for it again.
     *
     * @param obstacles their indices among the obstacles of the scene
     * @throws IllegalArgumentException if there is no movable obstacle of such an index
     */
    public Region without(int... obstacles) {
        Solid[] changed = movables.clone();
        for (int obstacle : obstacles) {
            structure.movable(obstacle);
            changed[obstacle] = null;
        }
        if (Arrays.equals(changed, movables)) {
            return this;
        }
        if (obstacles.length > 1) {
            return patched(structure, changed);
        }
        if (without.get(obstacles[0]) == null) {
            without.compareAndSet(obstacles[0], null, patched(structure, changed));
        }
        return without.get(obstacles[0]);
    }

    /** Tells where a movable obstacle at an outline would bar walking. */
    WalkBar barred(int obstacle, Polygon outline) {
        return new WalkBar(structure.placed(obstacle, outline), spans);
    }

    /** Returns the region in which no movable obstacle is there. */
    public Region bare() {
        return patched(structure, new Solid[movables.length]);
    }

    /**
     * Returns where a movable obstacle stands, empty if it is not there.
     *
     * @param obstacle its index among the obstacles of the scene
     * @throws IllegalArgumentException if there is no movable obstacle of that index
     */
    public Optional<Polygon> outline(int obstacle) {
        structure.movable(obstacle);
        return Optional.ofNullable(movables[obstacle]).map(Solid::outline);
    }

    /**
     * Returns a movable obstacle as it is in the scene.
     *
     * @throws IllegalArgumentException if there is no movable obstacle of that index
     */
    Obstacle obstacle(int obstacle) {
        return structure.movable(obstacle);
    }

    /** Tells whether two elevations lie within a step of each other. */
    boolean steps(double a, double b) {
        return Math.abs(a - b) <= actor.stepHeight() + Column.SAME;
    }

    /**
     * Returns the open span over a cell whose floor lies within a step of an elevation, the lowest if there are
     * more; -1 if there is none. Cost O(sheets).
     */
    public int standing(int cell, double elevation) {
        for (int q = cell; q < spanCount; q += cells) {
            if (open(q) && steps(spans.floor(q), elevation)) {
                return q;
            }
        }
        return -1;
    }

    /** Returns the actor profile. */
    public Actor actor() {
        return actor;
    }

    /** Returns the frame. */
    @Override
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
    @Override
    public int size() {
        return spanCount + crossings.size();
    }

    /** Returns the cell over which a configuration lies. */
    @Override
    public int cell(int q) {
        if (q < cells) {
            return q;
        }
        return q < spanCount ? q % cells : crossings.cell(q - spanCount);
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
        return q < spanCount ? spans.floor(q) : spans.elevation(crossings.level(q - spanCount));
    }

    /**
     * Returns the number among {@link Spans#elevation} of a span's floor, or of a crossing's take-off floor; -1
     * if there is no such span. It is the same in all regions of a builder.
     */
    public int level(int q) {
        return q < spanCount ? spans.level(q) : crossings.level(q - spanCount);
    }

    /**
     * Returns the crossing over a cell of a take-off level and a kind, -1 if there is none. Regions number
     * their crossings each for itself; cell, level and kind name one in all regions of a builder.
     */
    public int crossing(int cell, int level, byte kind) {
        int found = crossings.find(cell, level, kind);
        return found < 0 ? -1 : spanCount + found;
    }

    /**
     * Returns the class, one of {@link Kind}. That of a span is the same in all regions of a builder: who is
     * barred by a movable obstacle finds it in {@link #open}, not here.
     */
    public byte kind(int q) {
        return q < spanCount ? Words.kind(words.get(q)) : crossings.kind(q - spanCount);
    }

    /** Returns the bit mask ({@link troupe.scene.Ability#bit}) of the abilities usable there; 0 where none is. */
    public int abilities(int q) {
        return q < spanCount ? words.get(q) & Words.STANDING : crossings.abilities(q - spanCount);
    }

    /** Tells whether some ability can be used there. */
    @Override
    public boolean open(int q) {
        return q >= spanCount || (words.get(q) & Words.STANDING) != 0;
    }

    /**
     * Returns the directions (bit d for direction d of {@link GridFrame}) in which the legal neighbour of a
     * span is {@code q + offset(d)}, the span of the same sheet; 0 for a crossing.
     */
    @Override
    public int moves(int q) {
        return q < spanCount ? words.get(q) >> Words.MOVES : 0;
    }

    /** Tells whether {@link #moves} gives all legal neighbours. */
    @Override
    public boolean plain(int q) {
        return q < spanCount && (words.get(q) & Words.SPECIAL) == 0;
    }

    /**
     * Finds all legal neighbours, ascending by direction, then id. Those that no mask gives are found for a band
     * of rows when the first of them is asked for; in the widest region, where few are asked for twice, each time.
     *
     * @param targets receives the neighbours; at least {@link #MAX_NEIGHBOURS} long
     * @param directions receives the direction of each; as long
     * @return how many there are
     */
    @Override
    public int neighbours(int q, int[] targets, int[] directions) {
        if (!plain(q)) {
            int cell = cell(q);
            int band = frame.row(cell) / TargetBand.ROWS;
            return bands.length == 0
                    ? source.neighbours().of(q, cell, targets, directions)
                    : bands[band].of(q, band, source, targets, directions);
        }
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
     * Finds the legal neighbours that share an edge with a configuration's cell, each time anew. A legal diagonal goes
     * with two straight steps to either side, so these reach as much as all neighbours do.
     */
    int beside(int q, int[] targets, int[] directions) {
        return source.neighbours().of(q, cell(q), GridFrame.DIRECTIONS / 2, targets, directions);
    }

    /**
     * Tells whether a straight crossing of a kind leads from one span to another: both stable and open to
     * walking, floors within a step, no further apart than the gait ({@link Kind#GAP}) or the reach
     * ({@link Kind#JUMPABLE}), and between the two cells only crossings of that kind from the floor of
     * {@code begin}, at least one. Cost O(length in cells).
     *
     * @throws IllegalArgumentException if the kind is neither
     */
    public boolean straight(int begin, int end, byte kind) {
        if (kind != Kind.GAP && kind != Kind.JUMPABLE) {
            throw new IllegalArgumentException("kind " + kind + "; needs GAP or JUMPABLE");
        }
        double limit = kind == Kind.GAP
                ? actor.stride().map(Actor.Stride::gait).orElse(0.0)
                : actor.vault().map(Actor.Vault::reach).orElse(0.0);
        if (begin == end || !takesOff(begin) || !takesOff(end)) {
            return false;
        }
        int dx = frame.col(cell(end)) - frame.col(cell(begin));
        int dy = frame.row(cell(end)) - frame.row(cell(begin));
        int level = spans.level(begin);
        return steps(elevation(begin), elevation(end))
                && (double) dx * dx + (double) dy * dy <= Pruning.squaredCells(limit, frame.cell())
                && (dx | dy) != 0
                && passes(cell(begin), dx, dy, level, kind);
    }

    /** Tells whether there is a cell between two ends, and over each of those a crossing of a level and kind. */
    private boolean passes(int begin, int dx, int dy, int level, byte kind) {
        Straight line = new Straight(begin, dx, dy, frame.cols());
        boolean any = false;
        while (line.next()) {
            if (crossings.find(line.at(), level, kind) < 0) {
                return false;
            }
            any = true;
        }
        return any;
    }

    /** Tells whether a configuration is a stable span on which one can walk: where crossings, and the moving of obstacles, begin and end. */
    public boolean takesOff(int q) {
        return q < spanCount && kind(q) == Kind.STABLE && (abilities(q) & Ability.WALK.bit()) != 0;
    }

    /**
     * Returns the distance in metres from the centre of a span's cell to the nearest solid that a standing
     * body would meet, or the world's edge; 0 where there is no span, and for a crossing. Exact up to the
     * largest radius and two cells; beyond, within 0.71 cells. The field is computed when it is first asked
     * for, O(cells) per floor elevation.
     */
    public float clearance(int q) {
        return q < spanCount ? clearance.of(q) : 0;
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
