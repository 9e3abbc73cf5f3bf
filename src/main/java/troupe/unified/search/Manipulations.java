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
import troupe.grid.region.Reach;
import troupe.grid.region.Region;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.cost.Moving;
import troupe.unified.manipulation.ConfigurationSpace;
import troupe.unified.manipulation.ExpectedPath;
import troupe.unified.manipulation.Instance;
import troupe.unified.manipulation.Question;
import troupe.unified.obstacle.Grip;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;

/**
 * Keeps the search spaces of a search and the manipulation instances in them. Which trigger points begin an instance follows from the fields alone, never
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
    private final TriggerTables tables;
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
        tables = new TriggerTables(moving, paths, base);
    }

    /** Returns the spaces in the order in which they arose. */
    List<SearchSpace> spaces() {
        return Collections.unmodifiableList(spaces);
    }

    /** Returns the attempts in the order in which they were made. */
    List<MoveAttempt> attempts() {
        return Collections.unmodifiableList(attempts);
    }

    /** Returns the space in which an attempt that has been found has put its obstacle; null if that would be one too many. */
    SearchSpace after(MoveAttempt attempt) {
        SearchSpace from = attempt.space();
        LatticePose pose = attempt.instance().transfer().last();
        List<LatticePose> key = from.key();
        key.set(attempt.movable(), pose);
        SearchSpace space = known.get(key);
        if (space == null && spaces.size() < moving.spaces()) {
            space = from.after(spaces.size(), attempt.movable(), pose, costs);
            spaces.add(space);
            known.put(key, space);
        }
        return space;
    }

    /** Tells whether something that has not been moved is so near to a configuration that it may be a trigger point. */
    boolean isNear(SearchSpace space, int configuration) {
        return tables.isNear(space, configuration);
    }

    /**
     * Returns the trigger points whose field must be exact before {@link #at} can answer for a configuration whose
     * own field is exact; none if it can. Each has a place in the guiding region, because it is a span. Of an
     * obstacle that the expected path from there misses the trigger points need not be known.
     */
    int[] wanted(SearchSpace space, int configuration) {
        int[] all = NOTHING;
        for (int m = 0; m < moving.movables().size(); m++) {
            int point = tables.point(space, m, configuration);
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
        for (int m = 0; m < moving.movables().size(); m++) {
            int point = tables.point(space, m, configuration);
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
            tables.group(m, table);
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
        for (int m = 0; m < moving.movables().size(); m++) {
            TriggerTable table = tables.inside(space, m, enclosure);
            if (table != null) {
                wanted = IntStream.concat(wanted, Arrays.stream(table.undecided(enclosure::holds)));
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
        for (int m = 0; m < moving.movables().size(); m++) {
            TriggerTable table = tables.inside(space, m, enclosure);
            for (int point = 0; table != null && point < table.points().length; point++) {
                int attempt = enclosure.holds(table.points()[point]) ? attempt(space, m, point) : TriggerTable.NONE;
                if (attempt >= 0) {
                    exit.at(table.points()[point], attempts.get(attempt));
                }
            }
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
