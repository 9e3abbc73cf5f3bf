package troupe.unified;

import java.util.List;
import java.util.Optional;
import troupe.grid.field.Nf2;
import troupe.grid.layer.Layers;
import troupe.grid.region.Groundworks;
import troupe.grid.region.Reach;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Ordering;
import troupe.scene.Scene;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.cost.JourneyQuery;
import troupe.unified.cost.Moving;
import troupe.unified.obstacle.Movable;
import troupe.unified.search.JourneySearch;
import troupe.unified.search.JourneyWorkspace;

/**
 * Makes ready what a search for a journey needs, stage by stage: spans, regions, the potential where the
 * ordering asks for it. Used by one thread at a time.
 */
final class Preparation {
    private final Scene scene;
    private final Journey journey;
    private final Actor actor;
    private final StageTimes times;
    private final Groundworks kept;
    private final List<Movable> movables;

    private RegionBuilder builder;
    private Region region;
    private Region widest;
    private Region open;
    private Standpoint start;
    private Standpoint goal;
    private Nf2 potential;

    /** What can be reached from the start, found while the widest region is built on another thread. */
    private Optional<Reach> around = Optional.empty();

    /**
     * Does nothing yet.
     *
     * @param actor the actor of the journey, already without the abilities that preferences switch off
     * @param kept what other plans have made that may fit this one
     */
    Preparation(Scene scene, Journey journey, Actor actor, StageTimes times, Groundworks kept) {
        this.scene = scene;
        this.journey = journey;
        this.actor = actor;
        this.times = times;
        this.kept = kept;
        this.movables = actor.move().isPresent() ? Movable.of(scene, journey.headings()) : List.of();
    }

    /**
     * Builds the regions, finds what hangs together with the start, and looks up start and goal.
     *
     * @throws troupe.grid.GridLimitException if the scene is too much for the grid
     */
    void build() {
        builder = new RegionBuilder(scene, actor, kept.of(scene, actor));
        times.measure(StageTimes.LAYERS, builder::spans);
        times.measure(StageTimes.REGION, () -> {
            builder.beginWidest();
            region = builder.region();
        });
        start = Standpoint.at(region, scene, journey.start(), "start");
        if (!movables.isEmpty() && start.configuration() >= 0 && !isPublished()) {
            times.measure(StageTimes.SEARCH, () -> {
                around = Optional.of(flooded());
                lookAhead();
            });
        }
        times.measure(StageTimes.REGION, () -> widest = movables.isEmpty() ? region : builder.widest());
        goal = Standpoint.at(widest, scene, journey.goal(), "goal");
    }

    /** Uses the time in which another thread builds the widest region: for regions that trigger points may ask for. */
    private void lookAhead() {
        for (Movable movable : movables) {
            if (builder.isBuildingWidest()) {
                region.without(movable.number());
            }
        }
    }

    private Reach flooded() {
        int end = region.locate(journey.goal());
        return end < 0 ? Reach.from(region, start.configuration()) : Reach.until(region, start.configuration(), end);
    }

    /** Tells whether {@link #build} has been called. */
    boolean isBuilt() {
        return goal != null;
    }

    /** Tells whether one can stand at start and goal, at the goal maybe only after something has been moved. */
    boolean isPossible() {
        return start.configuration() >= 0 && goal.configuration() >= 0;
    }

    /** Returns the obstacles that the actor may move. */
    List<Movable> movables() {
        return movables;
    }

    /** Returns the layers, numbered when they are first asked for: no plan needs them. */
    Layers layers() {
        return builder.layers();
    }

    /** Returns the region of the scene as it stands. */
    Region region() {
        return region;
    }

    /** Returns the region without the obstacles that the actor may move, built when it is first asked for. */
    Region open() {
        if (open == null) {
            open = movables.isEmpty() ? region : builder.bare();
        }
        return open;
    }

    Standpoint start() {
        return start;
    }

    Standpoint goal() {
        return goal;
    }

    /** Returns the NF2 field of the goal over the open region, made when it is first asked for. */
    Nf2 potential() {
        if (potential == null) {
            times.measure(StageTimes.NF2, () -> potential = field(journey.spread()));
        }
        return potential;
    }

    private Nf2 field(Journey.Spread spread) {
        return new Nf2(open()).compute(goal.configuration(), spread);
    }

    private boolean isPublished() {
        return journey.ordering() instanceof Ordering.Paper;
    }

    /** Makes the search; {@link #isPossible} must hold. */
    JourneySearch search(JourneyCosts costs, long expansions) {
        boolean published = isPublished();
        JourneyQuery.Potential guide = published ? potential()::potential : JourneyQuery.Potential.NONE;
        JourneyQuery query =
                new JourneyQuery(start.configuration(), goal.configuration(), journey.ordering(), guide, expansions);
        if (movables.isEmpty()) {
            return new JourneySearch(new JourneyWorkspace(region), costs, query);
        }
        JourneyQuery.Potential breadth = guide;
        if (published && journey.spread() != Journey.Spread.BREADTH) {
            breadth = field(Journey.Spread.BREADTH)::potential;
        }
        Moving moving = new Moving(
                Optional.of(scene),
                movables,
                journey.manipulation(),
                journey.slice(),
                journey.spaces(),
                published ? Optional.of(open()) : Optional.empty(),
                breadth);
        return new JourneySearch(new JourneyWorkspace(region, widest, around), costs, query, moving);
    }
}
