package troupe.grid.region;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Compares the crossings of random layered scenes with their definition: kernels cell by cell, every
 * solid asked at every cell, every pair of standing places tried. Scenes with ditches whose walls would have to be
 * taken by the cells they touch are left out: distances to ground are sampled here.
 */
class CrossingOracleTest {
    private static final int SCENES = 200;

    @Test
    void crossingsAreWhatTheDefinitionSays() {
        int gaps = 0;
        int jumps = 0;
        for (long seed = 1000; seed < 1000 + SCENES; seed++) {
            Scene scene = RandomScenes.layered(seed, 4, seed % 2 == 0 ? 0.2 : 0.25);
            Actor actor = RandomScenes.actor(seed);
            if (!scene.ditches().isEmpty()
                    && actor.walk().radius() < 0.71 * scene.world().cell()) {
                continue;
            }
            Region region = Region.of(scene, actor);
            Slow slow = new Slow(scene, region);
            TreeSet<String> expected = slow.crossings();
            TreeSet<String> found = new TreeSet<>();
            for (int q = region.spanCount(); q < region.size(); q++) {
                found.add(name(region.kind(q), region.elevation(q), region.cell(q)));
                gaps += region.kind(q) == Kind.GAP ? 1 : 0;
                jumps += region.kind(q) == Kind.JUMPABLE ? 1 : 0;
            }
            TreeSet<String> missing = new TreeSet<>(expected);
            missing.removeAll(found);
            found.removeAll(expected);
            assertEquals("[] []", missing + " " + found, "seed " + seed + ": missing, and too many");
            assertEquals(0, slow.wrongStraight, "seed " + seed + ": pairs on whose straight crossing we differ");
        }
        assertTrue(gaps > 700 && jumps > 700, "the scenes hold too few crossings: " + gaps + " and " + jumps);
    }

    private static String name(byte kind, double floor, int cell) {
        return Kind.word(kind) + " from " + floor + " over " + cell;
    }

    /** Works the definition out for one region, whose standing places are taken as given. */
    private static final class Slow {
        private final Scene scene;
        private final Actor actor;
        private final Region region;
        private final GridFrame frame;
        private final SlowRegion places;
        private int wrongStraight;

        Slow(Scene scene, Region region) {
            this.scene = scene;
            this.actor = region.actor();
            this.region = region;
            this.frame = region.frame();
            this.places = new SlowRegion(scene, actor);
        }

        TreeSet<String> crossings() {
            TreeSet<String> all = new TreeSet<>();
            TreeSet<Double> floors = new TreeSet<>();
            for (int q = 0; q < region.spanCount(); q++) {
                if (takesOff(q)) {
                    floors.add(region.elevation(q));
                }
            }
            for (double floor : floors) {
                actor.stride().ifPresent(s -> add(all, Kind.GAP, floor, gaps(floor, s.gait()), s.gait()));
                actor.vault().ifPresent(v -> add(all, Kind.JUMPABLE, floor, vaults(floor, v), v.reach()));
            }
            return all;
        }

        private boolean takesOff(int q) {
            return region.kind(q) == Kind.STABLE && (region.abilities(q) & Ability.WALK.bit()) != 0;
        }

        private int near(int cell, double floor) {
            for (int q = cell; q < region.spanCount(); q += frame.size()) {
                if (region.spans().exists(q) && Math.abs(region.elevation(q) - floor) <= actor.stepHeight() + 1e-9) {
                    return q;
                }
            }
            return -1;
        }

        private double x(int cell) {
            return frame.centreX(frame.col(cell));
        }

        private double y(int cell) {
            return frame.centreY(frame.row(cell));
        }

        private boolean[] gaps(double floor, double gait) {
            boolean[] supported = new boolean[frame.size()];
            for (int cell = 0; cell < supported.length; cell++) {
                int q = near(cell, floor);
                supported[cell] = q >= 0 && !places.overDrop(x(cell), y(cell), region.elevation(q), actor.footRadius());
            }
            boolean[] closed = closed(supported, gait / 2, false);
            boolean[] gaps = new boolean[frame.size()];
            for (int cell = 0; cell < gaps.length; cell++) {
                gaps[cell] = closed[cell] && !supported[cell] && headRoom(cell, floor);
            }
            return gaps;
        }

        /** Closes a mask by a disc of a radius in metres, on a plane that goes on around the frame. */
        private boolean[] closed(boolean[] mask, double radius, boolean outside) {
            double cells = radius / frame.cell();
            int reach = (int) cells + 1;
            int cols = frame.cols() + 4 * reach;
            int rows = frame.rows() + 4 * reach;
            boolean[] wide = new boolean[cols * rows];
            Arrays.fill(wide, outside);
            for (int cell = 0; cell < mask.length; cell++) {
                wide[(frame.row(cell) + 2 * reach) * cols + frame.col(cell) + 2 * reach] = mask[cell];
            }
            boolean[] dilated = swept(wide, cols, reach, cells, true);
            boolean[] eroded = swept(dilated, cols, reach, cells, false);
            boolean[] closed = new boolean[mask.length];
            for (int cell = 0; cell < mask.length; cell++) {
                closed[cell] = eroded[(frame.row(cell) + 2 * reach) * cols + frame.col(cell) + 2 * reach];
            }
            return closed;
        }

        /** Gives each cell the value if some cell within the radius has it; the rim of the mask stays. */
        private static boolean[] swept(boolean[] mask, int cols, int reach, double radius, boolean value) {
            boolean[] swept = mask.clone();
            int rows = mask.length / cols;
            for (int row = reach; row < rows - reach; row++) {
                for (int col = reach; col < cols - reach; col++) {
                    for (int dy = -reach; dy <= reach; dy++) {
                        for (int dx = -reach; dx <= reach; dx++) {
                            if (dx * dx + dy * dy <= radius * radius + 1e-6
                                    && mask[(row + dy) * cols + col + dx] == value) {
                                swept[row * cols + col] = value;
                            }
                        }
                    }
                }
            }
            return swept;
        }

        private boolean inWay(Polygon outline, int cell) {
            double radius = actor.walk().radius();
            return outline.distance(x(cell), y(cell)) < radius
                    || radius < 0.71 * frame.cell() && SlowRegion.crosses(outline, x(cell), y(cell), frame.cell() / 2);
        }

        private boolean edgeInWay(int cell) {
            double width = scene.world().width();
            double depth = scene.world().depth();
            double edge = Math.min(Math.min(x(cell), width - x(cell)), Math.min(y(cell), depth - y(cell)));
            return edge < actor.walk().radius() || edge <= 0;
        }

        private boolean headRoom(int cell, double floor) {
            if (edgeInWay(cell)
                    || places.groundWithin(x(cell), y(cell), floor, actor.walk().radius())) {
                return false;
            }
            return scene.obstacles().stream().noneMatch(o -> places.blocks(o, floor) && inWay(o.outline(), cell));
        }

        private boolean[] vaults(double floor, Actor.Vault vault) {
            boolean[] vaultable = new boolean[frame.size()];
            boolean[] walkable = new boolean[frame.size()];
            for (int cell = 0; cell < vaultable.length; cell++) {
                vaultable[cell] = vaultable(cell, floor, vault);
                int q = near(cell, floor);
                walkable[cell] = !vaultable[cell] && q >= 0 && (region.abilities(q) & Ability.WALK.bit()) != 0;
            }
            boolean[] notOpened = closed(walkable, vault.reach() / 2, false);
            for (int cell = 0; cell < vaultable.length; cell++) {
                vaultable[cell] &= notOpened[cell];
            }
            return vaultable;
        }

        private boolean vaultable(int cell, double floor, Actor.Vault vault) {
            if (edgeInWay(cell)) {
                return false;
            }
            List<double[]> solids = new ArrayList<>();
            for (Obstacle o : scene.obstacles()) {
                if (inWay(o.outline(), cell)) {
                    solids.add(new double[] {o.offset(), o.top(), o.movable() ? floor : floor + actor.stepHeight()});
                }
            }
            TreeSet<Double> grounds = new TreeSet<>(List.of(0.0));
            scene.ditches().forEach(d -> grounds.add(-d.depth()));
            for (double ground : grounds) {
                if (ground > floor + actor.stepHeight() + 1e-9
                        && places.groundAt(
                                x(cell), y(cell), ground, actor.walk().radius())) {
                    solids.add(new double[] {-1e9, ground, floor + actor.stepHeight()});
                }
            }
            double top = Double.NEGATIVE_INFINITY;
            for (double[] s : solids) {
                if (places.meets(s[0], s[1], s[2], floor + actor.bodyHeight())) {
                    top = Math.max(top, s[1]);
                }
            }
            double high = Math.max(floor + actor.bodyHeight(), top + vault.bodyHeight());
            boolean any = top > Double.NEGATIVE_INFINITY;
            for (double[] s : solids) {
                if (places.meets(s[0], s[1], s[2], high)) {
                    any &= s[1] >= floor + vault.minHeight() - 1e-9 && s[1] <= floor + vault.maxHeight() + 1e-9;
                }
            }
            return any;
        }

        /** Adds the candidates that some pair of standing places crosses in a straight line. */
        private void add(TreeSet<String> all, byte kind, double floor, boolean[] candidates, double limit) {
            boolean[] kept = new boolean[candidates.length];
            for (int begin = 0; begin < region.spanCount(); begin++) {
                if (!takesOff(begin) || region.elevation(begin) != floor) {
                    continue;
                }
                for (int cell = 0; cell < candidates.length; cell++) {
                    int end = near(cell, floor);
                    double distance = Math.hypot(x(cell) - region.x(begin), y(cell) - region.y(begin));
                    if (end >= 0 && takesOff(end) && distance <= limit + 1e-9) {
                        boolean legal = keep(region.cell(begin), cell, candidates, kept);
                        wrongStraight += legal == region.straight(begin, end, kind) ? 0 : 1;
                    }
                }
            }
            for (int cell = 0; cell < kept.length; cell++) {
                if (kept[cell]) {
                    all.add(name(kind, floor, cell));
                }
            }
        }

        private boolean keep(int begin, int end, boolean[] candidates, boolean[] kept) {
            int[] between = between(begin, end);
            if (between.length == 0 || !Arrays.stream(between).allMatch(c -> candidates[c])) {
                return false;
            }
            Arrays.stream(between).forEach(c -> kept[c] = true);
            return true;
        }

        /** Returns the cells, ends excepted, whose open inside the segment crosses: each cell of the box is clipped. */
        private int[] between(int begin, int end) {
            int[] cells = new int[0];
            double dx = frame.col(end) - frame.col(begin);
            double dy = frame.row(end) - frame.row(begin);
            Polygon segment = Polygon.of(0, 0, dx, dy);
            for (int col = Math.min(frame.col(begin), frame.col(end));
                    col <= Math.max(frame.col(begin), frame.col(end));
                    col++) {
                for (int row = Math.min(frame.row(begin), frame.row(end));
                        row <= Math.max(frame.row(begin), frame.row(end));
                        row++) {
                    int cell = frame.index(col, row);
                    if (cell != begin
                            && cell != end
                            && SlowRegion.crosses(segment, col - frame.col(begin), row - frame.row(begin), 0.5)) {
                        cells = Arrays.copyOf(cells, cells.length + 1);
                        cells[cells.length - 1] = cell;
                    }
                }
            }
            return cells;
        }
    }
}
