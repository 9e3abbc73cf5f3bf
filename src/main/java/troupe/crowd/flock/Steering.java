package troupe.crowd.flock;

import troupe.crowd.ground.Terrain;
import troupe.crowd.ground.Way;
import troupe.grid.GridFrame;
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
    /** Collisions further off in seconds than this are not looked at. */
    private static final double HORIZON = 3;

    /** Those who have arrived push so little, whoever they are, that others can settle beside them. */
    private static final double SETTLED_PUSH = 0.3;

    /** The share of the sum of radii within which somebody beside the way is in the way. */
    private static final double GRAZE = 0.7;

    /** Below this share of the speed that it could have, an agent looks for a way past those ahead. */
    private static final double SLOW = 0.4;

    /** Metres that an agent keeps from the one before it, so that no pack gets so dense that nobody can move. */
    private static final double COMFORT = 0.1;

    private static final double ACCELERATION = 2.5;
    private static final int NEAR = 96;
    /** Steps of standing still after which an agent tries directions by chance. */
    static final int PATIENCE = 25;

    private final Cells cells;
    private final Proposals out;
    private final Agents agents;
    private final byte[] depths;
    private final int leaves;
    private final double view;
    private final double bodyHeight;
    private final double nearHeight;
    private final boolean paper;
    private final double widest;
    private final double fastest;
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
        this.depths = kin.depths();
        this.leaves = kin.leaves().size();
        this.view = crowd.manner().view();
        this.bodyHeight = crowd.manner().bodyHeight();
        this.nearHeight = bodyHeight + 2 * crowd.manner().stepHeight();
        this.paper = crowd.manner().motion() == Crowd.Motion.PAPER;
        this.seed = crowd.seed();
        this.rightOfWay = new RightOfWay(cells);
        double radius = 0;
        double speed = 0;
        for (int i = 0; i < agents.count; i++) {
            radius = Math.max(radius, agents.radius[i]);
            speed = Math.max(speed, agents.topSpeed[i]);
        }
        this.widest = radius;
        this.fastest = speed;
        this.steps = new Steps(cells, out, agents, seed);
        double reach = widest + fastest * Crowd.STEP_SECONDS;
        this.makingRoom = new MakingRoom(cells, out, steps, reach, paper ? Double.NaN : nearHeight);
    }

    /** Sets the factors and the number of the step to come. */
    void prepare(Pull factors, long number) {
        pull = factors;
        step = number;
    }

    /** What one agent sees; used again for the next. */
    private static final class Sight {
        double separationX;
        double separationY;
        double cohesionX;
        double cohesionY;
        double alignmentX;
        double alignmentY;
        int seen;
        long visits;
        final int[] near = new int[NEAR];
        int nearCount;
        double x;
        double y;
        double room;
        int ahead;
    }

    /** Makes the proposals of a range of places; returns how many others were looked at. */
    long run(int from, int to) {
        Sight sight = new Sight();
        for (int k = from; k < to; k++) {
            if (cells.state[k] == Agents.ARRIVED) {
                makingRoom.run(k, step);
            } else {
                look(k, sight);
                steer(k, sight);
            }
        }
        return sight.visits;
    }

    private void look(int k, Sight s) {
        s.separationX = 0;
        s.separationY = 0;
        s.cohesionX = 0;
        s.cohesionY = 0;
        s.alignmentX = 0;
        s.alignmentY = 0;
        s.seen = 0;
        s.nearCount = 0;
        int contactCount = 0;
        double x = cells.x[k];
        double y = cells.y[k];
        double radius = cells.radius[k];
        double seenSquared = view * view;
        double contactReach = radius + widest + (cells.topSpeed[k] + fastest) * Crowd.STEP_SECONDS;
        double contactSquared = contactReach * contactReach * 1.000001;
        double nearReach = radius + widest + Math.max(1.2, TIME_GAP * cells.topSpeed[k] + 0.2);
        double nearSquared = Math.min(seenSquared, nearReach * nearReach);
        double farthest = Math.max(view, contactReach);
        int lastCol = cells.col(x + farthest);
        int firstCol = cells.col(x - farthest);
        int lastRow = cells.row(y + farthest);
        for (int row = cells.row(y - farthest); row <= lastRow; row++) {
            int end = cells.end(lastCol, row);
            int start = cells.start(firstCol, row);
            s.visits += end - start;
            for (int j = start; j < end; j++) {
                double dx = cells.x[j] - x;
                double dy = cells.y[j] - y;
                double squared = dx * dx + dy * dy;
                if (squared >= seenSquared && squared >= contactSquared
                        || j == k
                        || Math.abs(cells.z[j] - cells.z[k]) >= nearHeight) {
                    continue;
                }
                if (squared < contactSquared) {
                    if (contactCount < Proposals.CONTACTS) {
                        out.contacts[k * Proposals.CONTACTS + contactCount] = j;
                    }
                    contactCount++;
                }
                if (squared < nearSquared && s.nearCount < NEAR) {
                    s.near[s.nearCount++] = j;
                }
                if (squared < seenSquared) {
                    feel(k, j, dx, dy, squared, s);
                }
            }
        }
        out.contactCount[k] = contactCount;
    }

    private void feel(int k, int j, double dx, double dy, double squared, Sight s) {
        int depth = depths[cells.leaf[k] * leaves + cells.leaf[j]];
        double reach = cells.radius[k] + cells.radius[j];
        double safe = Math.max(squared, 1e-6);
        boolean arrived = cells.state[j] == Agents.ARRIVED;
        double push = (arrived ? SETTLED_PUSH : pull.kinSeparation[depth]) * reach * reach / (safe * Math.sqrt(safe));
        s.separationX -= push * dx;
        s.separationY -= push * dy;
        s.seen++;
        if (!arrived) {
            s.cohesionX += pull.kinCohesion[depth] * dx;
            s.cohesionY += pull.kinCohesion[depth] * dy;
            s.alignmentX += pull.kinAlignment[depth] * cells.headingX[j];
            s.alignmentY += pull.kinAlignment[depth] * cells.headingY[j];
        }
    }

    private void steer(int k, Sight s) {
        int agent = cells.agent[k];
        double pathX = cells.pathX[k];
        double pathY = cells.pathY[k];
        if (!paper) {
            out.yielding[k] = rightOfWay.yielding(k, agents.still[agent], s.near, s.nearCount);
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
            anticipate(k, pathX, pathY, s);
            sumX += pull.anticipation * s.x;
            sumY += pull.anticipation * s.y;
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

    /** Finds the direction of the path and the rank of a range of places, for themselves and for those who see them. */
    void orient(int from, int to) {
        for (int k = from; k < to; k++) {
            int agent = cells.agent[k];
            Way way = agents.way[agent];
            int span = agents.span[agent];
            cells.left[k] = way.potential(span);
            cells.rank[k] = RightOfWay.rank(seed, way.goal());
            if (cells.state[k] == Agents.ARRIVED) {
                cells.pathX[k] = 0;
                cells.pathY[k] = 0;
            } else if (paper) {
                int d = way.next(span);
                double length = d < 4 ? 1 : Math.sqrt(0.5);
                cells.pathX[k] = d < 0 ? 0 : GridFrame.dx(d) * length;
                cells.pathY[k] = d < 0 ? 0 : GridFrame.dy(d) * length;
            } else {
                long towards = way.towards(span);
                cells.pathX[k] = Way.x(towards);
                cells.pathY[k] = Way.y(towards);
            }
        }
    }

    /** Finds the push sideways from those that the agent would meet soon if it went down its path. */
    private void anticipate(int k, double pathX, double pathY, Sight s) {
        double pushX = 0;
        double pushY = 0;
        double speed = cells.topSpeed[k];
        for (int m = 0; m < s.nearCount; m++) {
            int j = s.near[m];
            double dx = cells.x[j] - cells.x[k];
            double dy = cells.y[j] - cells.y[k];
            boolean opposing = cells.pathX[j] * pathX + cells.pathY[j] * pathY < -0.2;
            // who comes against one is expected to come on, even if it stands at the moment
            double pace = opposing ? Math.max(cells.speed[j], 0.5 * cells.topSpeed[j]) : cells.speed[j];
            double wx = pathX * speed - (opposing ? cells.pathX[j] : cells.headingX[j]) * pace;
            double wy = pathY * speed - (opposing ? cells.pathY[j] : cells.headingY[j]) * pace;
            double along = wx * dx + wy * dy;
            if (along <= 0) {
                continue;
            }
            double reach = cells.radius[k] + cells.radius[j] + 0.1;
            double relative = wx * wx + wy * wy;
            double apart = Math.max(0, dx * dx + dy * dy - reach * reach);
            double root = along * along - relative * apart;
            if (root <= 0) {
                continue;
            }
            double time = apart / (along + Math.sqrt(root));
            if (time >= HORIZON) {
                continue;
            }
            double urgency = (1 - time / HORIZON) * (1 - time / HORIZON);
            double side = wx * dy - wy * dx;
            double bias = opposing ? -0.7 * reach * Math.sqrt(relative) : 0;
            double right = side >= bias ? urgency : -urgency;
            pushX += right * pathY;
            pushY -= right * pathX;
        }
        double size = Math.sqrt(pushX * pushX + pushY * pushY);
        double scale = size > 1.2 ? 1.2 / size : 1;
        s.x = pushX * scale;
        s.y = pushY * scale;
    }

    private void propose(int k, int agent, double headingX, double headingY, Sight s) {
        double hx = headingX;
        double hy = headingY;
        double speed = cells.topSpeed[k];
        boolean chance = !paper && agents.still[agent] >= PATIENCE && (agents.still[agent] / 8 & 1) == 1;
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
            speed = Math.min(most, room(k, hx, hy, s) / TIME_GAP);
            if (speed < SLOW * most) {
                int turn = turn(k, agent, hx, hy, most, s);
                double cos = Steps.TURN_COS[turn];
                double sin = Steps.TURN_SIN[turn];
                double x = cos * hx - sin * hy;
                hy = sin * hx + cos * hy;
                hx = x;
                speed = Math.min(most, room(k, hx, hy, s) / TIME_GAP);
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
            double gain = cos * Math.min(most, room(k, x, y, s) / TIME_GAP);
            if (gain > gained * 1.05
                    && terrain.step(agents.span[agent], cells.x[k] + x * reach, cells.y[k] + y * reach) >= 0) {
                gained = gain;
                best = turn;
            }
        }
        return best;
    }

    /** Returns the free way in metres in a direction, up to the first that stands or goes there. */
    private double room(int k, double hx, double hy, Sight s) {
        double room = Double.POSITIVE_INFINITY;
        for (int m = 0; m < s.nearCount; m++) {
            int j = s.near[m];
            double dx = cells.x[j] - cells.x[k];
            double dy = cells.y[j] - cells.y[k];
            double along = dx * hx + dy * hy;
            double across = dx * hy - dy * hx;
            double reach = cells.radius[k] + cells.radius[j];
            // who is only grazed does not slow one down: the rounds settle who goes first
            boolean inTheWay = Math.abs(across) < GRAZE * reach && along > 0;
            if (inTheWay) {
                room = Math.min(room, along - Math.sqrt(reach * reach - across * across));
            }
        }
        return Math.max(0, room - COMFORT);
    }
}
