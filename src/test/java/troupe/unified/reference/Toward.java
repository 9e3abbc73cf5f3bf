package troupe.unified.reference;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.PriorityQueue;

/** Knows what it costs at least from anywhere to the goal, whatever is moved, and the way that one then expects. */
final class Toward {
    /** A place of an expected way: which and where, on which floor, and how much room is needed there. */
    record Spot(int configuration, int at, double x, double y, double floor, double radius) {}

    private final Space widest;
    private final Prices prices;
    private final int goal;
    private final double most;
    private final long[] least;

    /** Spreads from the goal; {@code most} caps the price of a metre between standing places. */
    Toward(Space widest, Prices prices, int goal, double most) {
        this.widest = widest;
        this.prices = prices;
        this.goal = goal;
        this.most = most;
        least = new long[widest.ground.size];
        Arrays.fill(least, Prices.NONE);
        PriorityQueue<long[]> open = new PriorityQueue<>((a, b) -> Long.compare(a[0], b[0]));
        least[goal] = 0;
        open.add(new long[] {0, goal});
        while (!open.isEmpty()) {
            long[] entry = open.remove();
            int to = (int) entry[1];
            if (entry[0] > least[to]) {
                continue;
            }
            for (Space.Step back : widest.steps(to)) {
                long step = prices.step(widest, back.to(), to, back.direction(), most);
                if (step < Prices.NONE && entry[0] + step < least[back.to()]) {
                    least[back.to()] = entry[0] + step;
                    open.add(new long[] {least[back.to()], back.to()});
                }
            }
        }
    }

    /** Returns the least cost to the goal, {@link Prices#NONE} if it cannot be reached. */
    long least(int q) {
        return least[q];
    }

    /** Returns the way down from a configuration: at each place the first step, by direction and number, that fits. */
    List<Spot> expected(int from) {
        List<Spot> way = new ArrayList<>();
        Ground ground = widest.ground;
        double walk = ground.actor.walk().radius();
        double radius = walk;
        int q = from;
        while (q != goal) {
            Space.Step next = next(q);
            boolean sidesteps = widest.isSpan(q) && widest.isSpan(next.to()) && !prices.walks(widest, q, next.to());
            radius = sidesteps ? ground.actor.sidestep().orElseThrow().radius() : walk;
            way.add(spot(q, radius));
            q = next.to();
        }
        way.add(spot(goal, radius));
        return way;
    }

    private Space.Step next(int q) {
        for (Space.Step step : widest.steps(q)) {
            long cost = prices.step(widest, q, step.to(), step.direction(), most);
            if (cost < Prices.NONE && cost + least[step.to()] == least[q]) {
                return step;
            }
        }
        throw new AssertionError("no way on from " + q);
    }

    private Spot spot(int q, double radius) {
        Ground ground = widest.ground;
        int at = ground.cellOf(q);
        return new Spot(q, at, ground.x(at), ground.y(at), ground.elevation(q), radius);
    }
}
