package troupe.unified.reference;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.TreeMap;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Finds the least cost of a journey on which obstacles may be moved by trying everything: Dijkstra's algorithm
 * over search space, configuration, metres travelled on unstable places and where a crossing began, with every
 * manipulation that starts at a place that has been reached. Shares no code with the planner.
 */
final class ExhaustivePlanner {
    final Ground ground;
    private final Journey journey;
    private final Actor actor;
    private final Prices prices;
    private final boolean moves;
    private final Map<List<Answer.Moved>, World> worlds = new HashMap<>();
    private final PriorityQueue<Label> open = new PriorityQueue<>((a, b) -> Long.compare(a.key, b.key));
    private Toward toward;
    private int goal;

    /** A way to a configuration, or, with an attempt, the attempt being made there. */
    private record Label(
            World world, int at, double used, int begin, long cost, long key, Attempt attempt, int number) {}

    ExhaustivePlanner(Scene scene, Journey journey) {
        this.journey = journey;
        actor = scene.actor(journey.actor()).orElseThrow().under(journey.preferences());
        ground = new Ground(scene, actor);
        prices = new Prices(actor, journey.preferences(), ground.cell);
        moves = actor.move().isPresent() && scene.obstacles().stream().anyMatch(o -> o.movable());
    }

    /** Solves the journey of a scene. */
    static Answer solve(Scene scene, Journey journey) {
        return new ExhaustivePlanner(scene, journey).solve();
    }

    /** Solves the journey; once for each instance. */
    Answer solve() {
        int count = ground.scene.obstacles().size();
        Polygon[] outlines = new Polygon[count];
        for (int n = 0; n < count; n++) {
            outlines[n] = ground.scene.obstacles().get(n).movable()
                    ? ground.scene.obstacles().get(n).outline()
                    : null;
        }
        World base = new World(outlines, List.of());
        Space widest =
                moves ? Space.widest(ground, new Polygon[count], actor.vault().isPresent()) : base.space;
        int start = locate(journey.start());
        goal = locate(journey.goal());
        if (start < 0 || goal < 0 || !base.space.open(start) || !widest.open(goal)) {
            return new Answer(Double.POSITIVE_INFINITY, List.of(), 0);
        }
        double most = moves && actor.vault().isPresent() ? prices.vaultedMetre() : Double.POSITIVE_INFINITY;
        toward = new Toward(widest, prices, goal, most);
        worlds.put(base.moved, base);
        Label last = search(base, start, moves);
        return last == null
                ? new Answer(Double.POSITIVE_INFINITY, List.of(), worlds.size())
                : new Answer(Prices.joules(last.cost), last.world.moved, worlds.size());
    }

    /** Returns the first label at the goal, null if there is none. */
    private Label search(World from, int start, boolean moving) {
        open.clear();
        from.settled.clear();
        open.add(new Label(from, start, 0, -1, 0, 0, null, -1));
        while (!open.isEmpty()) {
            Label label = open.remove();
            if (label.attempt != null) {
                goOn(label);
            } else if (label.world.isNew(label)) {
                if (label.at == goal) {
                    return label;
                }
                expand(label, moving);
            }
        }
        return null;
    }

    /**
     * Tells whether, in every space that solving came to, the bound on the cost to go is none too high at every
     * {@code stride}-th place, and returns how many places were looked at.
     */
    int checkBounds(int stride) {
        int checked = 0;
        for (World world : worlds.values()) {
            for (int q = 0; q < ground.spanCount; q += stride) {
                Label last = world.space.firm(q) ? search(world, q, false) : null;
                if (last != null && toward.least(q) > last.cost) {
                    throw new AssertionError("from " + q + " with " + world.moved + ": " + Prices.joules(last.cost)
                            + ", at least " + Prices.joules(toward.least(q)));
                }
                checked += last == null ? 0 : 1;
            }
        }
        return checked;
    }

    /** Returns the span at a place, -1 if there is none within a step of it. */
    private int locate(Place place) {
        int at = ground.cellAt(place.x(), place.y());
        int best = -1;
        for (int q = at; q >= 0 && q < ground.spanCount; q += ground.cells) {
            double z = place.z().orElse(Double.NEGATIVE_INFINITY);
            boolean nearer = best < 0
                    || place.z().isPresent() && Math.abs(ground.floor[q] - z) < Math.abs(ground.floor[best] - z);
            best = ground.kind[q] != Ground.ABSENT && nearer ? q : best;
        }
        boolean carried =
                best >= 0 && Math.abs(place.z().orElse(ground.floor[best]) - ground.floor[best]) <= actor.stepHeight();
        return carried ? best : -1;
    }

    private void expand(Label label, boolean moving) {
        World world = label.world;
        if (moving && world.space.firm(label.at)) {
            world.attempts(label.at)
                    .forEach((attempt, number) -> open.add(new Label(
                            world, label.at, 0, -1, label.cost, label.cost + attempt.least(), attempt, number)));
        }
        for (Space.Step step : world.space.steps(label.at)) {
            long cost = prices.step(world.space, label.at, step.to(), step.direction(), Double.POSITIVE_INFINITY);
            if (cost < Prices.NONE) {
                step(label, step, cost);
            }
        }
    }

    private void step(Label label, Space.Step step, long cost) {
        Space space = label.world.space;
        int to = step.to();
        double used = label.used + prices.metres(step.direction());
        int begin = -1;
        double limit = Double.POSITIVE_INFINITY;
        if (!space.isSpan(to)) {
            begin = space.isSpan(label.at) ? label.at : label.begin;
            used = space.isSpan(label.at) ? prices.metres(step.direction()) : used;
            limit = ground.isVault(to)
                    ? actor.vault().orElseThrow().maxJump()
                    : actor.stride().orElseThrow().maxGap();
        } else if (!space.isSpan(label.at)) {
            if (!space.straight(label.begin, to, ground.isVault(label.at))) {
                return;
            }
            used = 0;
        } else if (ground.kind[to] == Ground.BORDER) {
            limit = actor.maxBorder();
        } else {
            used = 0;
        }
        if (used <= limit + 1e-9) {
            add(label.world, to, used, begin, label.cost + cost);
        }
    }

    private void add(World world, int at, double used, int begin, long cost) {
        open.add(new Label(world, at, used, begin, cost, cost, null, -1));
    }

    /** Works on an attempt until it is not the cheapest thing to do any more; then goes on where it led. */
    private void goOn(Label label) {
        Attempt attempt = label.attempt;
        attempt.advance(open.isEmpty() ? Prices.NONE : Math.max(attempt.least(), open.peek().key - label.cost));
        long key = label.cost + attempt.least();
        if (attempt.isFound()) {
            World after = label.world.after(label.number, attempt.pose());
            int at = journey.manipulation() == Journey.Manipulation.GRIP ? attempt.stand() : label.at;
            if (after.space.firm(at)) {
                add(after, at, 0, -1, key);
            }
        } else if (attempt.least() < Prices.NONE) {
            open.add(new Label(label.world, label.at, 0, -1, label.cost, key, attempt, label.number));
        }
    }

    /** A search space: what stands where after some obstacles have been moved, and what can be done there. */
    private final class World {
        private final Polygon[] outlines;
        private final List<Answer.Moved> moved;
        private final Space space;
        private final Map<Long, Double> settled = new HashMap<>();
        private Map<Integer, Map<Attempt, Integer>> attempts;

        World(Polygon[] outlines, List<Answer.Moved> moved) {
            this.outlines = outlines;
            this.moved = moved;
            space = new Space(ground, outlines);
        }

        /** Tells whether no label of the same place and crossing has come before that had travelled no further. */
        boolean isNew(Label label) {
            long key = (long) label.at << 32 | label.begin + 1;
            Double known = settled.get(key);
            if (known != null && known <= label.used + 1e-12) {
                return false;
            }
            settled.put(key, label.used);
            return true;
        }

        World after(int number, Mover.Pose pose) {
            Mover mover = new Mover(ground, number, outlines, journey.headings());
            List<Answer.Moved> all = new ArrayList<>(moved);
            all.add(new Answer.Moved(mover.obstacle.id(), pose));
            all.sort((a, b) -> a.obstacle().compareTo(b.obstacle()));
            return worlds.computeIfAbsent(all, k -> new World(Space.with(outlines, number, mover.outline(pose)), k));
        }

        /** Returns what can be tried at a place, with the obstacle that it moves. */
        Map<Attempt, Integer> attempts(int at) {
            if (attempts == null) {
                attempts = new TreeMap<>();
                Space optimistic = optimistic();
                for (int n = 0; n < outlines.length; n++) {
                    if (outlines[n] != null && !isMoved(n)) {
                        new Triggers(n, optimistic).find();
                    }
                }
            }
            return attempts.getOrDefault(at, Map.of());
        }

        private boolean isMoved(int n) {
            String id = ground.scene.obstacles().get(n).id();
            return moved.stream().anyMatch(m -> m.obstacle().equals(id));
        }

        private Space optimistic() {
            Polygon[] left = outlines.clone();
            for (int n = 0; n < left.length; n++) {
                left[n] = isMoved(n) ? left[n] : null;
            }
            return new Space(ground, left);
        }

        /** Finds where one obstacle can be taken hold of in this world, and which attempts begin there. */
        private final class Triggers {
            private final int number;
            private final Space optimistic;
            private final Mover mover;
            private final List<Integer> points = new ArrayList<>();

            Triggers(int number, Space optimistic) {
                this.number = number;
                this.optimistic = optimistic;
                mover = new Mover(ground, number, outlines, journey.headings());
            }

            void find() {
                Mover.Pose home = new Mover.Pose(0, 0, 0);
                if (!mover.isSupported(home) || carriesAnother()) {
                    return;
                }
                Space with = new Space(ground, Space.with(optimistic.outlines, number, outlines[number]));
                var lost = optimistic.lostIn(with);
                for (int q = 0; q < ground.spanCount; q++) {
                    double off = space.firm(q) ? Math.abs(ground.floor[q] - mover.obstacle.offset()) : 1e9;
                    boolean beside = false;
                    for (Space.Step step : off <= actor.stepHeight() + 1e-9 ? optimistic.steps(q) : new Space.Step[0]) {
                        beside |= lost.contains(step.to());
                    }
                    if (beside) {
                        points.add(q);
                    }
                }
                if (journey.manipulation() == Journey.Manipulation.GRIP) {
                    hold();
                } else {
                    group();
                }
            }

            private boolean carriesAnother() {
                for (int n = 0; n < outlines.length; n++) {
                    var other = ground.scene.obstacles().get(n);
                    Polygon outline = other.movable() ? outlines[n] : other.outline();
                    if (n != number
                            && Math.abs(other.offset() - mover.obstacle.top()) <= 1e-9
                            && Shapes.overlap(outline, outlines[number], 1e-9)) {
                        return true;
                    }
                }
                return false;
            }

            private int entry(int from) {
                List<Toward.Spot> way = toward.least(from) < Prices.NONE ? toward.expected(from) : List.of();
                int n = Attempt.firstCollision(mover, new Mover.Pose(0, 0, 0), way, actor.bodyHeight());
                return n < 0 ? -1 : way.get(n).at();
            }

            private void group() {
                Map<Integer, List<Integer>> groups = new TreeMap<>();
                for (int q : points) {
                    if (entry(q) >= 0) {
                        groups.computeIfAbsent(entry(q), k -> new ArrayList<>()).add(q);
                    }
                }
                for (List<Integer> members : groups.values()) {
                    int first = members.get(0);
                    for (int q : members) {
                        first = toward.least(q) < toward.least(first) ? q : first;
                    }
                    Attempt attempt =
                            new Attempt(mover, prices, toward.expected(first), actor.bodyHeight(), null, first);
                    members.forEach(q -> put(q, attempt));
                }
            }

            private void hold() {
                Space without = new Space(ground, Space.with(outlines, number, null));
                for (int q : held()) {
                    if (entry(q) >= 0) {
                        Grip grip = new Grip(without, mover, number, q);
                        put(q, new Attempt(mover, prices, toward.expected(q), actor.bodyHeight(), grip, q));
                    }
                }
            }

            private void put(int q, Attempt attempt) {
                attempts.computeIfAbsent(q, k -> new LinkedHashMap<>()).put(attempt, number);
            }

            /** Returns the points nearest to the holds, marks every 0.3 m along the outline. */
            private java.util.TreeSet<Integer> held() {
                java.util.TreeSet<Integer> held = new java.util.TreeSet<>();
                Polygon p = outlines[number];
                double before = 0;
                for (int i = 0; i < p.size(); i++) {
                    int j = (i + 1) % p.size();
                    double length = Math.hypot(p.x(j) - p.x(i), p.y(j) - p.y(i));
                    for (int mark = 0; mark * 0.3 < before + length - 1e-9; mark++) {
                        double share = (mark * 0.3 - before) / length;
                        if (share >= -1e-9 / length && !points.isEmpty()) {
                            held.add(nearest(p.x(i) + share * (p.x(j) - p.x(i)), p.y(i) + share * (p.y(j) - p.y(i))));
                        }
                    }
                    before += length;
                }
                return held;
            }

            private int nearest(double x, double y) {
                int nearest = -1;
                double least = Double.POSITIVE_INFINITY;
                for (int q : points) {
                    double dx = ground.x(ground.cellOf(q)) - x;
                    double dy = ground.y(ground.cellOf(q)) - y;
                    if (dx * dx + dy * dy < least) {
                        least = dx * dx + dy * dy;
                        nearest = q;
                    }
                }
                return nearest;
            }
        }
    }
}
