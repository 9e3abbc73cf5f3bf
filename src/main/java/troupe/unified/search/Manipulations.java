package troupe.unified.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import troupe.geometry.Box;
import troupe.grid.GridFrame;
import troupe.grid.Window;
import troupe.grid.region.Reach;
import troupe.grid.region.Region;
import troupe.grid.region.Triggers;
import troupe.scene.Actor;
import troupe.unified.manipulation.ConfigurationSpace;
import troupe.unified.manipulation.ExpectedPath;
import troupe.unified.manipulation.Grip;
import troupe.unified.manipulation.Instance;
import troupe.unified.manipulation.LatticePose;
import troupe.unified.manipulation.Movable;
import troupe.unified.manipulation.Question;

/**
 * Keeps the search spaces of a search and the manipulation instances in them. Trigger points are found when
 * a label first comes near an obstacle; which of them begin an instance follows from the fields alone, never
 * from the order in which the search meets them:
 *
 * <ul>
 *   <li>{@code free}: one instance for all trigger points of an obstacle whose expected paths enter it at the
 *       same cell, with the path of the member of least field, then number;
 *   <li>{@code grip}: one instance for each trigger point of a hold.
 * </ul>
 *
 * <p>Equal poses of the moved obstacles make one space. The maps are only looked up, never iterated.
 */
final class Manipulations {
    private static final int[] NOTHING = {};

    private final Moving moving;
    private final JourneyCosts costs;
    private final ExpectedPaths paths;
    private final double margin;
    private final Window[] near;
    private final List<SearchSpace> spaces = new ArrayList<>();
    private final Map<List<LatticePose>, SearchSpace> known = new HashMap<>();
    private final List<MoveAttempt> attempts = new ArrayList<>();
    private final Map<Long, Expected> expected = new HashMap<>();

    /** An expected path, the spans on it, and the poses that bar it. */
    private record Expected(ExpectedPath path, BitSet places, ConfigurationSpace barred) {}

    Manipulations(Moving moving, JourneyCosts costs, ExpectedPaths paths, SearchSpace base) {
        this.moving = moving;
        this.costs = costs;
        this.paths = paths;
        spaces.add(base);
        known.put(base.key(), base);
        Actor actor = base.region().actor();
        GridFrame frame = base.region().frame();
        double reach = Math.max(
                actor.stride().map(Actor.Stride::gait).orElse(0.0),
                actor.vault().map(Actor.Vault::reach).orElse(0.0));
        double radius = Math.max(
                actor.walk().radius(),
                actor.sidestep().map(Actor.Sidestep::radius).orElse(0.0));
        margin = radius + reach + 3 * frame.cell();
        near = new Window[moving.movables().size()];
        for (int m = 0; m < near.length; m++) {
            Box box = moving.movables().get(m).obstacle().outline().bounds();
            near[m] = Window.of(frame, box.grown(margin));
        }
    }

    /** Returns the spaces in the order in which they arose. */
    List<SearchSpace> spaces() {
        return Collections.unmodifiableList(spaces);
    }

    /** Returns the attempts in the order in which they were made. */
    List<MoveAttempt> attempts() {
        return Collections.unmodifiableList(attempts);
    }

    /** Returns the space in which an attempt that has been found has put its obstacle. */
    SearchSpace after(MoveAttempt attempt) {
        SearchSpace from = attempt.space();
        LatticePose pose = attempt.instance().transfer().last();
        List<LatticePose> key = from.key();
        key.set(attempt.movable(), pose);
        SearchSpace space = known.get(key);
        if (space == null) {
            space = from.after(spaces.size(), attempt.movable(), pose, costs);
            spaces.add(space);
            known.put(key, space);
        }
        return space;
    }

    /** Tells whether something that has not been moved is so near to a configuration that it may be a trigger point. */
    boolean isNear(SearchSpace space, int configuration) {
        for (int m = 0; m < near.length; m++) {
            if (isNear(space, m, configuration)) {
                return true;
            }
        }
        return false;
    }

    private boolean isNear(SearchSpace space, int m, int configuration) {
        GridFrame frame = space.region().frame();
        int cell = space.region().cell(configuration);
        return near[m].holds(frame.col(cell), frame.row(cell)) && space.pose(m).isEmpty();
    }

    /**
     * Returns the trigger points whose field must be exact before {@link #at} can answer for a configuration whose
     * own field is exact; none if it can. Each has a place in the guiding region, because it is a span. Of an
     * obstacle that the expected path from there misses the trigger points need not be known.
     */
    int[] wanted(SearchSpace space, int configuration) {
        int[] all = NOTHING;
        for (int m = 0; m < near.length; m++) {
            int point = point(space, m, configuration);
            int[] wanted = point < 0 ? NOTHING : wanted(space.triggers(m), point);
            if (wanted.length > 0) {
                all = IntStream.concat(Arrays.stream(all), Arrays.stream(wanted))
                        .toArray();
            }
        }
        return all;
    }

    private static int[] wanted(TriggerTable table, int point) {
        int leader = table.leader(point);
        if (leader == TriggerTable.UNKNOWN) {
            return table.points();
        }
        return leader >= 0 && table.attempt(leader) == TriggerTable.UNKNOWN
                ? new int[] {table.points()[leader]}
                : NOTHING;
    }

    /** Fills {@code found} with the numbers of the attempts that begin at a configuration; returns how many there are. */
    int at(SearchSpace space, int configuration, int[] found) {
        int count = 0;
        for (int m = 0; m < near.length; m++) {
            int point = point(space, m, configuration);
            int attempt = point < 0 ? TriggerTable.NONE : attempt(space, m, point);
            if (attempt >= 0) {
                found[count++] = attempt;
            }
        }
        return count;
    }

    /** Returns the number of the attempt that begins at a trigger point, negative if there is none. */
    private int attempt(SearchSpace space, int m, int point) {
        TriggerTable table = space.triggers(m);
        if (table.leader(point) == TriggerTable.UNKNOWN) {
            group(m, table);
        }
        int leader = table.leader(point);
        if (leader >= 0 && table.attempt(leader) == TriggerTable.UNKNOWN) {
            table.setAttempt(leader, establish(space, m, table.points()[leader]));
        }
        return leader >= 0 ? table.attempt(leader) : TriggerTable.NONE;
    }

    /** Returns the trigger points whose field must be exact before {@link #exits} can answer for an enclosure. */
    int[] wanted(SearchSpace space, Enclosure enclosure) {
        IntStream wanted = IntStream.empty();
        for (int m = 0; m < near.length; m++) {
            TriggerTable table = inside(space, m, enclosure);
            if (table != null) {
                wanted = IntStream.concat(wanted, Arrays.stream(table.undecided()));
            }
        }
        return wanted.toArray();
    }

    /** Returns the attempts that begin in an enclosure. */
    List<MoveAttempt> exits(SearchSpace space, Enclosure enclosure) {
        Set<MoveAttempt> exits = new LinkedHashSet<>();
        eachExit(space, enclosure, (point, attempt) -> exits.add(attempt));
        return List.copyOf(exits);
    }

    /** Says how each trigger point of an enclosure leads out: a place of the space, and the attempt that begins there. */
    interface Exit {
        /** Takes one of them. */
        void at(int point, MoveAttempt attempt);
    }

    /** Hands on the trigger points from which an enclosure can be left, once its exits are known. */
    void eachExit(SearchSpace space, Enclosure enclosure, Exit exit) {
        for (int m = 0; m < near.length; m++) {
            TriggerTable table = inside(space, m, enclosure);
            for (int point = 0; table != null && point < table.points().length; point++) {
                int attempt = enclosure.holds(table.points()[point]) ? attempt(space, m, point) : TriggerTable.NONE;
                if (attempt >= 0) {
                    exit.at(table.points()[point], attempts.get(attempt));
                }
            }
        }
    }

    /** Returns the trigger points of a movable if it has not been moved and an enclosure comes near it, else null. */
    private TriggerTable inside(SearchSpace space, int m, Enclosure enclosure) {
        if (space.pose(m).isPresent() || !comesNear(space.region(), near[m], enclosure)) {
            return null;
        }
        if (space.triggers(m) == null) {
            space.setTriggers(m, table(space, m));
        }
        return space.triggers(m);
    }

    private static boolean comesNear(Region region, Window window, Enclosure enclosure) {
        GridFrame frame = region.frame();
        for (int row = window.row0(); row < window.row0() + window.rows(); row++) {
            for (int cell = frame.index(window.col0(), row), end = cell + window.cols(); cell < end; cell++) {
                for (int q = cell; q < region.spanCount(); q += frame.size()) {
                    if (enclosure.holds(q)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** Returns the place of a configuration among the trigger points of a movable, negative if it is none. */
    private int point(SearchSpace space, int m, int configuration) {
        if (!isNear(space, m, configuration)
                || !paths.dependOnSpace()
                        && !paths.meets(configuration, m, moving.movables().get(m))) {
            return -1;
        }
        if (space.triggers(m) == null) {
            space.setTriggers(m, table(space, m));
        }
        return space.triggers(m).find(configuration);
    }

    private TriggerTable table(SearchSpace space, int m) {
        TriggerTable before = space.before().map(from -> from.triggers(m)).orElse(null);
        if (before != null && isFar(space, m)) {
            return before.again(moving.grips() || !paths.dependOnSpace());
        }
        Movable movable = moving.movables().get(m);
        if (!space.surroundings().canMove(movable)) {
            return new TriggerTable(NOTHING);
        }
        TriggerTable table = new TriggerTable(triggers(space, m).points());
        if (moving.grips()) {
            table.leadByHolds(movable, space.region().frame());
        }
        return table;
    }

    /** Finds trigger points in regions that are the optimistic one near the obstacle only: what is far stays in place. */
    private Triggers triggers(SearchSpace space, int m) {
        Movable movable = moving.movables().get(m);
        int[] out = IntStream.range(0, near.length)
                .filter(other -> other == m || space.pose(other).isEmpty() && near[other].meets(near[m]))
                .map(other -> moving.movables().get(other).number())
                .toArray();
        boolean alone = out.length == 1;
        Region optimistic = alone ? space.without(m) : space.region().without(out);
        Region back = alone
                ? space.region()
                : optimistic.with(movable.number(), movable.obstacle().outline());
        return Triggers.of(space.region(), optimistic, back, movable.number(), near[m]);
    }

    /** Tells whether what was moved last, to make a space, was far from an obstacle before and is now. */
    private boolean isFar(SearchSpace space, int m) {
        SearchSpace from = space.before().orElseThrow();
        for (int other = 0; other < near.length; other++) {
            if (from.pose(other).isEmpty() && space.pose(other).isPresent()) {
                Movable moved = moving.movables().get(other);
                Box now = moved.outline(space.pose(other).get()).bounds();
                Window there = Window.of(space.region().frame(), now.grown(margin));
                if (near[other].meets(near[m]) || there.meets(near[m])) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Gives the trigger points whose paths enter the obstacle at the same cell their leader. */
    private void group(int m, TriggerTable table) {
        int[] points = table.points();
        Movable movable = moving.movables().get(m);
        Map<Integer, Integer> leaders = new HashMap<>();
        int[] entries = new int[points.length];
        for (int i = 0; i < points.length; i++) {
            int entry = paths.leads(points[i]) ? paths.entry(points[i], movable) : Descent.NONE;
            entries[i] = entry < 0 ? Descent.NONE : paths.cell(entry);
            Integer leader = leaders.get(entries[i]);
            if (leader == null || paths.rank(points[i]) < paths.rank(points[leader])) {
                leaders.put(entries[i], i);
            }
        }
        for (int i = 0; i < points.length; i++) {
            table.setLeader(i, entries[i] < 0 ? TriggerTable.NONE : leaders.get(entries[i]));
        }
    }

    /** Begins an attempt from a trigger point; returns its number, or none if its path misses the obstacle. */
    private int establish(SearchSpace space, int m, int trigger) {
        Optional<Expected> way = paths.leads(trigger) ? expected(space, m, trigger) : Optional.empty();
        if (way.isEmpty()) {
            return TriggerTable.NONE;
        }
        Movable movable = moving.movables().get(m);
        Optional<Grip> grip =
                moving.grips() ? Optional.of(grip(space, m, trigger, way.get().places())) : Optional.empty();
        Instance instance = new Instance(new Question(
                movable,
                space.surroundings(),
                way.get().barred(),
                costs.prices(movable.obstacle().mass(), movable.turn()),
                grip,
                trigger));
        MoveAttempt attempt = new MoveAttempt(
                space, m, movable, trigger, way.get().path(), way.get().barred(), instance);
        attempts.add(attempt);
        space.add(attempt);
        return attempts.size() - 1;
    }

    private Grip grip(SearchSpace space, int m, int trigger, BitSet places) {
        Movable movable = moving.movables().get(m);
        Region without = space.without(m);
        return new Grip(
                movable,
                space.surroundings(),
                without,
                trigger,
                (pose, stand) -> Reach.leads(without, movable.number(), movable.outline(pose), stand, places));
    }

    private Optional<Expected> expected(SearchSpace space, int m, int trigger) {
        long key = (long) m << 32 | trigger;
        Expected known = expected.get(key);
        if (known == null) {
            Movable movable = moving.movables().get(m);
            Optional<ExpectedPath> path = paths.from(space, trigger, movable);
            if (path.isEmpty()) {
                return Optional.empty();
            }
            known = new Expected(path.get(), paths.places(), new ConfigurationSpace(movable, path.get()));
            if (!paths.dependOnSpace()) {
                expected.put(key, known);
            }
        }
        return Optional.of(known);
    }
}
