package troupe.unified.reference;

import troupe.scene.Actor;
import troupe.scene.Obstacle;

/**
 * Opens, in a space without anything movable, the vaults that may arise once something has been moved: around
 * each thin place where one cannot walk, and each pair of neighbours where one can stand on both and step to
 * neither, as far as a vault over something may lead, but for what no vault can take. From a floor from which nothing
 * movable can be vaulted, only over what is fixed.
 */
public final class WidestVaults {
    private final Space space;
    private final Ground ground;
    private final Actor.Vault vault;
    private final int far;

    WidestVaults(Space space) {
        this.space = space;
        this.ground = space.ground;
        this.vault = ground.actor.vault().orElseThrow();
        double most = Math.max(vault.maxJump(), vault.reach()) / ground.cell;
        far = Math.min((int) Math.ceil(most) + 3, Math.max(ground.cols, ground.cells / ground.cols));
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
        boolean[] near = aroundTakeOff(level);
        boolean[] barred = new boolean[ground.cells];
        boolean[] taken = new boolean[ground.cells];
        for (int at = 0; at < ground.cells; at++) {
            int q = space.spanNear(at, elevation);
            barred[at] = near[at] && (q < 0 || (space.abilities[q] & Ground.WALK) == 0);
            taken[at] = space.solidsInWay(at, elevation, vault) == 2;
        }
        boolean[] thick = Discs.opened(ground, barred, vault.reach() / 2);
        boolean[] seeds = new boolean[ground.cells];
        for (int at = 0; at < ground.cells; at++) {
            seeds[at] = barred[at] && !thick[at] && !taken[at];
            taken[at] |= barred[at] && thick[at];
            for (int d = 0; d < 8 && near[at]; d++) {
                int to = ground.shifted(at, new int[] {Space.DX[d], Space.DY[d]});
                seeds[at] |= to >= 0 && near[to] && isStep(at, to, elevation);
            }
        }
        boolean[] crossings = around(seeds);
        if (!isMovableVaulted(elevation)) {
            for (int at = 0; at < ground.cells; at++) {
                crossings[at] = space.solidsInWay(at, elevation, vault) == 1;
            }
        }
        for (int at = 0; at < ground.cells; at++) {
            crossings[at] &= near[at] && !taken[at];
        }
        return crossings;
    }

    /** Tells whether a vault from an elevation may pass over something movable, wherever that stands. */
    private boolean isMovableVaulted(double elevation) {
        for (Obstacle o : ground.scene.obstacles()) {
            double above = o.top() - elevation;
            if (o.movable()
                    && o.offset() < elevation + ground.actor.bodyHeight() - Ground.SAME
                    && above > ground.actor.stepHeight() + Ground.SAME
                    && above >= vault.minHeight() - Ground.SAME
                    && above <= vault.maxHeight() + Ground.SAME) {
                return true;
            }
        }
        return false;
    }

    /** Returns the cells of the box around the places where one can take off from a level, grown as far as vaults go. */
    private boolean[] aroundTakeOff(int level) {
        int left = Integer.MAX_VALUE;
        int low = Integer.MAX_VALUE;
        int right = Integer.MIN_VALUE;
        int high = Integer.MIN_VALUE;
        for (int q = 0; q < ground.spanCount; q++) {
            if (space.firm(q) && ground.levelOf[q] == level) {
                left = Math.min(left, q % ground.cells % ground.cols);
                right = Math.max(right, q % ground.cells % ground.cols);
                low = Math.min(low, q % ground.cells / ground.cols);
                high = Math.max(high, q % ground.cells / ground.cols);
            }
        }
        boolean[] around = new boolean[ground.cells];
        for (int at = 0; at < ground.cells && left <= right; at++) {
            int col = at % ground.cols;
            int row = at / ground.cols;
            around[at] =
                    col >= left - far - 1 && col <= right + far + 1 && row >= low - far - 1 && row <= high + far + 1;
        }
        return around;
    }

    /** Tells whether one can stand near an elevation over both of two cells, and not step from one to the other. */
    private boolean isStep(int from, int to, double elevation) {
        int a = space.spanNear(from, elevation);
        int b = space.spanNear(to, elevation);
        if (a < 0 || b < 0 || !space.open(a) || !space.open(b)) {
            return false;
        }
        double high = Math.max(ground.floor[a], ground.floor[b]);
        boolean reaches = Math.abs(ground.floor[a] - ground.floor[b]) <= ground.actor.stepHeight() + Ground.SAME;
        return !reaches
                || Math.min(ground.ceiling[a], ground.ceiling[b]) - high < ground.actor.bodyHeight() - Ground.SAME;
    }

    private boolean[] around(boolean[] seeds) {
        boolean[] around = new boolean[ground.cells];
        for (int at = 0; at < ground.cells; at++) {
            for (int dy = -far; dy <= far && seeds[at]; dy++) {
                for (int dx = -far; dx <= far; dx++) {
                    int to = dx * dx + dy * dy <= far * far ? ground.shifted(at, new int[] {dx, dy}) : -1;
                    if (to >= 0) {
                        around[to] = true;
                    }
                }
            }
        }
        return around;
    }
}
