package troupe.unified.reference;

import java.util.List;
import troupe.scene.Actor;

/**
 * Opens, in a space without anything movable, the vaults that may arise once something has been moved: around
 * each thin place where one cannot walk, whatever may come to stand beside it.
 */
final class WidestVaults {
    private final Space space;
    private final Ground ground;
    private final Actor.Vault vault;

    WidestVaults(Space space) {
        this.space = space;
        this.ground = space.ground;
        this.vault = ground.actor.vault().orElseThrow();
    }

    void add() {
        boolean[][] open = new boolean[ground.levels.length][];
        for (int level = 0; level < open.length; level++) {
            open[level] = crossings(level);
        }
        for (int level = 0; level < open.length; level++) {
            for (int at = 0; at < ground.cells; at++) {
                if (open[level][at]) {
                    space.abilities[ground.crossing(at, level, true)] = Ground.CROSS;
                }
            }
        }
    }

    private boolean[] crossings(int level) {
        double elevation = ground.levels[level];
        boolean[] closed = new boolean[ground.cells];
        boolean[] other = new boolean[ground.cells];
        boolean[] taken = new boolean[ground.cells];
        boolean takesOff = false;
        for (int at = 0; at < ground.cells; at++) {
            int q = space.spanNear(at, elevation);
            boolean walk = q >= 0 && (space.abilities[q] & Ground.WALK) != 0;
            closed[at] = !walk;
            other[at] = walk && ground.levelOf[q] != level;
            taken[at] = space.solidsInWay(at, elevation, vault) == 2;
            takesOff |= q >= 0 && space.firm(q) && ground.levelOf[q] == level;
        }
        boolean[] thick = Discs.opened(ground, closed, vault.reach() / 2);
        boolean[] seeds = new boolean[ground.cells];
        for (int at = 0; at < ground.cells; at++) {
            seeds[at] = takesOff && closed[at] && !thick[at] && !taken[at];
        }
        boolean[] around = around(seeds);
        for (int at = 0; at < ground.cells; at++) {
            seeds[at] |= around[at] && other[at];
        }
        boolean[] crossings = around(seeds);
        for (int at = 0; at < ground.cells; at++) {
            crossings[at] &= !taken[at];
        }
        return crossings;
    }

    private boolean[] around(boolean[] seeds) {
        List<int[]> steps = ground.within(vault.reach() + 2 * ground.cell);
        boolean[] around = new boolean[ground.cells];
        for (int at = 0; at < ground.cells; at++) {
            for (int[] step : seeds[at] ? steps : List.<int[]>of()) {
                int to = ground.shifted(at, step);
                if (to >= 0) {
                    around[to] = true;
                }
            }
        }
        return around;
    }
}
