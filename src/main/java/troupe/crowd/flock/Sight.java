package troupe.crowd.flock;

import java.util.Arrays;
import troupe.scene.Crowd;

/**
 * Looks around for one agent after another: sums the three forces over those in view, and lists those near and those so
 * near that they might meet in the step to come. Serves one thread. Cost O(agents in the cells within view).
 *
 * <p>With p the places, h the headings, r the sum of radii and v the view distance, it sums separation {@code R_s
 * (r / d)^2} away from each, cohesion {@code R_c (p_j - p_i)} and alignment {@code R_a h_j} (Crowd sections 3.1 and
 * 3.2).
 */
final class Sight {
    /** Those who have arrived push so little, whoever they are, that others can settle beside them. */
    private static final double SETTLED_PUSH = 0.3;

    /** The share of the sum of radii within which somebody beside the way is in the way. */
    private static final double GRAZE = 0.7;

    /** Metres that an agent keeps from the one before it, so that no pack gets so dense that nobody can move. */
    private static final double COMFORT = 0.1;

    /** The most that are listed as near. */
    static final int NEAR = 96;

    private final Cells cells;
    private final Proposals out;
    private final byte[] depths;
    private final int leaves;
    private final double view;
    private final double nearHeight;
    private final double widest;
    private final double fastest;
    private final double[] kinSeparation;
    private final double[] kinCohesion;
    private final double[] kinAlignment;

    private int foundCount;
    private int[] found = new int[64];
    private double[] foundX = new double[64];
    private double[] foundY = new double[64];
    private double[] foundSquared = new double[64];

    double separationX;
    double separationY;
    double cohesionX;
    double cohesionY;
    double alignmentX;
    double alignmentY;
    /** How many are in view. */
    int seen;
    /** How many were looked at, over all agents. */
    long visits;

    /** The places of those near, and from the agent to them: dx, dy, the sum of radii, all in metres. */
    final int[] near = new int[NEAR];

    final double[] nearX = new double[NEAR];
    final double[] nearY = new double[NEAR];
    final double[] nearReach = new double[NEAR];
    int nearCount;
    /** Those before the agent: how far along its way, and half the chord that it cuts out of the sum of their discs, squared. */
    private final double[] aheadAlong = new double[NEAR + 1];

    private final double[] aheadHalf = new double[NEAR + 1];
    /** The most steps for which one of those near gives way. */
    int yielding;

    Sight(Cells cells, Proposals out, Bounds bounds, Pull pull) {
        this.cells = cells;
        this.out = out;
        this.depths = bounds.kin().depths();
        this.leaves = bounds.kin().leaves().size();
        this.view = bounds.view();
        this.nearHeight = bounds.nearHeight();
        this.widest = bounds.widest();
        this.fastest = bounds.fastest();
        this.kinSeparation = pull.kinSeparation;
        this.kinCohesion = pull.kinCohesion;
        this.kinAlignment = pull.kinAlignment;
    }

    /**
     * Holds what stays the same for all looks of a crowd.
     *
     * @param view the view distance in metres
     * @param nearHeight the difference in elevation in metres from which two do not meet
     * @param widest the largest radius of any agent in metres
     * @param fastest the highest speed of any agent in metres per second
     */
    record Bounds(Kin kin, double view, double nearHeight, double widest, double fastest) {
        static Bounds of(Crowd crowd, Kin kin, Agents agents) {
            double radius = 0;
            double speed = 0;
            for (int i = 0; i < agents.count; i++) {
                radius = Math.max(radius, agents.radius[i]);
                speed = Math.max(speed, agents.topSpeed[i]);
            }
            Crowd.Manner manner = crowd.manner();
            return new Bounds(kin, manner.view(), manner.bodyHeight() + 2 * manner.stepHeight(), radius, speed);
        }
    }

    /** Looks around for the agent at a place; its contacts are written to its proposal. */
    void look(int k) {
        double radius = cells.radius[k];
        double contact = (radius + widest + (cells.topSpeed[k] + fastest) * Crowd.STEP_SECONDS) * 1.000001;
        gather(k, Math.max(view, contact));
        feel(k);
        out.contactCount[k] = touch(k, contact * contact);
        double near = radius + widest + Math.max(1.2, Steering.TIME_GAP * cells.topSpeed[k] + 0.2);
        keep(radius, Math.min(view * view, near * near));
    }

    /** Collects those within a distance in metres. */
    private void gather(int k, double reach) {
        double[] xs = cells.x;
        double[] ys = cells.y;
        double[] zs = cells.z;
        double x = xs[k];
        double y = ys[k];
        double z = zs[k];
        double reachSquared = reach * reach;
        int count = 0;
        int lastRow = cells.row(y + reach);
        int ownRow = cells.row(y);
        int firstCol = cells.col(x - reach);
        int lastCol = cells.col(x + reach);
        for (int row = cells.row(y - reach); row <= lastRow; row++) {
            // only the outer rows are so far that fewer columns will do
            boolean outer = Math.abs(row - ownRow) >= Cells.REACH;
            double half = outer ? cells.halfWidth(reach, y, row) : 0;
            int end = cells.end(outer ? cells.col(x + half) : lastCol, row);
            int start = cells.start(outer ? cells.col(x - half) : firstCol, row);
            visits += end - start;
            if (count + end - start >= found.length) {
                grow(count + end - start + 1);
            }
            for (int j = start; j < end; j++) {
                double dx = xs[j] - x;
                double dy = ys[j] - y;
                double squared = dx * dx + dy * dy;
                // written in any case and counted if it is one: no branch to guess wrong
                found[count] = j;
                foundX[count] = dx;
                foundY[count] = dy;
                foundSquared[count] = squared;
                count += (squared < reachSquared ? 1 : 0)
                        & (j != k ? 1 : 0)
                        & (Math.abs(zs[j] - z) < nearHeight ? 1 : 0);
            }
        }
        foundCount = count;
    }

    private void grow(int least) {
        int size = Math.max(least, 2 * found.length);
        found = Arrays.copyOf(found, size);
        foundX = Arrays.copyOf(foundX, size);
        foundY = Arrays.copyOf(foundY, size);
        foundSquared = Arrays.copyOf(foundSquared, size);
    }

    /** Sums the forces of those in view. */
    private void feel(int k) {
        double awayX = 0;
        double awayY = 0;
        double midX = 0;
        double midY = 0;
        double alongX = 0;
        double alongY = 0;
        int inView = 0;
        double radius = cells.radius[k];
        int kin = cells.leaf[k] * leaves;
        double viewSquared = view * view;
        for (int m = 0; m < foundCount; m++) {
            double squared = foundSquared[m];
            if (squared >= viewSquared) {
                continue;
            }
            int j = found[m];
            int depth = depths[kin + cells.leaf[j]];
            boolean arrived = cells.state[j] == Agents.ARRIVED;
            double reach = radius + cells.radius[j];
            double safe = Math.max(squared, 1e-6);
            double push = (arrived ? SETTLED_PUSH : kinSeparation[depth]) * reach * reach / (safe * Math.sqrt(safe));
            awayX -= push * foundX[m];
            awayY -= push * foundY[m];
            inView++;
            if (!arrived) {
                midX += kinCohesion[depth] * foundX[m];
                midY += kinCohesion[depth] * foundY[m];
                alongX += kinAlignment[depth] * cells.headingX[j];
                alongY += kinAlignment[depth] * cells.headingY[j];
            }
        }
        separationX = awayX;
        separationY = awayY;
        cohesionX = midX;
        cohesionY = midY;
        alignmentX = alongX;
        alignmentY = alongY;
        seen = inView;
    }

    /** Writes those within reach of a step to the proposal; returns their number. */
    private int touch(int k, double contactSquared) {
        int contacts = 0;
        for (int m = 0; m < foundCount; m++) {
            if (foundSquared[m] < contactSquared) {
                if (contacts < Proposals.CONTACTS) {
                    out.contacts[k * Proposals.CONTACTS + contacts] = found[m];
                }
                contacts++;
            }
        }
        return contacts;
    }

    /** Returns the free way in metres in a direction, up to the first near that stands or goes there, less some comfort. */
    double room(double hx, double hy) {
        int count = 0;
        for (int m = 0; m < nearCount; m++) {
            double along = nearX[m] * hx + nearY[m] * hy;
            double across = nearX[m] * hy - nearY[m] * hx;
            double reach = nearReach[m];
            // written in any case and counted if it is in the way: no branch to guess wrong
            aheadAlong[count] = along;
            aheadHalf[count] = reach * reach - across * across;
            // who is only grazed does not slow one down: the rounds settle who goes first
            count += (Math.abs(across) < GRAZE * reach ? 1 : 0) & (along > 0 ? 1 : 0);
        }
        double room = Double.POSITIVE_INFINITY;
        for (int c = 0; c < count; c++) {
            room = Math.min(room, aheadAlong[c] - Math.sqrt(aheadHalf[c]));
        }
        return Math.max(0, room - COMFORT);
    }

    private void keep(double radius, double nearSquared) {
        int count = 0;
        int most = 0;
        for (int m = 0; m < foundCount && count < NEAR; m++) {
            int j = found[m];
            near[count] = j;
            nearX[count] = foundX[m];
            nearY[count] = foundY[m];
            nearReach[count] = radius + cells.radius[j];
            most = Math.max(most, cells.yielding[j]);
            count += foundSquared[m] < nearSquared ? 1 : 0;
        }
        nearCount = count;
        yielding = most;
    }
}
