package troupe.unified.search;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import troupe.geometry.Polygon;
import troupe.grid.region.Reach;
import troupe.grid.region.Region;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.cost.LegalSteps;
import troupe.unified.cost.Moving;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;
import troupe.unified.obstacle.Surroundings;

/**
 * Holds the state of the scene after some obstacles have been moved, and what a search knows of it. What it
 * tells is immutable; the counts grow while the search works.
 */
public final class SearchSpace {
    private final Optional<SearchSpace> before;
    private final int number;
    private final Region region;
    private final Region guide;
    private final List<Movable> movables;
    private final LatticePose[] poses;
    private final Optional<Surroundings> surroundings;
    private final ChainTable chains;
    private final LegalSteps legal;
    private final List<MoveAttempt> attempts = new ArrayList<>();
    private final List<Enclosure> enclosures = new ArrayList<>();
    private final TriggerTable[] triggers;
    private long expanded;
    private long generated;

    /** The base space: every obstacle stands where the scene shows it. */
    SearchSpace(Region region, Region guide, Moving moving, ChainTable chains, JourneyCosts costs) {
        this(
                Optional.empty(),
                0,
                region,
                guide,
                moving.movables(),
                new LatticePose[moving.movables().size()],
                moving.scene().map(Surroundings::new),
                chains,
                costs);
    }

    private SearchSpace(
            Optional<SearchSpace> before,
            int number,
            Region region,
            Region guide,
            List<Movable> movables,
            LatticePose[] poses,
            Optional<Surroundings> surroundings,
            ChainTable chains,
            JourneyCosts costs) {
        this.before = before;
        this.number = number;
        this.region = region;
        this.guide = guide;
        this.movables = movables;
        this.poses = poses;
        this.surroundings = surroundings;
        this.chains = chains;
        this.legal = new LegalSteps(region, costs);
        this.triggers = new TriggerTable[movables.size()];
    }

    /** Returns the space in which one more obstacle has been moved. */
    SearchSpace after(int newNumber, int movable, LatticePose pose, JourneyCosts costs) {
        LatticePose[] changed = poses.clone();
        changed[movable] = pose;
        Movable moved = movables.get(movable);
        Polygon outline = moved.outline(pose);
        Region patched = without(movable).with(moved.number(), outline);
        return new SearchSpace(
                Optional.of(this),
                newNumber,
                patched,
                guide,
                movables,
                changed,
                surroundings.map(s -> s.with(moved.number(), outline)),
                new ChainTable(patched.size()),
                costs);
    }

    /** Returns its number among the spaces of a search, in the order in which they arose; 0 is the base. */
    public int number() {
        return number;
    }

    /** Returns its region. */
    public Region region() {
        return region;
    }

    /** Returns the pose to which a movable obstacle has been moved, by its place in the list of movables; empty if it has not. */
    public Optional<LatticePose> pose(int movable) {
        return Optional.ofNullable(poses[movable]);
    }

    /** Returns the movables that have been moved, ascending by number. */
    public List<Movable> moved() {
        List<Movable> moved = new ArrayList<>();
        for (int m = 0; m < poses.length; m++) {
            if (poses[m] != null) {
                moved.add(movables.get(m));
            }
        }
        return moved;
    }

    /** Returns what stands where in this space; there is something only where something may be moved. */
    Surroundings surroundings() {
        return surroundings.orElseThrow();
    }

    /** Returns the poses by which spaces are told apart, one for each movable, null for those not moved. */
    List<LatticePose> key() {
        List<LatticePose> key = new ArrayList<>();
        Collections.addAll(key, poses);
        return key;
    }

    /** Returns the space from which this one arose; empty for the base. */
    Optional<SearchSpace> before() {
        return before;
    }

    /** Returns the region without one movable obstacle. */
    Region without(int movable) {
        return region.without(movables.get(movable).number());
    }

    /**
     * Returns the configuration of the guiding region that stands for one of this space: the same span, or the
     * crossing over the same cell; -1 if there is none.
     */
    int guided(int configuration) {
        return configuration < region.spanCount() || region == guide
                ? configuration
                : guide.crossing(region.cell(configuration), region.level(configuration), region.kind(configuration));
    }

    /**
     * Returns the span of the guiding region on which a crossing of this space can be walked, because what is
     * crossed is not there; -1 if there is none, or the configuration is a span.
     */
    int beneath(int configuration) {
        if (configuration < region.spanCount() || region == guide) {
            return -1;
        }
        return guide.standing(region.cell(configuration), region.elevation(configuration));
    }

    /** Returns what a configuration hangs together with, if it is known. */
    Optional<Enclosure> enclosure(int configuration) {
        for (Enclosure enclosure : enclosures) {
            if (enclosure.holds(configuration)) {
                return Optional.of(enclosure);
            }
        }
        return Optional.empty();
    }

    /** Takes notice of configurations that hang together. */
    void know(Reach reach, int goal) {
        enclosures.add(new Enclosure(reach, goal));
    }

    /**
     * Returns what a configuration hangs together with; flooded if it is not known, the first time no farther than to the
     * goal.
     */
    Enclosure enclosure(int configuration, int goal) {
        return enclosure(configuration).orElseGet(() -> {
            Reach reach =
                    enclosures.isEmpty() ? Reach.until(region, configuration, goal) : Reach.from(region, configuration);
            Enclosure flooded = new Enclosure(reach, goal);
            enclosures.add(flooded);
            return flooded;
        });
    }

    ChainTable chains() {
        return chains;
    }

    LegalSteps legal() {
        return legal;
    }

    TriggerTable triggers(int movable) {
        return triggers[movable];
    }

    void setTriggers(int movable, TriggerTable table) {
        triggers[movable] = table;
    }

    void add(MoveAttempt attempt) {
        attempts.add(attempt);
    }

    /** Returns the manipulation instances that have been established in this space, in that order. */
    public List<MoveAttempt> attempts() {
        return Collections.unmodifiableList(attempts);
    }

    /** Returns the trigger points that are known of a movable, by its place in the list of movables; none before it was met. */
    public int[] triggerPoints(int movable) {
        return triggers[movable] == null
                ? new int[0]
                : triggers[movable].points().clone();
    }

    void countExpanded() {
        expanded++;
    }

    void countGenerated() {
        generated++;
    }

    /** Returns how many of its labels have been expanded, without those in manipulation. */
    public long expanded() {
        return expanded;
    }

    /** Returns how many labels it got, without those that were dominated when they were made and those in manipulation. */
    public long generated() {
        return generated;
    }
}
