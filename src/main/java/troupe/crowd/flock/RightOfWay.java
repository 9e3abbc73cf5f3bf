package troupe.crowd.flock;

/**
 * Undoes knots of opposing flows: of two that stand head to head the one whose goal has the lower rank gives way and
 * goes back, as do those behind it, until the others have passed. Ranks are drawn from the seed for each goal, so
 * that all agents of a flow agree. Reads the state of the last step only. Not in the paper, whose forces cannot undo
 * such knots (its section 4.3).
 */
final class RightOfWay {
    /** Steps for which an agent goes back at least. */
    private static final int LEAST = 30;
    /** Steps of standing still before somebody gives way. */
    private static final int PATIENCE = 12;
    /** Steps for which one goes back that stands shoulder to shoulder with another of its flow. */
    private static final int BRIEF = 10;

    /** By so many steps those behind give way for a shorter time. */
    private static final int FADING = 2;

    private final Cells cells;

    RightOfWay(Cells cells) {
        this.cells = cells;
    }

    /** Returns the rank of a goal. */
    static long rank(long seed, int goal) {
        return Chance.bits(seed, 5, goal, 0);
    }

    /** Returns for how many steps an agent gives way from now on, 0 if it does not. */
    int yielding(int k, Sight s) {
        int still = cells.still[k];
        int left = Math.max(0, cells.yielding[k] - 1);
        if (still < PATIENCE && left == 0 && s.yielding <= FADING) {
            return 0;
        }
        for (int m = 0; m < s.nearCount; m++) {
            int j = s.near[m];
            if (cells.state[j] == Agents.ARRIVED) {
                continue;
            }
            double dx = s.nearX[m];
            double dy = s.nearY[m];
            double reach = s.nearReach[m];
            double squared = dx * dx + dy * dy;
            boolean ahead = dx * cells.pathX[k] + dy * cells.pathY[k] > 0;
            if (still >= PATIENCE && cells.rank[j] == cells.rank[k] && squared < (reach + 0.04) * (reach + 0.04)) {
                // shoulder to shoulder in one flow: the one that is behind lets the other go first
                boolean behind = cells.left[j] < cells.left[k] || cells.left[j] == cells.left[k] && j < k;
                if (cells.state[j] == Agents.WAITING && behind) {
                    left = Math.max(left, BRIEF);
                }
            }
            if (!ahead) {
                continue;
            }
            if (cells.rank[j] == cells.rank[k]) {
                // the one before me comes back: make room
                if (squared < (reach + 0.25) * (reach + 0.25) && cells.yielding[j] - FADING > left) {
                    left = cells.yielding[j] - FADING;
                }
            } else if (cells.rank[j] > cells.rank[k]
                    && cells.pathX[j] * cells.pathX[k] + cells.pathY[j] * cells.pathY[k] < -0.2) {
                boolean knot = still >= PATIENCE && squared < (reach + 0.3) * (reach + 0.3);
                boolean stillComing = left > 0 && squared < (reach + 1.2) * (reach + 1.2);
                if (knot || stillComing) {
                    left = Math.max(left, LEAST);
                }
            }
        }
        return left;
    }
}
