package troupe.crowd.flock;

/**
 * Finds the push sideways from those whom an agent would meet soon if it went down its path: the sooner, the stronger,
 * to the left of who passes on the right and the other way round, and to the right of who comes head on. Serves one
 * thread. Not in the paper, whose forces know distances only.
 */
final class Anticipation {
    /** Collisions further off in seconds than this are not looked at. */
    private static final double HORIZON = 3;
    /** Metres by which one wants to pass others clear. */
    private static final double CLEAR = 0.1;
    /** Two come against each other whose paths have a product below this. */
    private static final double OPPOSING = -0.2;
    /** The share of the sum of radii by which one passes on the right even somebody a little to the right. */
    private static final double BIAS = 0.7;
    /** The longest push. */
    private static final double MOST = 1.2;

    private final Cells cells;
    private final int[] met = new int[Sight.NEAR + 1];
    private final boolean[] opposes = new boolean[met.length];
    private final double[] wayX = new double[met.length];
    private final double[] wayY = new double[met.length];
    private final double[] along = new double[met.length];
    private final double[] root = new double[met.length];

    double asideX;
    double asideY;

    Anticipation(Cells cells) {
        this.cells = cells;
    }

    /** Finds the push on the agent at a place whose path has the direction {@code (pathX, pathY)}. */
    void look(int k, double pathX, double pathY, Sight s) {
        int count = meet(k, pathX, pathY, s);
        double pushX = 0;
        double pushY = 0;
        for (int c = 0; c < count; c++) {
            int m = met[c];
            double dx = s.nearX[m];
            double dy = s.nearY[m];
            double reach = s.nearReach[m] + CLEAR;
            double time = apart(dx, dy, reach) / (along[c] + Math.sqrt(root[c]));
            if (time >= HORIZON) {
                continue;
            }
            double urgency = (1 - time / HORIZON) * (1 - time / HORIZON);
            double side = wayX[c] * dy - wayY[c] * dx;
            double relative = wayX[c] * wayX[c] + wayY[c] * wayY[c];
            double bias = opposes[c] ? -BIAS * reach * Math.sqrt(relative) : 0;
            double right = side >= bias ? urgency : -urgency;
            pushX += right * pathY;
            pushY -= right * pathX;
        }
        double size = Math.sqrt(pushX * pushX + pushY * pushY);
        double scale = size > MOST ? MOST / size : 1;
        asideX = pushX * scale;
        asideY = pushY * scale;
    }

    /** Lists those near whom the agent comes to touch if all go on; returns their number. */
    private int meet(int k, double pathX, double pathY, Sight s) {
        double ownX = pathX * cells.topSpeed[k];
        double ownY = pathY * cells.topSpeed[k];
        int count = 0;
        for (int m = 0; m < s.nearCount; m++) {
            int j = s.near[m];
            double dx = s.nearX[m];
            double dy = s.nearY[m];
            boolean opposing = cells.pathX[j] * pathX + cells.pathY[j] * pathY < OPPOSING;
            int at = Cells.EXPECTED * j + (opposing ? Cells.COMING : 0);
            double wx = ownX - cells.expected[at];
            double wy = ownY - cells.expected[at + 1];
            double reach = s.nearReach[m] + CLEAR;
            double closing = wx * dx + wy * dy;
            double rest = closing * closing - (wx * wx + wy * wy) * apart(dx, dy, reach);
            // written in any case and counted if they meet: no branch to guess wrong
            met[count] = m;
            opposes[count] = opposing;
            wayX[count] = wx;
            wayY[count] = wy;
            along[count] = closing;
            root[count] = rest;
            count += (closing > 0 ? 1 : 0) & (rest > 0 ? 1 : 0);
        }
        return count;
    }

    private static double apart(double dx, double dy, double reach) {
        return Math.max(0, dx * dx + dy * dy - reach * reach);
    }
}
