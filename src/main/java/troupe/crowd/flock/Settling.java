package troupe.crowd.flock;

import java.util.concurrent.atomic.AtomicInteger;
import troupe.crowd.ground.Terrain;
import troupe.scene.Crowd;

/**
 * Settles the proposals of a step so that no two agents overlap, in rounds: a proposal is accepted when it keeps
 * clear of all accepted places, of the old places of the undecided, and of every undecided proposal of higher
 * priority (a hash of seed, step and agent). One that meets a decided agent is retried in a direction nearby, drawn
 * from seed, agent and step, and at last dropped; who is undecided after the last round stays. Staying is always
 * safe, because whoever was accepted kept clear of it. Each round reads the verdicts of the one before, so the
 * result does not depend on the threads. Source: Crowd section 3.4, whose agents move one after the other.
 */
final class Settling {
    private static final int ROUNDS = 8;
    /** Rounds in which one waits for the others; in later ones it tries another direction, as the other may wait, too. */
    private static final int WAITING_ROUNDS = 4;

    private static final int RETRIES = 3;
    private static final byte UNDECIDED = 0;
    private static final byte ACCEPTED = 1;
    private static final byte STAYS = 2;
    private static final byte RETRY = 3;

    private final Cells cells;
    private final Proposals proposals;
    private final Agents agents;
    private final double bodyHeight;
    /** The widest turn of a retry in radians, less the narrowest. */
    private final double turn;

    private final byte[] status;
    private final byte[] verdict;
    private final byte[] tries;
    private final long[] priority;

    Settling(Cells cells, Proposals proposals, Agents agents, double bodyHeight, boolean paper) {
        this.cells = cells;
        this.proposals = proposals;
        this.agents = agents;
        this.bodyHeight = bodyHeight;
        this.turn = paper ? Math.PI - 0.35 : 1.4;
        status = new byte[cells.count];
        verdict = new byte[cells.count];
        tries = new byte[cells.count];
        priority = new long[cells.count];
    }

    /** Settles the proposals of a step; afterwards each proposal is where its agent goes. */
    void settle(Sweep sweep, long seed, long step) {
        sweep.lightly(cells.count, (from, to) -> begin(from, to, seed, step));
        for (int round = 0; round < ROUNDS; round++) {
            AtomicInteger undecided = new AtomicInteger();
            byte waiting = round < WAITING_ROUNDS ? UNDECIDED : RETRY;
            sweep.lightly(cells.count, (from, to) -> judge(from, to, waiting));
            sweep.lightly(cells.count, (from, to) -> undecided.addAndGet(apply(from, to, seed, step)));
            if (undecided.get() == 0) {
                break;
            }
        }
        sweep.lightly(cells.count, this::end);
    }

    private void begin(int from, int to, long seed, long step) {
        for (int k = from; k < to; k++) {
            tries[k] = 0;
            priority[k] = Chance.bits(seed, 1, cells.agent[k], step);
            boolean moves = proposals.x[k] != cells.x[k] || proposals.y[k] != cells.y[k];
            status[k] = moves && proposals.contactCount[k] <= Proposals.CONTACTS ? UNDECIDED : STAYS;
        }
    }

    private void judge(int from, int to, byte waiting) {
        for (int k = from; k < to; k++) {
            verdict[k] = status[k] == UNDECIDED ? verdict(k, waiting) : status[k];
        }
    }

    private byte verdict(int k, byte waiting) {
        boolean waits = false;
        int base = k * Proposals.CONTACTS;
        for (int c = base; c < base + proposals.contactCount[k]; c++) {
            int j = proposals.contacts[c];
            byte other = status[j];
            if (other == ACCEPTED) {
                if (meetsNew(k, j)) {
                    return RETRY;
                }
            } else if (other == STAYS) {
                if (meetsOld(k, j)) {
                    return RETRY;
                }
            } else if (!waits) {
                waits = meetsOld(k, j) || before(j, k) && meetsNew(k, j);
            }
        }
        return waits ? waiting : ACCEPTED;
    }

    private boolean before(int a, int b) {
        return priority[a] != priority[b] ? priority[a] > priority[b] : cells.agent[a] < cells.agent[b];
    }

    private boolean meetsNew(int k, int j) {
        return meets(k, j, proposals.x[j], proposals.y[j], proposals.z[j]);
    }

    private boolean meetsOld(int k, int j) {
        return meets(k, j, cells.x[j], cells.y[j], cells.z[j]);
    }

    private boolean meets(int k, int j, double x, double y, double z) {
        double dx = proposals.x[k] - x;
        double dy = proposals.y[k] - y;
        double reach = cells.radius[k] + cells.radius[j];
        return dx * dx + dy * dy < reach * reach && Math.abs(proposals.z[k] - z) < bodyHeight;
    }

    private int apply(int from, int to, long seed, long step) {
        int undecided = 0;
        for (int k = from; k < to; k++) {
            if (status[k] != UNDECIDED) {
                continue;
            }
            if (verdict[k] == RETRY) {
                if (tries[k] == RETRIES || !retry(k, seed, step)) {
                    status[k] = STAYS;
                    continue;
                }
                tries[k]++;
            } else {
                status[k] = verdict[k];
            }
            undecided += status[k] == UNDECIDED ? 1 : 0;
        }
        return undecided;
    }

    /** Proposes a place in another direction nearby; tells whether there is a legal one. */
    private boolean retry(int k, long seed, long step) {
        int agent = cells.agent[k];
        Terrain terrain = agents.way[agent].terrain();
        double length = Math.max(proposals.speed[k], 0.3 * cells.topSpeed[k]) * Crowd.STEP_SECONDS;
        for (int attempt = 0; attempt < 2; attempt++) {
            long bits = Chance.bits(seed, 16 + 2 * tries[k] + attempt, agent, step);
            double angle = (0.35 + turn * Chance.unit(bits)) * ((bits & 1) == 0 ? 1 : -1);
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            double hx = cos * proposals.headingX[k] - sin * proposals.headingY[k];
            double hy = sin * proposals.headingX[k] + cos * proposals.headingY[k];
            double x = cells.x[k] + hx * length * 0.7;
            double y = cells.y[k] + hy * length * 0.7;
            int span = terrain.step(cells.span[k], cells.roomy[k], x, y);
            if (span >= 0) {
                proposals.x[k] = x;
                proposals.y[k] = y;
                proposals.z[k] = span == cells.span[k] ? cells.z[k] : terrain.elevation(span);
                proposals.span[k] = span;
                proposals.speed[k] = length * 0.7 / Crowd.STEP_SECONDS;
                return true;
            }
        }
        return false;
    }

    private void end(int from, int to) {
        for (int k = from; k < to; k++) {
            if (status[k] != ACCEPTED) {
                proposals.x[k] = cells.x[k];
                proposals.y[k] = cells.y[k];
                proposals.z[k] = cells.z[k];
                proposals.span[k] = cells.span[k];
                proposals.speed[k] = 0;
            }
        }
    }
}
