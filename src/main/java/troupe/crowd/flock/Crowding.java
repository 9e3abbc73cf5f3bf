package troupe.crowd.flock;

import java.util.Arrays;
import troupe.crowd.ground.Detours;

/**
 * Measures how crowded and how slow each square of {@value #SQUARE} m is, and tells what that costs: the top speed over
 * the speed of people at that density (Weidmann 1993), or over the speed seen there, whichever is slower. Those who
 * have arrived do not count. Levels are told apart by storeys of {@value #STOREY} m.
 */
public final class Crowding {
    private static final double SQUARE = 1;
    private static final double STOREY = 2;
    private static final int STOREYS = 8;
    private static final double SLOWEST = 0.08;

    private final Agents agents;
    private final int cols;
    private final int rows;
    private final float[] count;
    private final float[] speed;
    private final float[] slowness;

    /** Makes room for a world of so many metres. */
    public Crowding(Agents agents, double width, double depth) {
        this.agents = agents;
        this.cols = (int) (width / SQUARE) + 1;
        this.rows = (int) (depth / SQUARE) + 1;
        count = new float[cols * rows * STOREYS];
        speed = new float[count.length];
        slowness = new float[count.length];
    }

    /**
     * Measures everybody but the members of a group.
     *
     * @param but the number of the group left out, -1 for none
     */
    public Detours.Slowness measure(int but) {
        Arrays.fill(count, 0);
        Arrays.fill(speed, 0);
        for (int i = 0; i < agents.count; i++) {
            if (agents.leaf[i] != but && agents.state[i] != Agents.ARRIVED) {
                int at = square(agents.x[i], agents.y[i], agents.z[i]);
                count[at]++;
                speed[at] += (float) (agents.speed[i] / agents.topSpeed[i]);
            }
        }
        for (int at = 0; at < count.length; at++) {
            slowness[at] = slow(at);
        }
        return (x, y, z) -> slowness[square(x, y, z)];
    }

    private int square(double x, double y, double z) {
        int storey = Math.max(0, Math.min(STOREYS - 1, (int) Math.floor(z / STOREY + 0.25)));
        int col = Math.max(0, Math.min(cols - 1, (int) (x / SQUARE)));
        int row = Math.max(0, Math.min(rows - 1, (int) (y / SQUARE)));
        return (storey * rows + row) * cols + col;
    }

    private float slow(int at) {
        if (count[at] < 1) {
            return 1;
        }
        double density = count[at] / (SQUARE * SQUARE);
        double expected = 1 - StrictMath.exp(-1.913 * (1 / density - 1 / 5.4));
        double seen = count[at] >= 2 ? speed[at] / count[at] : 1;
        return (float) (1 / Math.max(SLOWEST, Math.min(expected, seen)));
    }
}
