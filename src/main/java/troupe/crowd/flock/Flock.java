package troupe.crowd.flock;

import java.util.concurrent.atomic.LongAdder;
import troupe.crowd.ground.Terrain;
import troupe.crowd.ground.Way;
import troupe.grid.GridFrame;
import troupe.scene.Crowd;

/**
 * Moves all agents by one step: sorts them into cells, lets each propose where to go, settles the proposals, and
 * writes the new state. Every step reads the old state only. Cost O(agents and the neighbours they see).
 */
public final class Flock {
    /** The share of its distance for which an agent keeps to a place that it goes for, before it looks again. */
    private static final double KEPT = 0.2;

    /** Below this share of its top speed an agent counts as standing. */
    private static final double STANDING = 0.1;

    /** Who has stood longer than so many steps counts as if it had stood so long, once it moves. */
    private static final int LONG = 2 * Steering.PATIENCE;

    private final Agents agents;
    private final Sweep sweep;
    private final Cells cells;
    private final Proposals proposals;
    private final Steering steering;
    private final Settling settling;
    private final Arrival arrival;
    private final long seed;
    private final double cell;
    private final boolean paper;
    private final LongAdder visits = new LongAdder();
    private Pull pull;
    private long moves;

    /**
     * Prepares to move the agents of a crowd.
     *
     * @param width of the world in metres
     * @param depth of the world in metres
     */
    public Flock(Crowd crowd, Kin kin, Agents agents, double width, double depth, Sweep sweep) {
        this.agents = agents;
        this.sweep = sweep;
        this.seed = crowd.seed();
        this.cell =
                agents.count == 0 ? 1 : agents.way[0].terrain().region().frame().cell();
        this.paper = crowd.manner().motion() == Crowd.Motion.PAPER;
        this.cells = new Cells(agents.count, width, depth, crowd.manner().view());
        this.proposals = new Proposals(agents.count);
        this.steering = new Steering(crowd, kin, cells, proposals, agents);
        this.settling = new Settling(cells, proposals, agents, crowd.manner().bodyHeight(), paper);
        this.arrival = new Arrival(kin, agents, cells, proposals, paper);
        this.pull = new Pull(crowd);
        for (int i = 0; i < agents.count; i++) {
            agents.rank[i] = RightOfWay.rank(seed, agents.way[i].goal());
            tread(i);
            aim(i);
        }
    }

    /** Tells that potentials have been set anew: everybody looks where to go now. */
    public void renewed() {
        for (int i = 0; i < agents.count; i++) {
            look(i);
        }
    }

    /** Lets an agent look at once where to go. */
    private void look(int i) {
        agents.keeps[i] = 0;
        tread(i);
        aim(i);
    }

    /** Reads what the span says that an agent has come to stand on; now and then it looks where to go from there. */
    private void tread(int i) {
        Way way = agents.way[i];
        Terrain terrain = way.terrain();
        int span = agents.span[i];
        agents.roomy[i] = terrain.roomy(span);
        agents.tight[i] = terrain.tight(span);
        agents.left[i] = way.potential(span);
        if (paper) {
            int d = way.next(span);
            double length = d < 4 ? 1 : Math.sqrt(0.5);
            agents.pathX[i] = d < 0 ? 0 : GridFrame.dx(d) * length;
            agents.pathY[i] = d < 0 ? 0 : GridFrame.dy(d) * length;
        } else if (!agents.roomy[i] || --agents.keeps[i] < 0) {
            int target = arrival.target(i);
            agents.targetX[i] = terrain.region().x(target);
            agents.targetY[i] = terrain.region().y(target);
            double dx = agents.targetX[i] - terrain.region().x(span);
            double dy = agents.targetY[i] - terrain.region().y(span);
            agents.keeps[i] = (int) (KEPT * Math.sqrt(dx * dx + dy * dy) / cell);
        }
    }

    /** Turns the path of an agent to the place that it goes for. */
    private void aim(int i) {
        if (paper) {
            return;
        }
        double dx = agents.targetX[i] - agents.x[i];
        double dy = agents.targetY[i] - agents.y[i];
        double squared = dx * dx + dy * dy;
        double scale = squared < 1e-8 ? 0 : 1 / Math.sqrt(squared);
        agents.pathX[i] = scale * dx;
        agents.pathY[i] = scale * dy;
    }

    /** Takes the weights and relation vectors of a crowd from the next step on. */
    public void take(Crowd crowd) {
        pull = new Pull(crowd);
    }

    /** Returns the number of others that were looked at, over all agents and steps. */
    public long visits() {
        return visits.sum();
    }

    /** Returns the number of times that an agent on its way was moved. */
    public long moves() {
        return moves;
    }

    /** Moves everybody by one step; {@code step} is its number, for the random draws and the arrivals. */
    public void step(long step) {
        cells.sort(agents);
        steering.prepare(pull, step);
        sweep.over(agents.count, (from, to) -> visits.add(steering.run(from, to)));
        settling.settle(sweep, seed, step);
        sweep.lightly(agents.count, (from, to) -> commit(from, to, (int) step));
        arrival.handOut(this::look);
        for (int i = 0; i < agents.count; i++) {
            moves += agents.state[i] == Agents.ARRIVED ? 0 : 1;
        }
    }

    private void commit(int from, int to, int step) {
        for (int k = from; k < to; k++) {
            int i = cells.agent[k];
            if (agents.state[i] == Agents.ARRIVED
                    && agents.span[i] == proposals.span[k]
                    && agents.x[i] == proposals.x[k]
                    && agents.y[i] == proposals.y[k]) {
                continue;
            }
            double dx = proposals.x[k] - agents.x[i];
            double dy = proposals.y[k] - agents.y[i];
            double moved = Math.sqrt(dx * dx + dy * dy) / Crowd.STEP_SECONDS;
            agents.x[i] = proposals.x[k];
            agents.y[i] = proposals.y[k];
            agents.z[i] = proposals.z[k];
            if (agents.span[i] != proposals.span[k]) {
                agents.span[i] = proposals.span[k];
                tread(i);
            }
            aim(i);
            if (paper) {
                agents.headingX[i] = proposals.headingX[k];
                agents.headingY[i] = proposals.headingY[k];
            } else {
                turn(k, i, dx, dy, moved);
            }
            if (agents.state[i] == Agents.ARRIVED) {
                continue;
            }
            agents.speed[i] = moved;
            boolean stands = moved < STANDING * agents.topSpeed[i];
            agents.still[i] = stands ? agents.still[i] + 1 : Math.max(0, Math.min(LONG, agents.still[i]) - 2);
            agents.yielding[i] = proposals.yielding[k];
            arrival.progress(i);
            agents.state[i] = agents.still[i] >= Steering.PATIENCE ? Agents.WAITING : Agents.WALKING;
            if (arrival.arrives(k, i)) {
                agents.state[i] = Agents.ARRIVED;
                agents.arrival[i] = step;
                agents.speed[i] = 0;
            }
        }
    }

    /** Turns an agent to where it has moved; one that stands turns slowly to where it would go. */
    private void turn(int k, int i, double dx, double dy, double moved) {
        double share = moved > 0.2 * agents.topSpeed[i] ? 0.5 : 0.05;
        double length = moved * Crowd.STEP_SECONDS;
        boolean goes = share == 0.5;
        double toX = goes ? dx / length : proposals.headingX[k];
        double toY = goes ? dy / length : proposals.headingY[k];
        double x = agents.headingX[i] + share * (toX - agents.headingX[i]);
        double y = agents.headingY[i] + share * (toY - agents.headingY[i]);
        double norm = Math.sqrt(x * x + y * y);
        agents.headingX[i] = norm > 1e-3 ? x / norm : toX;
        agents.headingY[i] = norm > 1e-3 ? y / norm : toY;
    }
}
