package troupe.unified.search;

import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import troupe.geometry.Box;
import troupe.grid.GridFrame;
import troupe.grid.Window;
import troupe.grid.region.Region;
import troupe.grid.region.Triggers;
import troupe.scene.Actor;
import troupe.unified.cost.Descent;
import troupe.unified.cost.Moving;
import troupe.unified.obstacle.Movable;

/**
 * Finds the trigger points of obstacles in search spaces, for each when they are first asked for: again only where
 * something near has changed. What they are follows from space and fields alone, never from the order of asking.
 */
final class TriggerTables {
    private static final int[] NOTHING = {};

    private final Moving moving;
    private final ExpectedPaths paths;
    private final double margin;
    private final Window[] near;

    /** Finds nothing yet; {@code base} is the scene as it stands. */
    TriggerTables(Moving moving, ExpectedPaths paths, SearchSpace base) {
        this.moving = moving;
        this.paths = paths;
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

    /** Returns the trigger points of a movable if it has not been moved and an enclosure comes near it, else null. */
    TriggerTable inside(SearchSpace space, int m, Enclosure enclosure) {
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
    int point(SearchSpace space, int m, int configuration) {
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
    void group(int m, TriggerTable table) {
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
}
