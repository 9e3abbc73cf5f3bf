package troupe.unified.search;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.PriorityQueue;
import java.util.Set;
import troupe.grid.region.Region;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Preferences;

/**
 * Finds the least cost of a journey by Dijkstra's algorithm over the whole state: the configuration, the
 * straight and diagonal steps travelled on unstable places, and where a crossing began. Slow and plain; it
 * shares nothing with the planner but the region, and decides for itself whether a crossing is straight.
 */
public final class SlowJourney {
    private static final double SLACK = 1e-9;

    private record State(int at, int straight, int diagonal, int begin) {}

    private record Entry(State state, double cost) {}

    private final Region region;
    private final Actor actor;
    private final Preferences preferences;
    private final boolean freely;
    private final double cell;
    private final Set<List<Object>> crossingCells = new HashSet<>();
    private final int[] targets = new int[Region.MAX_NEIGHBOURS];
    private final int[] directions = new int[Region.MAX_NEIGHBOURS];

    /** Prepares a reference; {@code freely} leaves out the limits and the straightness of crossings. */
    public SlowJourney(Region region, Preferences preferences, boolean freely) {
        this.region = region;
        this.actor = region.actor();
        this.preferences = preferences;
        this.freely = freely;
        cell = region.frame().cell();
        for (int q = region.spanCount(); q < region.size(); q++) {
            crossingCells.add(List.of(region.cell(q), region.elevation(q), region.kind(q)));
        }
    }

    /** Returns the least cost from start to goal, empty if there is no legal way. */
    public OptionalDouble leastCost(int start, int goal) {
        Map<State, Double> best = new HashMap<>();
        PriorityQueue<Entry> open = new PriorityQueue<>((a, b) -> Double.compare(a.cost, b.cost));
        State first = new State(start, 0, 0, -1);
        best.put(first, 0.0);
        open.add(new Entry(first, 0));
        while (!open.isEmpty()) {
            Entry entry = open.remove();
            if (entry.cost > best.get(entry.state)) {
                continue;
            }
            if (entry.state.at == goal) {
                return OptionalDouble.of(entry.cost);
            }
            int count = region.neighbours(entry.state.at, targets, directions);
            List<int[]> steps = new ArrayList<>();
            for (int i = 0; i < count; i++) {
                steps.add(new int[] {targets[i], directions[i]});
            }
            for (int[] step : steps) {
                State next = next(entry.state, step[0], step[1] >= 4);
                if (next != null) {
                    double cost = entry.cost + cost(entry.state.at, step[0], step[1] >= 4);
                    if (cost < best.getOrDefault(next, Double.POSITIVE_INFINITY)) {
                        best.put(next, cost);
                        open.add(new Entry(next, cost));
                    }
                }
            }
        }
        return OptionalDouble.empty();
    }

    /**
     * Follows a way step by step and returns its cost.
     *
     * @throws AssertionError if a step is not legal
     */
    double replay(int[] configurations) {
        State state = new State(configurations[0], 0, 0, -1);
        double cost = 0;
        for (int i = 1; i < configurations.length; i++) {
            int to = configurations[i];
            int direction = -1;
            int count = region.neighbours(state.at, targets, directions);
            for (int k = 0; k < count; k++) {
                direction = targets[k] == to ? directions[k] : direction;
            }
            State next = direction < 0 ? null : next(state, to, direction >= 4);
            if (next == null) {
                throw new AssertionError("step " + i + " from " + state + " to " + to + " is not legal");
            }
            cost += cost(state.at, to, direction >= 4);
            state = next;
        }
        if (state.begin >= 0) {
            throw new AssertionError("the way ends inside a crossing");
        }
        return cost;
    }

    private boolean isCrossing(int q) {
        return region.kind(q) == Kind.GAP || region.kind(q) == Kind.JUMPABLE;
    }

    private boolean bearsTakeOff(int q) {
        return region.kind(q) == Kind.STABLE && (region.abilities(q) & Ability.WALK.bit()) != 0;
    }

    /** Returns the state after a step, null if the step is not legal. */
    private State next(State state, int to, boolean diagonal) {
        int from = state.at;
        State travelled = new State(
                to,
                freely ? 0 : state.straight + (diagonal ? 0 : 1),
                freely ? 0 : state.diagonal + (diagonal ? 1 : 0),
                state.begin);
        double metres = (travelled.straight + travelled.diagonal * Math.sqrt(2)) * cell;
        if (isCrossing(to)) {
            double limit = region.kind(to) == Kind.GAP
                    ? actor.stride().orElseThrow().maxGap()
                    : actor.vault().orElseThrow().maxJump();
            boolean enters = !isCrossing(from);
            if (enters && !(bearsTakeOff(from) && region.elevation(from) == region.elevation(to))
                    || metres > limit + SLACK) {
                return null;
            }
            return new State(to, travelled.straight, travelled.diagonal, freely ? -1 : enters ? from : state.begin);
        }
        if (isCrossing(from)) {
            boolean lands = bearsTakeOff(to) && (freely || isStraight(state.begin, to, region.kind(from)));
            return lands ? new State(to, 0, 0, -1) : null;
        }
        if (Double.isInfinite(standingPrice(from, to))) {
            return null;
        }
        if (region.kind(to) == Kind.BORDER) {
            return metres > actor.maxBorder() + SLACK ? null : travelled;
        }
        return new State(to, 0, 0, -1);
    }

    private double cost(int from, int to, boolean diagonal) {
        double length = diagonal ? cell * Math.sqrt(2) : cell;
        int crossing = isCrossing(to) ? to : from;
        if (!isCrossing(crossing)) {
            return length * standingPrice(from, to);
        }
        boolean gap = region.kind(crossing) == Kind.GAP;
        double factor = preferences.of(gap ? Ability.STRIDE : Ability.VAULT);
        double energy = gap
                ? actor.stride().orElseThrow().energy()
                : actor.vault().orElseThrow().energy();
        double takeOff = gap
                ? actor.stride().orElseThrow().takeOff()
                : actor.vault().orElseThrow().takeOff();
        return factor * (length * energy + (isCrossing(to) && !isCrossing(from) ? takeOff : 0));
    }

    private double standingPrice(int from, int to) {
        int common = region.abilities(from) & region.abilities(to);
        double price = Double.POSITIVE_INFINITY;
        if ((common & Ability.WALK.bit()) != 0) {
            price = actor.walk().energy() * preferences.of(Ability.WALK);
        }
        if ((common & Ability.SIDESTEP.bit()) != 0) {
            price = Math.min(price, actor.sidestep().orElseThrow().energy() * preferences.of(Ability.SIDESTEP));
        }
        return price;
    }

    /** Tells whether the segment between two cell centres stays inside one crossing and is short enough. */
    private boolean isStraight(int begin, int end, byte kind) {
        double floor = region.elevation(begin);
        double reach = kind == Kind.GAP
                ? actor.stride().orElseThrow().gait()
                : actor.vault().orElseThrow().reach();
        double dx = region.x(end) - region.x(begin);
        double dy = region.y(end) - region.y(begin);
        if (Math.sqrt(dx * dx + dy * dy) > reach + SLACK
                || Math.abs(region.elevation(end) - floor) > actor.stepHeight() + SLACK) {
            return false;
        }
        for (int other = 0; other < region.frame().size(); other++) {
            boolean isEnd = other == region.cell(begin) || other == region.cell(end);
            if (!isEnd
                    && passes(region.x(begin), region.y(begin), dx, dy, other)
                    && !crossingCells.contains(List.of(other, floor, kind))) {
                return false;
            }
        }
        return true;
    }

    /** Tells whether a segment has a piece of some length inside a cell. */
    private boolean passes(double x, double y, double dx, double dy, int other) {
        double left = region.frame().centreX(region.frame().col(other)) - cell / 2;
        double low = region.frame().centreY(region.frame().row(other)) - cell / 2;
        double[] stretch = {0, 1};
        return clip(stretch, x, dx, left, left + cell)
                && clip(stretch, y, dy, low, low + cell)
                && (stretch[1] - stretch[0]) * Math.hypot(dx, dy) > 1e-7;
    }

    private static boolean clip(double[] stretch, double at, double delta, double low, double high) {
        if (Math.abs(delta) < 1e-12) {
            return at > low + 1e-9 && at < high - 1e-9;
        }
        double a = (low - at) / delta;
        double b = (high - at) / delta;
        stretch[0] = Math.max(stretch[0], Math.min(a, b));
        stretch[1] = Math.min(stretch[1], Math.max(a, b));
        return stretch[0] < stretch[1];
    }
}
