package troupe.crowd.ground;

import java.util.Arrays;
import java.util.stream.IntStream;
import troupe.grid.GridFrame;
import troupe.grid.field.Nf2;
import troupe.scene.Journey;

/**
 * Leads agents of one radius to one goal: down a potential, seen from some way ahead. The potential is NF2's (Crowd
 * section 3.3) until another is {@linkplain #set set}. The direction at a span is that of the farthest place down
 * the chain of lowest neighbours, within {@value #AHEAD} m, that a straight way reaches; it is found when first asked
 * for and kept. Deviation: the paper takes the lowest of the eight neighbours, which {@link #next} still tells.
 *
 * <p>Any thread may ask for directions at once (each finds the same value); setting a potential is for one thread
 * while no other asks.
 */
public final class Way {
    private static final double AHEAD = 4;
    private static final int UNKNOWN = -1;
    private static final byte UNSEEN = -2;
    private static final double RING = 0.1;

    private final Terrain terrain;
    private final int goal;
    /** The most steps down the chain. */
    private final int most;

    private final byte[] next;
    /** The distance left in metres of NF2, by which arrivals are judged. */
    private final float[] left;
    /** What is descended: NF2, or what was set last. */
    private final float[] potential;

    private final int[] towards;

    /** Takes the potential of NF2 to a goal, an open span. Cost O(spans). */
    Way(Terrain terrain, Nf2 nf2, int goal) {
        this.terrain = terrain;
        this.goal = goal;
        this.most = Math.max(2, (int) (AHEAD / terrain.region().frame().cell()));
        this.next = new byte[terrain.size()];
        this.left = new float[terrain.size()];
        this.towards = new int[terrain.size()];
        nf2.compute(goal, Journey.Spread.BREADTH);
        for (int q = 0; q < left.length; q++) {
            left[q] = terrain.open(q) ? (float) nf2.potential(q) : Float.POSITIVE_INFINITY;
        }
        this.potential = left.clone();
        descend();
        // the first potential is looked up at once, later ones where somebody comes
        for (int q = 0; q < next.length; q++) {
            next(q);
        }
    }

    private Way(Way other) {
        terrain = other.terrain;
        goal = other.goal;
        most = other.most;
        next = other.next.clone();
        left = other.left;
        potential = other.potential.clone();
        towards = other.towards.clone();
    }

    /** Returns a way of its own that begins with the potential of this one. */
    public Way copy() {
        return new Way(this);
    }

    /** Replaces the potential: metres or seconds for each span, infinite where the goal cannot be reached. */
    public void set(float[] values) {
        System.arraycopy(values, 0, potential, 0, potential.length);
        descend();
    }

    private void descend() {
        Arrays.fill(towards, UNKNOWN);
        Arrays.fill(next, UNSEEN);
    }

    private byte lowest(int q) {
        byte best = -1;
        float least = potential[q];
        if (least == Float.POSITIVE_INFINITY) {
            return -1;
        }
        for (byte d = 0; d < GridFrame.DIRECTIONS; d++) {
            int to = terrain.neighbour(q, d);
            if (to >= 0 && potential[to] < least) {
                least = potential[to];
                best = d;
            }
        }
        return best;
    }

    /** Returns the terrain. */
    public Terrain terrain() {
        return terrain;
    }

    /** Returns the span of the goal. */
    public int goal() {
        return goal;
    }

    /** Tells whether the goal can be reached from a span. */
    public boolean reaches(int q) {
        return left[q] != Float.POSITIVE_INFINITY;
    }

    /** Returns NF2's potential of a span in metres, whatever is set; 0 at the goal, infinite where it cannot be reached. */
    public float potential(int q) {
        return left[q];
    }

    /**
     * Returns the least potential of NF2 in metres within which there is so much ground; that of the farthest place if
     * there is less. Counted in steps of {@value #RING} m. Cost O(spans).
     *
     * @param area in square metres
     */
    public double holding(double area) {
        double most = 0;
        for (float value : left) {
            most = value == Float.POSITIVE_INFINITY ? most : Math.max(most, value);
        }
        int[] counts = new int[(int) (most / RING) + 1];
        for (float value : left) {
            if (value != Float.POSITIVE_INFINITY) {
                counts[(int) (value / RING)]++;
            }
        }
        double cell = terrain.region().frame().cell();
        double ground = 0;
        for (int ring = 0; ring < counts.length; ring++) {
            ground += counts[ring] * cell * cell;
            if (ground >= area) {
                return (ring + 1) * RING;
            }
        }
        return most;
    }

    /** Returns the spans within a potential of NF2 in metres, ascending; at least the goal. Cost O(spans). */
    public int[] around(double reach) {
        return IntStream.range(0, left.length)
                .filter(q -> q == goal || left[q] <= reach)
                .toArray();
    }

    /** Returns the direction of {@link GridFrame} to the lowest neighbour of a span, -1 at the goal. */
    public int next(int q) {
        byte known = next[q];
        if (known == UNSEEN) {
            known = lowest(q);
            next[q] = known;
        }
        return known;
    }

    /**
     * Returns the span to go for from a span: the farthest down the chain of lowest neighbours that a straight way
     * reaches; the span itself at the goal and where that cannot be reached.
     */
    public int towards(int q) {
        int known = towards[q];
        if (known == UNKNOWN) {
            known = look(q);
            towards[q] = known;
        }
        return known;
    }

    private int look(int q) {
        int[] chain = new int[most + 1];
        chain[0] = q;
        int steps = 0;
        int d = next(q);
        while (steps < most && d >= 0) {
            chain[steps + 1] = terrain.after(chain[steps], d);
            steps++;
            d = next(chain[steps]);
        }
        while (steps > 1 && !terrain.sees(q, chain[steps])) {
            steps = steps * 3 / 4;
        }
        return chain[steps];
    }
}
