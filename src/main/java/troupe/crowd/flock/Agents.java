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

    /** The number of agents. */
    public final int count;
    /** Where each agent is, in metres. */
    public final double[] x;
    /** Where each agent is, in metres. */
    public final double[] y;
    /** The elevation of the floor under each agent, in metres. */
    public final double[] z;
    /** The span on which each agent stands. */
    public final int[] span;
    /** Where each agent faces, a unit vector. */
    public final double[] headingX;
    /** Where each agent faces, a unit vector. */
    public final double[] headingY;
    /** How fast each agent goes, in m/s. */
    public final double[] speed;
    /** The radius of each agent, in metres. */
    public final double[] radius;
    /** The most that each agent goes, in m/s. */
    public final double[] topSpeed;
    /** The group that each agent belongs to, in the order of the tree. */
    public final int[] leaf;
    /** What leads each agent to its goal. */
    public final Way[] way;
    /** What the span says on which an agent stands: whether it is roomy there, what is left to go, and where to. */
    final boolean[] roomy;
    /** Whether it stands in a door or the like, where nobody can pass it. */
    final boolean[] tight;

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

    /** {@link #WALKING}, {@link #WAITING} or {@link #ARRIVED}. */
    public final byte[] state;
    /** The steps for which an agent has hardly moved. */
    public final int[] still;
    /** The lowest potential that an agent has come to. */
    public final float[] lowest;

    /** The steps since an agent came to its lowest potential. */
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
        tight = new boolean[count];
        left = new float[count];
        targetX = new double[count];
        targetY = new double[count];
        keeps = new int[count];
        pathX = new double[count];
        pathY = new double[count];
        rank = new long[count];
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
