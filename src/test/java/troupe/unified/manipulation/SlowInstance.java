package troupe.unified.manipulation;

import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.grid.GridFrame;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;
import troupe.unified.obstacle.SlowSweep;
import troupe.unified.obstacle.Surroundings;
import troupe.unified.obstacle.Sweeps;

/**
 * Answers the question of an instance by Dijkstra's algorithm over maps, with motions judged moment by
 * moment; only what is too close to tell that way is asked of the code under test.
 */
public final class SlowInstance {
    /** A pose and where the actor stands. */
    public record State(LatticePose pose, int stand) {}

    private record Entry(State state, long cost, long number) {}

    private final Scene scene;
    private final Question question;
    private final SlowGrip grip;
    private final Movable movable;
    private final SlowSweep moments;
    private final Sweeps exact;
    private final Map<State, Long> best = new HashMap<>();
    private final PriorityQueue<Entry> open =
            new PriorityQueue<>(Comparator.comparingLong(Entry::cost).thenComparingLong(Entry::number));
    private long number;
    long expanded;
    State found;

    SlowInstance(Scene scene, Question question, Optional<SlowGrip> grip) {
        this.scene = scene;
        this.question = question;
        this.grip = grip.orElse(null);
        this.movable = question.movable();
        this.moments = new SlowSweep(scene, movable);
        this.exact = new Surroundings(scene).sweeps(movable);
    }

    void solve() {
        add(new State(LatticePose.HOME, question.trigger()), 0);
        Set<State> closed = new HashSet<>();
        boolean stuck = moments.overlaps(movable.obstacle().outline());
        while (!open.isEmpty()) {
            Entry entry = open.poll();
            if (!closed.add(entry.state)) {
                continue;
            }
            if (found != null && entry.cost > cost()) {
                return;
            }
            expanded++;
            if (isFree(entry.state.pose) && (grip == null || grip.settles(entry.state))) {
                found = found == null || order().compare(entry.state, found) < 0 ? entry.state : found;
                continue;
            }
            for (int move = 0; move < 10 && !stuck; move++) {
                Entry next = after(entry.state, move);
                if (next != null) {
                    add(next.state, entry.cost + next.cost);
                }
            }
        }
    }

    long cost() {
        return best.get(found);
    }

    /** Returns what moves from pose to pose cost from the beginning on, -1 if one of them is not allowed. */
    long cost(List<LatticePose> poses) {
        State state = new State(LatticePose.HOME, question.trigger());
        long cost = 0;
        for (LatticePose pose : poses.subList(1, poses.size())) {
            Entry taken = null;
            for (int move = 0; move < 10 && taken == null; move++) {
                Entry next = after(state, move);
                taken = next != null && next.state.pose.equals(pose) ? next : null;
            }
            if (taken == null) {
                return -1;
            }
            state = taken.state;
            cost += taken.cost;
        }
        return cost;
    }

    /** Orders the cheapest poses: with a grip by how far the actor is from the end of its path; heading, row, column, stand. */
    private Comparator<State> order() {
        ExpectedPath path = question.barred().path();
        GridFrame frame = path.frame();
        int end = path.cell(path.size() - 1);
        return Comparator.comparingDouble((State s) -> {
                    int cell = s.stand % frame.size();
                    double columns = frame.col(cell) - frame.col(end);
                    double rows = frame.row(cell) - frame.row(end);
                    return grip == null ? 0 : columns * columns + rows * rows;
                })
                .thenComparingInt(s -> s.pose.k())
                .thenComparingInt(s -> s.pose.j())
                .thenComparingInt(s -> s.pose.i())
                .thenComparingInt(State::stand);
    }

    private boolean isFree(LatticePose pose) {
        Polygon outline = outline(pose);
        ExpectedPath path = question.barred().path();
        GridFrame frame = path.frame();
        for (int n = 0; n < path.size(); n++) {
            double x = frame.centreX(frame.col(path.cell(n)));
            double y = frame.centreY(frame.row(path.cell(n)));
            if (path.meets(n, movable) && outline.distance(x, y) < path.radius(n) - 1e-9) {
                return false;
            }
        }
        return true;
    }

    private Polygon outline(LatticePose pose) {
        return movable.obstacle().outline().at(pose(pose));
    }

    private Pose pose(LatticePose at) {
        return new Pose(
                movable.centroid().x() + at.i() * movable.cell(),
                movable.centroid().y() + at.j() * movable.cell(),
                at.k() * 2 * Math.PI / movable.headings());
    }

    /** Returns where a move leads and what it costs, null if it is not allowed. */
    private Entry after(State state, int move) {
        LatticePose from = state.pose;
        int headings = movable.headings();
        LatticePose to = move < 8
                ? new LatticePose(from.i() + GridFrame.dx(move), from.j() + GridFrame.dy(move), from.k())
                : new LatticePose(from.i(), from.j(), Math.floorMod(from.k() + (move == 8 ? 1 : -1), headings));
        if (!hasRoom(from, move) || !rests(to)) {
            return null;
        }
        Prices prices = question.prices();
        long cost = move < 4 ? prices.straight() : move < 8 ? prices.diagonal() : prices.turn();
        int stand = state.stand;
        if (grip != null) {
            SlowGrip.Walk walk = grip.walk(state, move);
            if (walk == null) {
                return null;
            }
            stand = walk.stand();
            cost += walk.straight() * prices.walkStraight() + walk.diagonal() * prices.walkDiagonal();
        }
        return new Entry(new State(to, stand), cost, 0);
    }

    private void add(State state, long cost) {
        if (!best.containsKey(state) || cost < best.get(state)) {
            best.put(state, cost);
            open.add(new Entry(state, cost, number++));
        }
    }

    private boolean hasRoom(LatticePose from, int move) {
        int sure = moments.judge(from, move);
        if (sure != 0) {
            return sure > 0;
        }
        exact.choose(from.i(), from.j(), from.k());
        return move < 8 ? exact.canShift(move) : exact.canTurn(move == 8);
    }

    private boolean rests(LatticePose at) {
        Pose pose = pose(at);
        Polygon shape = movable.obstacle().outline();
        var box = shape.bounds();
        int total = 0;
        int carried = 0;
        for (int n = 0; n < 256; n++) {
            double x = box.minX() + (n % 16 + 0.5) / 16 * (box.maxX() - box.minX());
            double y = box.minY() + (n / 16 + 0.5) / 16 * (box.maxY() - box.minY());
            if (shape.contains(x, y)) {
                double dx = x - movable.centroid().x();
                double dy = y - movable.centroid().y();
                double cos = Math.cos(pose.headingRad());
                double sin = Math.sin(pose.headingRad());
                total++;
                carried += carries(pose.x() + cos * dx - sin * dy, pose.y() + sin * dx + cos * dy) ? 1 : 0;
            }
        }
        return carries(pose.x(), pose.y()) && carried >= 0.6 * total - 1e-9;
    }

    private boolean carries(double x, double y) {
        double at = movable.obstacle().offset();
        double ground = 0;
        for (Ditch ditch : scene.ditches()) {
            ground = ditch.outline().contains(x, y) ? Math.min(ground, -ditch.depth()) : ground;
        }
        boolean carried = Math.abs(ground - at) < 1e-9;
        for (Obstacle o : scene.obstacles()) {
            carried |=
                    !o.movable() && Math.abs(o.top() - at) < 1e-9 && o.outline().contains(x, y);
        }
        return carried;
    }
}
