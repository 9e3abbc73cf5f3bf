package troupe.crowd.flock;

import troupe.crowd.ground.Way;

/**
 * Holds the state of all agents by field, each array indexed by the agent's number. Metres, seconds, radians; headings
 * as unit vectors. Written by one step at a time.
 */
public final class Agents {
    /** On its way. */
    public static final byte WALKING = 0;
    /** On its way, and hardly moved for a second. */
    public static final byte WAITING = 1;
    /** At its goal, where it stays. */
    public static final byte ARRIVED = 2;

    public final int count;
    public final double[] x;
    public final double[] y;
    public final double[] z;
    public final int[] span;
    public final double[] headingX;
    public final double[] headingY;
    public final double[] speed;
    public final double[] radius;
    public final double[] topSpeed;
    public final int[] leaf;
    public final Way[] way;
    /** What the span says on which an agent stands: whether it is roomy there, what is left to go, and where to. */
    final boolean[] roomy;

    final float[] left;
    /** The place that an agent goes for, and how many more spans it keeps to it. */
    final double[] targetX;

    final double[] targetY;
    final int[] keeps;

    /** The direction of each agent's path, a unit vector or 0. */
    final double[] pathX;

    final double[] pathY;
    /** The rank of each agent's goal: the higher has the right of way. */
    final long[] rank;

    /** The distance from the goal in metres of potential within which an agent may settle. */
    public final double[] near;

    public final byte[] state;
    /** The steps for which an agent has hardly moved. */
    public final int[] still;
    /** The lowest potential that an agent has come to, and the steps since then. */
    public final float[] lowest;

    public final int[] stalled;
    /** The steps for which an agent still gives way, going back; 0 if it does not. */
    public final int[] yielding;
    /** The step in which an agent arrived, -1 before. */
    public final int[] arrival;

    /** Makes room for so many agents. */
    public Agents(int count) {
        this.count = count;
        x = new double[count];
        y = new double[count];
        z = new double[count];
        span = new int[count];
        headingX = new double[count];
        headingY = new double[count];
        speed = new double[count];
        radius = new double[count];
        topSpeed = new double[count];
        leaf = new int[count];
        way = new Way[count];
        roomy = new boolean[count];
        left = new float[count];
        targetX = new double[count];
        targetY = new double[count];
        keeps = new int[count];
        pathX = new double[count];
        pathY = new double[count];
        rank = new long[count];
        near = new double[count];
        state = new byte[count];
        still = new int[count];
        lowest = new float[count];
        stalled = new int[count];
        yielding = new int[count];
        arrival = new int[count];
        java.util.Arrays.fill(lowest, Float.POSITIVE_INFINITY);
        java.util.Arrays.fill(arrival, -1);
    }
}
