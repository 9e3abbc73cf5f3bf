package troupe.unified;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.GridLimitException;
import troupe.grid.region.Groundworks;
import troupe.grid.region.Reach;
import troupe.grid.region.Region;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Ordering;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.search.Outcome;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.search.JourneySearch;

/**
 * Finds out why there is no way, in words that a person can act on: how far the start reaches, and which
 * single change would open a way: an ability more, or an obstacle or ditch less. Each change is tried by a
 * search of its own, in a fixed order, at most {@value #MOST_OBSTACLES} obstacles and ditches: those that
 * stand both at what the start reaches and at what the goal reaches come first, and among those what can be
 * moved, then the smallest. Where no movable obstacle alone bars the way, those that bar it together are looked
 * for, if there are at most as many of them. Used by one thread at a
 * time; a call of {@link #step} costs a region and a search.
 */
final class Separation {
    static final int MOST_OBSTACLES = 24;
    private static final long MOST_EXPANSIONS = 500_000;
    private static final int MOST_NAMED = 3;

    /** What can be moved comes before what cannot, a small thing before a large one. */
    private static final Comparator<Element> SMALLEST_CHANGE = Comparator.<Element>comparingInt(
                    e -> e instanceof Obstacle o && o.movable() ? 0 : 1)
            .thenComparingDouble(e -> Math.abs(outline(e).signedArea()));

    private final Scene scene;
    private final Journey journey;
    private final Actor actor;
    private final Region region;
    private final double reachedArea;
    private final ArrayDeque<Trial> trials = new ArrayDeque<>();
    private final List<Element> blockers = new ArrayList<>();
    private final List<Obstacle> joint = new ArrayList<>();
    private final Set<Ability> helpful = EnumSet.noneOf(Ability.class);
    private boolean together;
    private boolean onlyPublished;

    /** A change to be tried. */
    private sealed interface Trial {}

    private record AsOptimal() implements Trial {}

    private record With(Ability ability) implements Trial {}

    private record WithAll() implements Trial {}

    private record Without(Element element) implements Trial {}

    private record WithoutMovables() implements Trial {}

    private record PutBack(Obstacle movable) implements Trial {}

    /**
     * Prepares the trials.
     *
     * @param prepared the search that found no way, its actor as the preferences leave it
     */
    Separation(Scene scene, Journey journey, Preparation prepared) {
        this.scene = scene;
        this.journey = journey;
        this.region = prepared.region();
        this.actor = region.actor();
        Reach fromStart = Reach.from(region, prepared.start().configuration());
        this.reachedArea = area(fromStart);
        if (journey.ordering() instanceof Ordering.Paper) {
            trials.add(new AsOptimal());
        }
        missing().forEach(a -> trials.add(new With(a)));
        Reach fromGoal = Reach.from(prepared.open(), prepared.goal().configuration());
        between(fromStart, fromGoal).forEach(e -> trials.add(new Without(e)));
        if (movables().size() > 1 && movables().size() <= MOST_OBSTACLES) {
            trials.add(new WithoutMovables());
        }
        if (missing().size() > 1) {
            trials.add(new WithAll());
        }
    }

    /** Returns the abilities that planning knows and the actor does not have here. */
    private List<Ability> missing() {
        return List.of(Ability.SIDESTEP, Ability.STRIDE, Ability.VAULT, Ability.MOVE).stream()
                .filter(a -> !actor.abilities().contains(a))
                .filter(a -> a != Ability.MOVE || !movables().isEmpty())
                .toList();
    }

    private List<Obstacle> movables() {
        return scene.obstacles().stream().filter(Obstacle::movable).toList();
    }

    private double area(Reach reach) {
        double cell = region.frame().cell();
        int spans = 0;
        for (int q = 0; q < region.spanCount(); q++) {
            spans += reach.reached(q) ? 1 : 0;
        }
        return spans * cell * cell;
    }

    /** Returns obstacles and ditches at the edge of what start or goal reaches, those at both first. */
    private List<Element> between(Reach fromStart, Reach fromGoal) {
        List<Element> both = new ArrayList<>();
        List<Element> one = new ArrayList<>();
        List<Element> elements = new ArrayList<>(scene.obstacles());
        elements.addAll(scene.ditches());
        for (Element element : elements) {
            boolean atStart = touches(element, fromStart);
            boolean atGoal = touches(element, fromGoal);
            if (atStart && atGoal) {
                both.add(element);
            } else if (atStart || atGoal) {
                one.add(element);
            }
        }
        both.sort(SMALLEST_CHANGE);
        one.sort(SMALLEST_CHANGE);
        both.addAll(one);
        return both.subList(0, Math.min(MOST_OBSTACLES, both.size()));
    }

    /** Tells whether an element limits a set: a reached place is hardly farther from it than the body is wide. */
    private boolean touches(Element element, Reach reach) {
        Polygon outline = outline(element);
        double margin = actor.walk().radius() + 2 * region.frame().cell();
        GridFrame frame = region.frame();
        int lastCol = Math.min(frame.cols() - 1, frame.colAt(outline.bounds().maxX() + margin));
        int lastRow = Math.min(frame.rows() - 1, frame.rowAt(outline.bounds().maxY() + margin));
        for (int row = Math.max(0, frame.rowAt(outline.bounds().minY() - margin)); row <= lastRow; row++) {
            for (int col = Math.max(0, frame.colAt(outline.bounds().minX() - margin)); col <= lastCol; col++) {
                for (int q = frame.index(col, row); q < region.spanCount(); q += frame.size()) {
                    if (reach.reached(q)
                            && limits(element, region.elevation(q))
                            && outline.distance(frame.centreX(col), frame.centreY(row)) < margin) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private static Polygon outline(Element element) {
        return element instanceof Obstacle o ? o.outline() : ((Ditch) element).outline();
    }

    private boolean limits(Element element, double floor) {
        if (element instanceof Obstacle o) {
            return o.offset() < floor + actor.bodyHeight() && o.top() > floor;
        }
        return true;
    }

    /** Tells whether nothing is left to be tried. */
    boolean isDone() {
        return trials.isEmpty();
    }

    /** Tries one more change. */
    void step() {
        Trial trial = trials.remove();
        if (trial instanceof AsOptimal) {
            onlyPublished = leads(scene, actor);
            if (onlyPublished) {
                trials.clear();
            }
        } else if (trial instanceof With with) {
            if (leads(scene, equipped(List.of(with.ability())))) {
                helpful.add(with.ability());
            }
        } else if (trial instanceof Without without) {
            if (blockers.size() < MOST_NAMED && leads(less(List.of(without.element())), actor)) {
                blockers.add(without.element());
            }
        } else if (trial instanceof WithoutMovables) {
            takeMovables();
        } else if (trial instanceof PutBack back) {
            List<Obstacle> others =
                    joint.stream().filter(m -> m != back.movable()).toList();
            if (leads(less(others), actor)) {
                joint.remove(back.movable());
            }
        } else if (helpful.isEmpty() && blockers.isEmpty() && joint.isEmpty() && leads(scene, equipped(missing()))) {
            helpful.addAll(missing());
            together = true;
        }
    }

    /** Takes all movable obstacles out if none alone was found to bar the way; each is then tried to be put back. */
    private void takeMovables() {
        boolean oneAlone = blockers.stream().anyMatch(e -> e instanceof Obstacle o && o.movable());
        if (oneAlone || !leads(less(movables()), actor)) {
            return;
        }
        joint.addAll(movables());
        for (int i = joint.size() - 1; i >= 0; i--) {
            trials.addFirst(new PutBack(joint.get(i)));
        }
    }

    private Scene less(List<? extends Element> taken) {
        return new Scene(
                scene.title(),
                scene.world(),
                scene.obstacles().stream().filter(o -> !taken.contains(o)).toList(),
                scene.ditches().stream().filter(d -> !taken.contains(d)).toList(),
                scene.actors(),
                scene.tasks());
    }

    /** Returns the actor with more abilities: as its own profile has them, else with the default numbers. */
    private Actor equipped(List<Ability> more) {
        Actor full = scene.actor(journey.actor()).orElseThrow();
        Actor standard = Actor.standard("");
        return new Actor(
                actor.id(),
                actor.label(),
                actor.colour(),
                actor.bodyHeight(),
                actor.footRadius(),
                actor.stepHeight(),
                actor.maxBorder(),
                actor.walk(),
                given(more, Ability.SIDESTEP, actor.sidestep(), full.sidestep(), standard.sidestep()),
                given(more, Ability.STRIDE, actor.stride(), full.stride(), standard.stride()),
                given(more, Ability.VAULT, actor.vault(), full.vault(), standard.vault()),
                given(more, Ability.MOVE, actor.move(), full.move(), standard.move()));
    }

    private static <T> Optional<T> given(
            List<Ability> more, Ability ability, Optional<T> has, Optional<T> own, Optional<T> standard) {
        return has.isPresent() || !more.contains(ability) ? has : own.isPresent() ? own : standard;
    }

    /** Tells whether a search finds a way after a change. */
    private boolean leads(Scene changed, Actor equipped) {
        Journey trial = journey.with(Ordering.OPTIMAL);
        Preparation other = new Preparation(changed, trial, equipped, new StageTimes(), new Groundworks());
        try {
            other.build();
        } catch (GridLimitException tooMuch) {
            return false;
        }
        if (!other.isPossible()) {
            return false;
        }
        JourneyCosts costs =
                new JourneyCosts(equipped, Preferences.NEUTRAL, changed.world().cell());
        JourneySearch search = other.search(costs, MOST_EXPANSIONS);
        Outcome outcome = search.outcome();
        while (outcome.isRunning()) {
            outcome = search.step(100_000);
        }
        return outcome.isFound();
    }

    /** Returns the square metres of floor that can be reached from the start. */
    double reachedArea() {
        return reachedArea;
    }

    /** Returns the ids of obstacles and ditches each of whose absence would open a way. */
    List<String> blockedBy() {
        return blockers.stream().map(Element::id).toList();
    }

    /** Returns the ids of movable obstacles that bar the way together: without all of them there is a way. */
    List<String> blockedTogether() {
        return joint.stream().map(Obstacle::id).toList();
    }

    /** Returns the keys of the abilities that would open a way. */
    List<String> wouldHelp() {
        return helpful.stream().map(Ability::key).toList();
    }

    /** Returns the reason in one line. */
    String reason() {
        if (onlyPublished) {
            return "no path in the published order, which marks places visited too early; ordering=optimal finds one";
        }
        Set<String> changes = new LinkedHashSet<>();
        if (!joint.isEmpty()) {
            changes.add(
                    "without " + joint.stream().map(e -> "'" + e.name() + "'").collect(Collectors.joining(" and ")));
        }
        if (!blockers.isEmpty()) {
            changes.add("without "
                    + blockers.stream().map(e -> "'" + e.name() + "'").collect(Collectors.joining(" or ")));
        }
        if (!helpful.isEmpty()) {
            changes.add("with "
                    + helpful.stream().map(Ability::key).collect(Collectors.joining(together ? " and " : " or ")));
        }
        String reached =
                String.format(Locale.ROOT, "no path: the start reaches %.1f m², but not the goal; ", reachedArea);
        return reached
                + (changes.isEmpty()
                        ? "no single obstacle or ability makes the difference"
                        : String.join(", or ", changes) + ", there is a way");
    }
}
