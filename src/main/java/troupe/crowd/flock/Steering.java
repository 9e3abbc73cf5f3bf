package troupe.crowd.flock;

import troupe.crowd.ground.Terrain;
import troupe.scene.Crowd;

/**
 * Finds where each agent wants to go next: separation, cohesion and alignment over the neighbours it sees, each
 * multiplied by the relation vector of the pair, the path down the potential, and anticipation. Their weighted sum,
 * made a unit vector and averaged with the present heading, is the next direction (Crowd sections 3.1 to 3.5).
 *
 * <p>With p the places, h the headings, n the number of neighbours in view, r the sum of radii and v the view
 * distance: separation {@code sum R_s (r / d)^2} away from each, cohesion {@code sum R_c (p_j - p_i) / (n v)},
 * alignment {@code sum R_a h_j / n}; n counts neighbours, never weights.
 *
 * <p>Deviations from the paper: agents move continuously; speed rises to the highest one and falls with the room ahead
 * (Tordeux, Chraibi and Seyfried 2016: room divided by a time gap); anticipation pushes sideways by the time to
 * collision, to the right when heads meet; who has stood still for a while tries directions by chance.
 */
final class Steering {
    /** Seconds that an agent keeps to the one ahead. */
    static final double TIME_GAP = 0.5;
    /** Below this share of the speed that it could have, an agent looks for a way past those ahead. */
    private static final double SLOW = 0.4;

    private static final double ACCELERATION = 2.5;
    /** Steps of standing still after which an agent tries directions by chance. */
    static final int PATIENCE = 25;

    private final Cells cells;
    private final Proposals out;
    private final Agents agents;
    private final Sight.Bounds bounds;
    private final double view;
    private final boolean paper;
    private final long seed;
    private final RightOfWay rightOfWay;
    private final Steps steps;
    private final MakingRoom makingRoom;
    private Pull pull;
    private long step;

    Steering(Crowd crowd, Kin kin, Cells cells, Proposals out, Agents agents) {
        this.cells = cells;
        this.out = out;
        this.agents = agents;
        this.bounds = Sight.Bounds.of(crowd, kin, agents);
        this.view = crowd.manner().view();
        this.paper = crowd.manner().motion() == Crowd.Motion.PAPER;
        this.seed = crowd.seed();
        this.rightOfWay = new RightOfWay(cells);
        this.steps = new Steps(cells, out, agents, seed);
        double reach = bounds.widest() + bounds.fastest() * Crowd.STEP_SECONDS;
        this.makingRoom = new MakingRoom(cells, out, steps, reach, paper ? Double.NaN : bounds.nearHeight());
    }

    /** Sets the factors and the number of the step to come. */
    void prepare(Pull factors, long number) {
        pull = factors;
        step = number;
    }

    /** Makes the proposals of a range of places; returns how many others were looked at. */
    long run(int from, int to) {
        Sight sight = new Sight(cells, out, bounds, pull);
        Anticipation ahead = new Anticipation(cells);
        for (int k = from; k < to; k++) {
            if (cells.state[k] == Agents.ARRIVED) {
                makingRoom.run(k, step);
            } else {
                sight.look(k);
                steer(k, sight, ahead);
            }
        }
        return sight.visits;
    }

    private void steer(int k, Sight s, Anticipation ahead) {
        int agent = cells.agent[k];
        double pathX = cells.pathX[k];
        double pathY = cells.pathY[k];
        if (!paper) {
            out.yielding[k] = rightOfWay.yielding(k, s);
            if (out.yielding[k] > 0) {
                double backX = -pathX - 0.4 * pathY;
                double backY = -pathY + 0.4 * pathX;
                pathX = backX / Math.sqrt(1.16);
                pathY = backY / Math.sqrt(1.16);
            }
        }
        double n = Math.max(1, s.seen);
        double sumX = pull.separation * s.separationX
                + pull.cohesion * s.cohesionX / (n * view)
                + pull.alignment * s.alignmentX / n
                + pull.path * pathX;
        double sumY = pull.separation * s.separationY
                + pull.cohesion * s.cohesionY / (n * view)
                + pull.alignment * s.alignmentY / n
                + pull.path * pathY;
        if (!paper) {
            ahead.look(k, pathX, pathY, s);
            sumX += pull.anticipation * ahead.asideX;
            sumY += pull.anticipation * ahead.asideY;
        }
        double length = Math.sqrt(sumX * sumX + sumY * sumY);
        double headingX = cells.headingX[k];
        double headingY = cells.headingY[k];
        if (length > 1e-9) {
            double x = sumX / length + headingX;
            double y = sumY / length + headingY;
            double norm = Math.sqrt(x * x + y * y);
            headingX = norm > 1e-6 ? x / norm : sumX / length;
            headingY = norm > 1e-6 ? y / norm : sumY / length;
        }
        propose(k, agent, headingX, headingY, s);
    }

    private void propose(int k, int agent, double headingX, double headingY, Sight s) {
        double hx = headingX;
        double hy = headingY;
        double speed = cells.topSpeed[k];
        boolean chance = !paper && cells.still[k] >= PATIENCE && (cells.still[k] / 8 & 1) == 1;
        if (paper) {
            hx = Math.abs(headingX) > 0.38268343236508977 ? Math.signum(headingX) : 0;
            hy = Math.abs(headingY) > 0.38268343236508977 ? Math.signum(headingY) : 0;
            double diagonal = hx != 0 && hy != 0 ? Math.sqrt(0.5) : 1;
            hx *= diagonal;
            hy *= diagonal;
        } else if (chance) {
            long bits = Chance.bits(seed, 2, agent, step / 8);
            double angle = (Chance.unit(bits) - 0.5) * 4;
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            hx = cos * headingX - sin * headingY;
            hy = sin * headingX + cos * headingY;
            speed = 0.4 * speed;
        } else {
            double most = Math.min(speed, cells.speed[k] + ACCELERATION * Crowd.STEP_SECONDS);
            speed = Math.min(most, s.room(hx, hy) / TIME_GAP);
            if (speed < SLOW * most) {
                int turn = turn(k, agent, hx, hy, most, s);
                double cos = Steps.TURN_COS[turn];
                double sin = Steps.TURN_SIN[turn];
                double x = cos * hx - sin * hy;
                hy = sin * hx + cos * hy;
                hx = x;
                speed = Math.min(most, s.room(hx, hy) / TIME_GAP);
            }
        }
        out.headingX[k] = chance ? cells.headingX[k] : headingX;
        out.headingY[k] = chance ? cells.headingY[k] : headingY;
        steps.move(k, agent, hx, hy, speed, step);
    }

    /** Returns the turn that gets one on fastest past those who are in the way; an index of {@link #Steps.TURN_COS}. */
    private int turn(int k, int agent, double hx, double hy, double most, Sight s) {
        Terrain terrain = agents.way[agent].terrain();
        double reach = cells.topSpeed[k] * Crowd.STEP_SECONDS;
        int best = 0;
        double gained = 0;
        for (int turn = 0; turn < Steps.TURN_COS.length - 2; turn++) {
            double cos = Steps.TURN_COS[turn];
            double sin = Steps.TURN_SIN[turn];
            double x = cos * hx - sin * hy;
            double y = sin * hx + cos * hy;
            double gain = cos * Math.min(most, s.room(x, y) / TIME_GAP);
            if (gain > gained * 1.05
                    && terrain.step(cells.span[k], cells.roomy[k], cells.x[k] + x * reach, cells.y[k] + y * reach)
                            >= 0) {
                gained = gain;
                best = turn;
            }
        }
        return best;
    }
}
