package troupe.crowd.flock;

import troupe.crowd.ground.Terrain;
import troupe.scene.Crowd;

/** Writes proposals: to stay, or to make a step that is legal beside walls. */
final class Steps {
    /** Cosines of turns by 0, 30, -30, 60, -60, 90 and -90 degrees. */
    static final double[] TURN_COS = turns(true);
    /** Sines of the same turns. */
    static final double[] TURN_SIN = turns(false);

    private final Cells cells;
    private final Proposals out;
    private final Agents agents;
    private final long seed;

    Steps(Cells cells, Proposals out, Agents agents, long seed) {
        this.cells = cells;
        this.out = out;
        this.agents = agents;
        this.seed = seed;
    }

    /** Proposes to stay, without contacts. */
    void stay(int k) {
        out.x[k] = cells.x[k];
        out.y[k] = cells.y[k];
        out.z[k] = cells.z[k];
        out.span[k] = cells.span[k];
        out.headingX[k] = cells.headingX[k];
        out.headingY[k] = cells.headingY[k];
        out.speed[k] = 0;
        out.contactCount[k] = 0;
    }

    /** Proposes a step; beside a wall, the nearest direction in which it is legal. */
    void move(int k, int agent, double hx, double hy, double speed, long step) {
        Terrain terrain = agents.way[agent].terrain();
        int from = cells.span[k];
        boolean roomy = cells.roomy[k];
        double length = speed * Crowd.STEP_SECONDS;
        int first = 0;
        for (int attempt = 0; attempt < TURN_COS.length; attempt++) {
            if (attempt == 1) {
                first = (Chance.bits(seed, 3, agent, step) & 1) == 0 ? 1 : -1;
            }
            double sin = TURN_SIN[attempt] * first;
            double x = cells.x[k] + (TURN_COS[attempt] * hx - sin * hy) * length;
            double y = cells.y[k] + (sin * hx + TURN_COS[attempt] * hy) * length;
            int to = length > 0 ? terrain.step(from, roomy, x, y) : -1;
            if (to >= 0) {
                out.x[k] = x;
                out.y[k] = y;
                out.z[k] = to == from ? cells.z[k] : terrain.elevation(to);
                out.span[k] = to;
                out.speed[k] = speed;
                return;
            }
        }
        double headingX = out.headingX[k];
        double headingY = out.headingY[k];
        int contacts = out.contactCount[k];
        stay(k);
        out.headingX[k] = headingX;
        out.headingY[k] = headingY;
        out.contactCount[k] = contacts;
    }

    /** Returns the cosines or sines of turns by 0, 30, -30, 60, -60, 90 and -90 degrees. */
    private static double[] turns(boolean cosine) {
        double[] made = new double[7];
        for (int i = 0; i < made.length; i++) {
            double angle = (i + 1) / 2 * Math.PI / 6 * (i % 2 == 0 ? -1 : 1);
            made[i] = cosine ? StrictMath.cos(angle) : StrictMath.sin(angle);
        }
        return made;
    }
}
