package troupe.unified.reference;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;

/**
 * Looks for the cheapest pose of an obstacle that bars no spot of an expected way, by uniform cost: every pose
 * is held against every spot. Of several cheapest it is that which leaves the actor nearest to the end of the
 * way, then that of the least heading, row, column. With a grip the actor is carried along.
 */
final class Attempt {
    private final Mover mover;
    private final Prices prices;
    private final List<Toward.Spot> way;
    private final Grip grip;
    private final Map<State, Node> nodes = new HashMap<>();
    private final PriorityQueue<Entry> open = new PriorityQueue<>(
            (a, b) -> a.cost != b.cost ? Long.compare(a.cost, b.cost) : Long.compare(a.number, b.number));
    private final double bodyHeight;
    private long inserted;
    private Node result;

    /** A pose, and where the actor stands then; the same place throughout if it does not hold the obstacle. */
    private record State(Mover.Pose pose, int stand) {}

    private record Entry(Node node, long cost, long number) {}

    /** A state that has been reached, at what cost. */
    private static final class Node {
        private final State state;
        private long cost;
        private boolean settled;

        Node(State state, long cost) {
            this.state = state;
            this.cost = cost;
        }
    }

    /**
     * Begins a search.
     *
     * @param grip how the actor moves along; null if it does not
     */
    Attempt(Mover mover, Prices prices, List<Toward.Spot> way, double bodyHeight, Grip grip, int trigger) {
        this.mover = mover;
        this.prices = prices;
        this.way = way;
        this.bodyHeight = bodyHeight;
        this.grip = grip;
        Node first = new Node(new State(new Mover.Pose(0, 0, 0), trigger), 0);
        nodes.put(first.state, first);
        open.add(new Entry(first, 0, inserted++));
    }

    /** Returns the number of the first spot that an obstacle at a pose is too near to, -1 if there is none. */
    static int firstCollision(Mover mover, Mover.Pose pose, List<Toward.Spot> way, double bodyHeight) {
        troupe.geometry.Polygon outline = mover.outline(pose);
        for (int n = 0; n < way.size(); n++) {
            Toward.Spot spot = way.get(n);
            if (Ground.meets(mover.obstacle.offset(), mover.obstacle.top(), spot.floor(), spot.floor() + bodyHeight)
                    && Shapes.distance(outline, spot.x(), spot.y()) < spot.radius() - 1e-9) {
                return n;
            }
        }
        return -1;
    }

    /** Returns the least that the result can cost: the cost once found, {@link Prices#NONE} once there is none. */
    long least() {
        if (result != null) {
            return result.cost;
        }
        return open.isEmpty() ? Prices.NONE : open.peek().cost;
    }

    /** Tells whether the result is known: the first in order of all that cost as little. */
    boolean isFound() {
        return result != null && (open.isEmpty() || open.peek().cost > result.cost);
    }

    private boolean precedes(State a, State b) {
        long[] first = {far(a.stand), a.pose.k(), a.pose.j(), a.pose.i(), a.stand};
        long[] second = {far(b.stand), b.pose.k(), b.pose.j(), b.pose.i(), b.stand};
        return Arrays.compare(first, second) < 0;
    }

    private long far(int stand) {
        return grip == null ? 0 : grip.far(stand, way.get(way.size() - 1).at());
    }

    Mover.Pose pose() {
        return result.state.pose;
    }

    int stand() {
        return result.state.stand;
    }

    /** Goes on until the result is found, there is none, or it costs more than a limit. */
    void advance(long most) {
        while (!isFound() && !open.isEmpty() && open.peek().cost <= most) {
            Entry entry = open.remove();
            Node node = entry.node;
            if (node.settled || entry.cost != node.cost) {
                continue;
            }
            node.settled = true;
            Mover.Pose pose = node.state.pose;
            if (firstCollision(mover, pose, way, bodyHeight) < 0
                    && (grip == null || grip.settles(pose, node.state.stand, way))) {
                result = result == null || precedes(node.state, result.state) ? node : result;
                continue;
            }
            for (int move = 0; move < 10; move++) {
                expand(node, move);
            }
        }
    }

    private void expand(Node node, int move) {
        Mover.Pose pose = node.state.pose;
        Mover.Pose next = mover.after(pose, move);
        if (next.equals(pose) || !mover.allows(pose, move)) {
            return;
        }
        double metres = move < 8 ? prices.metres(move) : 0;
        double radians = move < 8 ? 0 : mover.angle(1);
        long cost = node.cost + prices.moved(mover.obstacle.mass(), metres, radians);
        int stand = node.state.stand;
        if (grip != null) {
            Grip.Carried carried = grip.carried(pose, stand, move);
            if (carried == null) {
                return;
            }
            stand = carried.stand();
            cost += carried.straight() * prices.walked(prices.metres(0))
                    + carried.diagonal() * prices.walked(prices.metres(4));
        }
        State state = new State(next, stand);
        Node known = nodes.get(state);
        if (known == null) {
            known = new Node(state, cost);
            nodes.put(state, known);
        } else if (cost < known.cost) {
            known.cost = cost;
        } else {
            return;
        }
        open.add(new Entry(known, cost, inserted++));
    }
}
