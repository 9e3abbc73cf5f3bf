package troupe.unified;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import troupe.grid.GridLimitException;
import troupe.grid.region.Groundworks;
import troupe.grid.region.Region;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.run.view.Aspect;
import troupe.run.view.Overlay;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.search.Outcome;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.motion.Motion;
import troupe.unified.motion.RouteBuilder;
import troupe.unified.search.JourneyPath;
import troupe.unified.search.JourneySearch;

/**
 * Plans a journey: layers, region, where the ordering asks for it NF2, the search, and then the motion of
 * the actor along the smoothed way. If there is no way it finds out what a person could change.
 *
 * <p>A unit of work is an expansion of the search, those for the cost to go and the poses that manipulation instances
 * expand included, or the trial of one change. What comes before the search is done in the first step and costs no work. The times in the report
 * are wall time; everything else depends on scene and journey only.
 */
public final class JourneyEngine implements Engine {
    private final Scene scene;
    private final Journey journey;
    private final Actor actor;
    private final JourneyCosts costs;
    private final StageTimes times = new StageTimes();

    private Outcome outcome = Outcome.RUNNING;
    private final Preparation prepared;
    private JourneySearch search;
    private JourneyPath path;
    private Separation separation;
    private Motion.Recorded motion;
    private long trials;

    private JourneyEngine(Scene scene, Journey journey, Actor actor, Groundworks kept) {
        this.scene = scene;
        this.journey = journey;
        this.actor = actor;
        this.costs =
                new JourneyCosts(actor, journey.preferences(), scene.world().cell());
        this.prepared = new Preparation(scene, journey, actor, times, kept);
        this.motion = new Motion.Recorded(
                new FrameRecorder(Motion.RATE, Motion.channels(actor.id(), List.of())).frames(), List.of());
    }

    /**
     * Prepares a journey of a scene; no work is done yet.
     *
     * @throws IllegalArgumentException if the scene lacks the actor, or the preferences take away walking
     */
    public static JourneyEngine of(Scene scene, Journey journey) {
        return of(scene, journey, new Groundworks());
    }

    /**
     * Prepares a journey of a scene that shares what other plans have made of the same scene with its movable obstacles
     * elsewhere. The result is the same.
     *
     * @param kept what other plans have made
     * @throws IllegalArgumentException if the scene lacks the actor, or the preferences take away walking
     */
    public static JourneyEngine of(Scene scene, Journey journey, Groundworks kept) {
        Actor whole = scene.actor(journey.actor())
                .orElseThrow(() -> new IllegalArgumentException("journey '" + journey.id() + "' is of the actor '"
                        + journey.actor() + "'; needs the id of an actor of the scene"));
        return new JourneyEngine(scene, journey, whole.under(journey.preferences()), kept);
    }

    @Override
    public Outcome step(long budget) {
        if (budget < 1) {
            throw new IllegalArgumentException("budget=" + budget + "; needs at least 1");
        }
        if (!prepared.isBuilt() && outcome.isRunning()) {
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
        prepared.build();
        if (prepared.isPossible()) {
            times.measure(StageTimes.SEARCH, () -> search = prepared.search(costs, journey.expansions()));
        } else {
            Standpoint start = prepared.start();
            outcome = new Outcome.Infeasible(
                    start.configuration() < 0 ? start.reason() : prepared.goal().reason());
        }
    }

    private long searchOn(long budget) {
        long before = searched();
        times.measure(StageTimes.SEARCH, () -> search.step(budget));
        if (search.outcome() instanceof Outcome.Infeasible) {
            separation = new Separation(scene, journey, prepared);
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
        RouteBuilder builder = new RouteBuilder(scene, actor, costs);
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
        return search == null ? 0 : search.expanded() + search.estimated() + search.manipulated();
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
        return overlays(List.of());
    }

    @Override
    public List<Aspect> aspects(List<Integer> chosen) {
        return views().aspects(chosen);
    }

    @Override
    public List<Overlay> overlays(List<Integer> chosen) {
        return overlays(chosen, key -> true);
    }

    @Override
    public List<Overlay> overlays(List<Integer> chosen, Predicate<String> wanted) {
        return prepared.isBuilt() ? views().overlays(chosen, wanted) : List.of();
    }

    private JourneyViews views() {
        return new JourneyViews(prepared, Optional.ofNullable(search));
    }

    /** Returns the region that is searched, empty before the first step. */
    public Optional<Region> region() {
        return Optional.ofNullable(prepared.region());
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
            report.searched(search);
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
        } else if (outcome instanceof Outcome.Infeasible && search == null && prepared.isBuilt()) {
            List<String> ids = new ArrayList<>(prepared.start().blockedBy());
            ids.addAll(prepared.goal().blockedBy());
            report.separated(0, ids.stream().distinct().toList(), List.of(), List.of());
        }
        return new Run(scene, journey.id(), outcome, report.build(), frames, motion.legs(), List.of());
    }
}
