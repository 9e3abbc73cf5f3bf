package troupe.unified;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import troupe.grid.GridLimitException;
import troupe.grid.field.Nf2;
import troupe.grid.layer.Layers;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.run.Engine;
import troupe.run.FrameRecorder;
import troupe.run.Frames;
import troupe.run.GridOverlays;
import troupe.run.Overlay;
import troupe.run.Run;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Ordering;
import troupe.scene.Scene;
import troupe.search.Outcome;
import troupe.unified.body.SweptBody;
import troupe.unified.motion.Motion;
import troupe.unified.motion.RouteBuilder;
import troupe.unified.search.JourneyCosts;
import troupe.unified.search.JourneyPath;
import troupe.unified.search.JourneyQuery;
import troupe.unified.search.JourneySearch;
import troupe.unified.search.JourneyWorkspace;

/**
 * Plans a journey: layers, region, where the ordering asks for it NF2, the search, and then the motion of
 * the actor along the smoothed way. If there is no way it finds out what a person could change.
 *
 * <p>A unit of work is an expansion of the search, those for the cost to go included, or the trial of one
 * change. What comes before the search is done in the first step and costs no work. The times in the report
 * are wall time; everything else depends on scene and journey only.
 */
public final class JourneyEngine implements Engine {
    private final Scene scene;
    private final Journey journey;
    private final Actor actor;
    private final JourneyCosts costs;
    private final StageTimes times = new StageTimes();

    private Outcome outcome = Outcome.RUNNING;
    private Layers layers;
    private Region region;
    private Nf2 nf2;
    private Standpoint start;
    private Standpoint goal;
    private JourneySearch search;
    private JourneyPath path;
    private Separation separation;
    private Motion.Recorded motion;
    private long trials;

    private JourneyEngine(Scene scene, Journey journey, Actor actor) {
        this.scene = scene;
        this.journey = journey;
        this.actor = actor;
        this.costs =
                new JourneyCosts(actor, journey.preferences(), scene.world().cell());
        this.motion =
                new Motion.Recorded(new FrameRecorder(Motion.RATE, Motion.channels(actor.id())).frames(), List.of());
    }

    /**
     * Prepares a journey of a scene; no work is done yet.
     *
     * @throws IllegalArgumentException if the scene lacks the actor, or the preferences take away walking
     */
    public static JourneyEngine of(Scene scene, Journey journey) {
        Actor whole = scene.actor(journey.actor())
                .orElseThrow(() -> new IllegalArgumentException("journey '" + journey.id() + "' is of the actor '"
                        + journey.actor() + "'; needs the id of an actor of the scene"));
        return new JourneyEngine(scene, journey, whole.under(journey.preferences()));
    }

    @Override
    public Outcome step(long budget) {
        if (budget < 1) {
            throw new IllegalArgumentException("budget=" + budget + "; needs at least 1");
        }
        if (region == null && outcome.isRunning()) {
            try {
                prepare();
            } catch (GridLimitException tooMuch) {
                outcome = new Outcome.Infeasible(tooMuch.getMessage());
            }
        }
        long left = budget;
        while (left > 0 && outcome.isRunning()) {
            left -= separation == null ? searchOn(left) : explainOn();
        }
        return outcome;
    }

    private void prepare() {
        RegionBuilder builder = new RegionBuilder(scene, actor);
        times.measure(StageTimes.LAYERS, () -> layers = builder.layers());
        times.measure(StageTimes.REGION, () -> region = builder.region());
        start = Standpoint.at(region, scene, journey.start(), "start");
        goal = Standpoint.at(region, scene, journey.goal(), "goal");
        if (start.configuration() < 0 || goal.configuration() < 0) {
            outcome = new Outcome.Infeasible(start.configuration() < 0 ? start.reason() : goal.reason());
            return;
        }
        JourneyQuery.Potential potential = JourneyQuery.Potential.NONE;
        if (journey.ordering() instanceof Ordering.Paper) {
            potential = field()::potential;
        }
        JourneyQuery query = new JourneyQuery(
                start.configuration(), goal.configuration(), journey.ordering(), potential, journey.expansions());
        times.measure(StageTimes.SEARCH, () -> search = new JourneySearch(new JourneyWorkspace(region), costs, query));
    }

    /** Returns the NF2 field of the goal, made when it is first asked for. */
    private Nf2 field() {
        if (nf2 == null) {
            times.measure(StageTimes.NF2, () -> nf2 = new Nf2(region).compute(goal.configuration(), journey.spread()));
        }
        return nf2;
    }

    private long searchOn(long budget) {
        long before = searched();
        times.measure(StageTimes.SEARCH, () -> search.step(budget));
        if (search.outcome() instanceof Outcome.Infeasible) {
            separation = new Separation(scene, journey, region, start.configuration(), goal.configuration());
            endIfExplained();
        } else {
            if (search.outcome().isFound()) {
                path = search.path().orElseThrow();
                travel();
            } else {
                outcome = search.outcome();
            }
        }
        return Math.max(1, searched() - before);
    }

    private void travel() {
        RouteBuilder builder = new RouteBuilder(region, costs, new SweptBody(scene, actor));
        Motion travelled = new Motion(actor, builder.route(path));
        if (travelled.leastSeconds() > Motion.LONGEST) {
            path = null;
            outcome = new Outcome.Infeasible(String.format(
                    Locale.ROOT,
                    "the way takes %.1f h, a run holds %.0f h; raise the speeds",
                    travelled.leastSeconds() / 3600,
                    Motion.LONGEST / 3600));
        } else {
            motion = travelled.record();
            outcome = Outcome.FOUND;
        }
    }

    private long explainOn() {
        separation.step();
        trials++;
        endIfExplained();
        return 1;
    }

    private void endIfExplained() {
        if (separation.isDone()) {
            outcome = new Outcome.Infeasible(separation.reason());
        }
    }

    private long searched() {
        return search == null ? 0 : search.expanded() + search.estimated();
    }

    @Override
    public Outcome outcome() {
        return outcome;
    }

    @Override
    public void cancel() {
        if (outcome.isRunning()) {
            outcome = Outcome.CANCELLED;
        }
    }

    @Override
    public Progress progress() {
        return new Progress(searched() + trials, outcome.isRunning() ? Double.NaN : 1);
    }

    @Override
    public List<Overlay> overlays() {
        if (region == null) {
            return List.of();
        }
        Nf2 potential = goal.configuration() < 0 ? null : field();
        GridOverlays grid = new GridOverlays(region, layers);
        List<Overlay> views = new ArrayList<>();
        GridOverlays.KEYS.forEach(key -> views.addAll(grid.of(key, potential)));
        if (search != null) {
            views.addAll(SearchEffort.of(region, layers, search));
        }
        return List.copyOf(views);
    }

    /** Returns the region that is searched, empty before the first step. */
    public Optional<Region> region() {
        return Optional.ofNullable(region);
    }

    /** Returns the way over the grid, empty unless one was found. */
    public Optional<JourneyPath> path() {
        return Optional.ofNullable(path);
    }

    @Override
    public Run run() {
        Frames frames = motion.frames();
        JourneyReport report = new JourneyReport(times, frames, motion.legs());
        if (search != null) {
            report.searched(search.expanded(), search.generated());
        }
        if (path != null) {
            report.found(path);
        }
        if (separation != null) {
            report.separated(
                    separation.reachedArea(),
                    separation.blockedBy(),
                    separation.blockedTogether(),
                    separation.wouldHelp());
        } else if (outcome instanceof Outcome.Infeasible && search == null && start != null) {
            List<String> ids = new ArrayList<>(start.blockedBy());
            ids.addAll(goal.blockedBy());
            report.separated(0, ids.stream().distinct().toList(), List.of(), List.of());
        }
        return new Run(scene, journey.id(), outcome, report.build(), frames, motion.legs(), List.of());
    }
}
