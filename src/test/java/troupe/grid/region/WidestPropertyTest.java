package troupe.grid.region;

import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Compares the cost to go over the widest region with what the cheapest ways cost wherever movable obstacles stand:
 * never more. Ways keep to the rules of steps, of straight crossings and of how long these may be; only what may be
 * travelled on borders is not limited, which makes them cheaper still.
 */
class WidestPropertyTest {
    private static final int SCENES = 80;
    private static final double FAR = 1e18;
    private static final int STANDING = 3;

    private int vaults;
    private int crossed;

    private record Entry(double cost, int q) {}

    @Test
    void costToGoOverTheWidestRegionBoundsEveryPlacement() {
        for (long seed = 1; seed <= SCENES; seed++) {
            double side = seed % 4 == 0 ? 7 : 4.5;
            Scene scene = MovableScenes.scene(seed, side, seed % 2 == 0 ? 0.2 : 0.25);
            Actor actor = MovableScenes.actor(seed);
            RegionBuilder builder = new RegionBuilder(scene, actor);
            Region widest = builder.widest();
            Random random = new Random(11 * seed);
            Costs costs = new Costs(actor, random);
            for (int placement = 0; placement < 3; placement++) {
                Region region = placed(builder.region(), scene, side, random);
                int goal = random.nextInt(region.spanCount());
                for (int k = 0; k < 50 && !region.open(goal); k++) {
                    goal = random.nextInt(region.spanCount());
                }
                if (region.open(goal)) {
                    compare("seed " + seed + " placement " + placement, region, widest, costs, goal);
                }
            }
        }
        assertTrue(vaults > 3000 && crossed > 300, "too few vaults: " + vaults + ", cheapest ways over " + crossed);
    }

    private static Region placed(Region region, Scene scene, double side, Random random) {
        Region placed = region;
        for (int i = 0; i < scene.obstacles().size(); i++) {
            Obstacle obstacle = scene.obstacles().get(i);
            if (obstacle.movable() && random.nextInt(4) > 0) {
                Polygon outline = MovableScenes.moved(obstacle.outline(), side, random);
                placed = random.nextInt(5) == 0 ? placed.without(i) : placed.with(i, outline);
            }
        }
        return placed;
    }

    /** Prices per metre and take-off, drawn so that a vault may be cheaper than walking. */
    private static final class Costs {
        private final double walk = 1;
        private final double sidestep;
        private final double vault;
        private final double vaultTakeOff;
        private final boolean vaults;

        Costs(Actor actor, Random random) {
            this.sidestep = 0.5 + 2 * random.nextDouble();
            this.vault = 0.3 + 2 * random.nextDouble();
            this.vaultTakeOff = random.nextBoolean() ? 0 : random.nextDouble();
            this.vaults = actor.vault().isPresent();
        }

        double standing(int common) {
            double cost = FAR;
            if ((common & Ability.WALK.bit()) != 0) {
                cost = walk;
            }
            return (common & Ability.SIDESTEP.bit()) != 0 ? Math.min(cost, sidestep) : cost;
        }

        double perMetre(byte kind) {
            return kind == Kind.GAP ? 1.5 : vault;
        }

        double takeOff(byte kind) {
            return kind == Kind.GAP ? 1 : vaultTakeOff;
        }
    }

    private void compare(String which, Region region, Region widest, Costs costs, int goal) {
        List<List<Jump>> jumps = jumps(region, costs);
        double[] bound = toGo(widest, null, costs, goal);
        double[] cost = toGo(region, jumps, costs, goal);
        for (int q = 0; q < region.spanCount(); q++) {
            assertTrue(
                    bound[q] <= cost[q] + 1e-6,
                    which + ": bound " + bound[q] + ", cost " + cost[q] + " from " + q + " to " + goal);
        }
        for (List<Jump> toEnd : jumps) {
            for (Jump jump : toEnd) {
                crossed += cost[jump.end()] < FAR && cost[jump.begin()] > cost[jump.end()] + jump.cost() - 1e-6 ? 1 : 0;
                for (int i = 0; i < jump.over().length; i++) {
                    int c = jump.over()[i];
                    double left = cost[jump.end()] + jump.cost() - jump.spent()[i];
                    assertTrue(boundOf(region, widest, bound, c) <= left + 1e-6, which + " on a crossing at " + c);
                }
            }
        }
    }

    /** Returns the bound of a crossing of another region. */
    private static double boundOf(Region region, Region widest, double[] bound, int c) {
        double least = FAR;
        int here = widest.crossing(region.cell(c), region.level(c), region.kind(c));
        if (here >= 0) {
            least = bound[here];
        }
        for (int q = region.cell(c); q < widest.spanCount(); q += widest.frame().size()) {
            if (widest.open(q) && widest.steps(widest.elevation(q), region.elevation(c))) {
                least = Math.min(least, bound[q]);
            }
        }
        return least;
    }

    /** A crossing from one span to another, the crossings passed, and what has been paid when each is reached. */
    private record Jump(int begin, int end, double cost, int[] over, double[] spent) {}

    /** Returns by the span where they end the cheapest jumps of a region from each span. */
    private List<List<Jump>> jumps(Region region, Costs costs) {
        List<List<Jump>> jumps = new ArrayList<>();
        for (int q = 0; q < region.spanCount(); q++) {
            jumps.add(new ArrayList<>());
        }
        for (int begin = 0; begin < region.spanCount(); begin++) {
            if (region.kind(begin) == Kind.STABLE && (region.abilities(begin) & Ability.WALK.bit()) != 0) {
                for (byte kind : new byte[] {Kind.GAP, Kind.JUMPABLE}) {
                    jumps(region, costs, begin, kind, jumps);
                }
            }
        }
        return jumps;
    }

    private void jumps(Region region, Costs costs, int begin, byte kind, List<List<Jump>> jumps) {
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        double limit = kind == Kind.GAP
                ? region.actor().stride().map(s -> s.maxGap()).orElse(0.0)
                : region.actor().vault().map(v -> v.maxJump()).orElse(0.0);
        java.util.TreeMap<Integer, Double> used = new java.util.TreeMap<>();
        java.util.TreeMap<Integer, Integer> from = new java.util.TreeMap<>();
        java.util.TreeMap<Integer, Jump> best = new java.util.TreeMap<>();
        PriorityQueue<Entry> open = new PriorityQueue<>(java.util.Comparator.comparingDouble(Entry::cost));
        open.add(new Entry(0, begin));
        while (!open.isEmpty()) {
            Entry entry = open.remove();
            int q = entry.q();
            if (q != begin && entry.cost() > used.get(q)) {
                continue;
            }
            int n = region.neighbours(q, targets, directions);
            for (int i = 0; i < n; i++) {
                int t = targets[i];
                double length = entry.cost() + region.frame().stepLength(directions[i]);
                if (t >= region.spanCount()) {
                    boolean entered = q != begin || region.elevation(t) == region.elevation(begin);
                    if (entered
                            && region.kind(t) == kind
                            && length <= limit + 1e-9
                            && length < used.getOrDefault(t, FAR)) {
                        used.put(t, length);
                        from.put(t, q);
                        open.add(new Entry(length, t));
                    }
                } else if (q != begin && region.straight(begin, t, kind)) {
                    double cost = costs.takeOff(kind) + length * costs.perMetre(kind);
                    if (!best.containsKey(t) || cost < best.get(t).cost()) {
                        best.put(t, jump(begin, t, cost, q, used, from, kind, costs));
                    }
                }
            }
        }
        for (Jump jump : best.values()) {
            vaults += kind == Kind.JUMPABLE ? 1 : 0;
            jumps.get(jump.end()).add(jump);
        }
    }

    private static Jump jump(
            int begin,
            int end,
            double cost,
            int last,
            java.util.TreeMap<Integer, Double> used,
            java.util.TreeMap<Integer, Integer> from,
            byte kind,
            Costs costs) {
        List<Integer> over = new ArrayList<>();
        for (int c = last; c != begin; c = from.get(c)) {
            over.add(c);
        }
        double[] spent = over.stream()
                .mapToDouble(c -> costs.takeOff(kind) + used.get(c) * costs.perMetre(kind))
                .toArray();
        return new Jump(begin, end, cost, over.stream().mapToInt(c -> c).toArray(), spent);
    }

    /**
     * Returns the cost to go: with jumps given, over steps between spans and these jumps, else over all legal steps
     * and with standing steps at no more than a vault's price.
     */
    private static double[] toGo(Region region, List<List<Jump>> jumps, Costs costs, int goal) {
        double[] toGo = new double[region.size()];
        Arrays.fill(toGo, FAR);
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        PriorityQueue<Entry> open = new PriorityQueue<>(java.util.Comparator.comparingDouble(Entry::cost));
        toGo[goal] = 0;
        open.add(new Entry(0, goal));
        while (!open.isEmpty()) {
            Entry entry = open.remove();
            int q = entry.q();
            if (entry.cost() > toGo[q]) {
                continue;
            }
            int n = region.neighbours(q, targets, directions);
            for (int i = 0; i < n; i++) {
                double step = step(region, jumps == null, costs, targets[i], q);
                improve(
                        toGo,
                        open,
                        targets[i],
                        entry.cost()
                                + step * region.frame().stepLength(directions[i])
                                + entry(region, costs, targets[i], q));
            }
            if (jumps != null && q < region.spanCount()) {
                for (Jump jump : jumps.get(q)) {
                    improve(toGo, open, jump.begin(), entry.cost() + jump.cost());
                }
            }
        }
        return toGo;
    }

    private static void improve(double[] toGo, PriorityQueue<Entry> open, int q, double cost) {
        if (cost < toGo[q] && cost < FAR) {
            toGo[q] = cost;
            open.add(new Entry(cost, q));
        }
    }

    /** Returns the price per metre of a step from one place to another. */
    private static double step(Region region, boolean relaxed, Costs costs, int from, int to) {
        boolean span = from < region.spanCount();
        if (span && to < region.spanCount()) {
            double price = costs.standing(region.abilities(from) & region.abilities(to) & STANDING);
            return relaxed && costs.vaults ? Math.min(price, costs.vault) : price;
        }
        if (!relaxed) {
            return FAR;
        }
        int crossing = span ? to : from;
        int stands = span ? from : to;
        if (span || to < region.spanCount()) {
            boolean stable = region.kind(stands) == Kind.STABLE
                    && (region.abilities(stands) & Ability.WALK.bit()) != 0
                    && (!span || region.elevation(from) == region.elevation(to));
            return stable ? costs.perMetre(region.kind(crossing)) : FAR;
        }
        return costs.perMetre(region.kind(crossing));
    }

    private static double entry(Region region, Costs costs, int from, int to) {
        return from < region.spanCount() && to >= region.spanCount() ? costs.takeOff(region.kind(to)) : 0;
    }

    @Test
    void isTheRegionItselfWhereNothingCanBeMoved() {
        Scene scene = MovableScenes.scene(3, 5, 0.25);
        Actor actor = MovableScenes.actor(3);
        RegionBuilder still = new RegionBuilder(scene, actor.without(Set.of(Ability.MOVE)));
        assertSame(still.region(), still.widest());
        RegionBuilder empty = new RegionBuilder(RandomScenes.flat(3, 5, 0.25, 4), actor);
        assertSame(empty.region(), empty.widest());
    }
}
