package troupe.crowd.flock;

import troupe.scene.Crowd;

/** Lets those who have arrived step aside for others who are stuck among them. Not in the paper, whose agents stand on. */
final class MakingRoom {
    /** Metres within which those who have arrived make room for one who is stuck among them; the outer ones go first. */
    private static final double ROOM_REACH = 1.5;

    private final Cells cells;
    private final Proposals out;
    private final Steps steps;
    private final double othersReach;
    private final double nearHeight;

    /**
     * Prepares for the agents of a crowd.
     *
     * @param othersReach the largest radius and step of an agent together, in metres
     * @param nearHeight the difference in elevation in metres from which two do not meet; NaN if nobody makes room
     */
    MakingRoom(Cells cells, Proposals out, Steps steps, double othersReach, double nearHeight) {
        this.cells = cells;
        this.out = out;
        this.steps = steps;
        this.othersReach = othersReach;
        this.nearHeight = nearHeight;
    }

    /** Keeps one that has arrived where it is, unless somebody is stuck beside it, in a door or with another goal: then it steps aside. */
    void run(int k, long step) {
        steps.stay(k);
        if (Double.isNaN(nearHeight)) {
            return;
        }
        double x = cells.x[k];
        double y = cells.y[k];
        double reach = cells.radius[k] + othersReach + cells.topSpeed[k] * Crowd.STEP_SECONDS;
        double asideX = 0;
        double asideY = 0;
        int count = 0;
        double wide = Math.max(reach, ROOM_REACH);
        int lastCol = cells.col(x + wide);
        int firstCol = cells.col(x - wide);
        int lastRow = cells.row(y + wide);
        for (int row = cells.row(y - wide); row <= lastRow; row++) {
            int end = cells.end(lastCol, row);
            for (int j = cells.start(firstCol, row); j < end; j++) {
                double dx = x - cells.x[j];
                double dy = y - cells.y[j];
                if (j == k || dx * dx + dy * dy >= wide * wide || Math.abs(cells.z[j] - cells.z[k]) >= nearHeight) {
                    continue;
                }
                if (dx * dx + dy * dy < reach * reach * 1.000001) {
                    if (count < Proposals.CONTACTS) {
                        out.contacts[k * Proposals.CONTACTS + count] = j;
                    }
                    count++;
                }
                if (cells.state[j] == Agents.WAITING && (cells.tight[j] || cells.rank[j] != cells.rank[k])) {
                    double along = dx * cells.pathX[j] + dy * cells.pathY[j];
                    asideX += dx - 0.7 * along * cells.pathX[j];
                    asideY += dy - 0.7 * along * cells.pathY[j];
                }
            }
        }
        double length = Math.sqrt(asideX * asideX + asideY * asideY);
        if (length > 1e-6) {
            out.contactCount[k] = count;
            double speed = 0.4 * cells.topSpeed[k];
            steps.move(k, cells.agent[k], asideX / length, asideY / length, speed, step);
        }
    }
}
