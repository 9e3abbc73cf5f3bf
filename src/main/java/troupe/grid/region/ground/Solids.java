package troupe.grid.region.ground;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;
import troupe.geometry.Box;
import troupe.geometry.Polygon;
import troupe.grid.CellRuns;
import troupe.grid.GridFrame;
import troupe.grid.Window;
import troupe.grid.layer.Column;
import troupe.grid.layer.Columns;
import troupe.scene.Actor;
import troupe.scene.Scene;

/**
 * Asks, for a take-off floor, which solids come within the walk radius of the cells of a window: the
 * obstacles that are there, the ground beside ditches, and the world's edge. As for standing bodies, a radius under
 * {@link Standing#TOUCHING} cells takes in the cells that an outline touches.
 */
public final class Solids {
    private static final byte HIT = 1;
    private static final byte BAD = 2;

    private final Scene scene;
    private final Actor actor;
    private final Columns columns;
    private final Rims rims;
    private final GridFrame frame;
    private final CellRuns runs;
    private final double radius;
    private final boolean touching;
    private final List<Solid> all;
    private final double[] grounds;
    private final double highestGround;
    private final List<Integer> walls;
    private final int[] edge;

    /** The cells near each piece of a rim, as far as they have been asked for; shared by all who ask about others. */
    private final AtomicReferenceArray<int[]> pieces;

    /** Prepares the questions for given obstacles. Cost O(columns + rims + rows). */
    public Solids(Scene scene, Actor actor, Columns columns, Rims rims, List<Solid> all, GridFrame frame) {
        this.scene = scene;
        this.actor = actor;
        this.columns = columns;
        this.rims = rims;
        this.frame = frame;
        this.runs = new CellRuns(frame);
        this.radius = actor.walk().radius();
        this.touching = radius < Standing.TOUCHING * frame.cell();
        this.all = all;
        this.grounds = new double[columns.count()];
        for (int id = 0; id < grounds.length; id++) {
            grounds[id] = columns.column(id).ground();
        }
        this.highestGround = Arrays.stream(grounds).max().orElse(0);
        this.walls = new ArrayList<>();
        for (int i = 0; i < rims.size(); i++) {
            if (leftGround(i) != rightGround(i)) {
                walls.add(i);
            }
        }
        runs.nearEdge(scene.world(), radius);
        if (touching) {
            runs.touch(
                    Polygon.rectangle(0, 0, scene.world().width(), scene.world().depth()));
        }
        this.edge = runs.copy();
        this.pieces = new AtomicReferenceArray<>(rims.size());
    }

    private Solids(Solids other, List<Solid> all) {
        this.scene = other.scene;
        this.actor = other.actor;
        this.columns = other.columns;
        this.rims = other.rims;
        this.frame = other.frame;
        this.runs = new CellRuns(frame);
        this.radius = other.radius;
        this.touching = other.touching;
        this.all = all;
        this.grounds = other.grounds;
        this.highestGround = other.highestGround;
        this.walls = other.walls;
        this.edge = other.edge;
        this.pieces = other.pieces;
    }

    /** Returns the same questions about other obstacles, with memory of its own. Cost O(1). */
    public Solids about(List<Solid> others) {
        return new Solids(this, others);
    }

    /** Clears the cells of a mask that a solid in the way of a body on {@code floor} comes near. */
    public void clearNear(double floor, Window window, byte[] mask) {
        Window.Stretch clear = (from, to) -> Arrays.fill(mask, from, to, (byte) 0);
        worldEdge(window);
        window.each(runs, frame, clear);
        clearNearObstacles(floor, window, mask);
        for (int i : walls) {
            if (Math.max(leftGround(i), rightGround(i)) > floor + actor.stepHeight() + Column.SAME) {
                piece(i);
                window.each(runs, frame, clear);
            }
        }
    }

    /** Clears the cells of a mask that an obstacle in the way of a body on {@code floor} comes near. */
    public void clearNearObstacles(double floor, Window window, byte[] mask) {
        for (Solid solid : all) {
            if (solid.box().meets(window) && solid.blocks(floor)) {
                runs.clear();
                runs.add(solid.barsGaps());
                window.each(runs, frame, (from, to) -> Arrays.fill(mask, from, to, (byte) 0));
            }
        }
    }

    private double leftGround(int i) {
        return columns.column(rims.left(i)).ground();
    }

    private double rightGround(int i) {
        return columns.column(rims.right(i)).ground();
    }

    /** Puts the cells near the world's edge into the runs, none if the window lies away from it. */
    private void worldEdge(Window window) {
        runs.clear();
        int margin = (int) (radius / frame.cell()) + 3;
        boolean near = window.col0() <= margin
                || window.row0() <= margin
                || window.col0() + window.cols() >= frame.cols() - margin
                || window.row0() + window.rows() >= frame.rows() - margin;
        if (near) {
            runs.add(edge);
        }
    }

    /** Puts the cells near a piece into the runs; which they are is found once. */
    private void piece(int i) {
        runs.clear();
        int[] known = pieces.get(i);
        if (known != null) {
            runs.add(known);
            return;
        }
        rims.near(i, radius, runs);
        if (touching) {
            rims.touch(i, runs);
        }
        pieces.set(i, runs.copy());
    }

    /** Returns the grown boxes of the solids that a vault from {@code floor} may go over. */
    public List<Box> vaultable(double floor, Actor.Vault vault) {
        List<Box> boxes = new ArrayList<>();
        double margin = radius + frame.cell();
        for (Solid solid : all) {
            if (solid.blocks(floor) && solid.inRange(floor, vault)) {
                boxes.add(solid.outline().bounds().grown(margin));
            }
        }
        for (double ground : grounds) {
            if (Solid.inRange(ground, floor, vault)) {
                return List.of(
                        new Box(0, 0, scene.world().width(), scene.world().depth()));
            }
        }
        return boxes;
    }

    /**
     * Sets the cells of a window that are in the way of a walking body on {@code floor} only because of
     * solids whose tops a vault can take, with room above the highest of them for the vaulting body.
     *
     * @return whether there are any
     */
    public boolean vaultable(double floor, Actor.Vault vault, Window window, byte[] mask) {
        List<Solid> low = new ArrayList<>();
        for (Solid solid : all) {
            if (solid.box().meets(window) && solid.blocks(floor) && solid.inRange(floor, vault)) {
                low.add(solid);
            }
        }
        if (!scene.ditches().isEmpty()) {
            rate(floor, vault, window, all, mask);
        } else if (low.isEmpty()) {
            return false;
        } else {
            rate(
                    floor,
                    vault,
                    window,
                    all.stream().filter(s -> meetsAny(s, low)).toList(),
                    mask);
        }
        int any = 0;
        for (int i = 0; i < mask.length; i++) {
            mask[i] = (byte) (mask[i] & ~(mask[i] >> 1) & HIT);
            any |= mask[i];
        }
        return any != 0;
    }

    /**
     * Sets the cells of a window near which something is in the way of a walking body on {@code floor} that no
     * vault can take: a solid with its top out of range, or one that leaves no room above another.
     */
    public void untakeable(double floor, Actor.Vault vault, Window window, byte[] mask) {
        rate(floor, vault, window, all, mask);
        for (int i = 0; i < mask.length; i++) {
            mask[i] = (byte) ((mask[i] & BAD) != 0 ? 1 : 0);
        }
    }

    /** Marks the cells where some solids, or ground, are in the way, and where these cannot be vaulted. */
    private void rate(double floor, Actor.Vault vault, Window window, List<Solid> some, byte[] mask) {
        List<Solid> above = new ArrayList<>();
        List<Solid> inTheWay = new ArrayList<>();
        for (Solid solid : some) {
            if (!solid.box().meets(window)) {
                continue;
            }
            if (solid.blocks(floor)) {
                inTheWay.add(solid);
            } else if (solid.hangsAbove(floor) && !solid.inRange(floor, vault)) {
                above.add(solid);
            }
        }
        double[] highest = new double[above.isEmpty() ? 0 : window.size()];
        ground(floor, vault, window, mask, highest);
        for (Solid solid : inTheWay) {
            covered(solid);
            hit(solid.top(), solid.inRange(floor, vault), window, mask, highest);
        }
        for (Solid solid : above) {
            double offset = solid.obstacle().offset();
            covered(solid);
            window.each(runs, frame, (from, to) -> {
                for (int i = from; i < to; i++) {
                    if (mask[i] == HIT && offset < highest[i] + vault.bodyHeight() - Column.SAME) {
                        mask[i] |= BAD;
                    }
                }
            });
        }
    }

    private void covered(Solid solid) {
        runs.clear();
        runs.add(solid.cover());
    }

    /** Tells whether a solid's box meets that of any of some others, or it is one of them. */
    private static boolean meetsAny(Solid solid, List<Solid> others) {
        for (Solid other : others) {
            if (solid.box().meets(other.box())) {
                return true;
            }
        }
        return false;
    }

    /** Marks where ground, or the world's edge, stands in the way. */
    private void ground(double floor, Actor.Vault vault, Window window, byte[] mask, double[] highest) {
        double limit = floor + actor.stepHeight() + Column.SAME;
        worldEdge(window);
        hit(Double.POSITIVE_INFINITY, false, window, mask, highest);
        if (highestGround <= limit) {
            return;
        }
        int[] at = columns.at();
        for (int row = 0; row < window.rows(); row++) {
            int cell = (window.row0() + row) * frame.cols() + window.col0();
            for (int i = row * window.cols(), end = i + window.cols(); i < end; i++, cell++) {
                double ground = grounds[at[cell]];
                if (ground > limit) {
                    mask[i] |= Solid.inRange(ground, floor, vault) ? HIT : HIT | BAD;
                    if (highest.length > 0) {
                        highest[i] = ground;
                    }
                }
            }
        }
        for (int i : walls) {
            for (double ground : new double[] {leftGround(i), rightGround(i)}) {
                if (ground > limit) {
                    piece(i);
                    hit(ground, Solid.inRange(ground, floor, vault), window, mask, highest);
                }
            }
        }
    }

    private void hit(double top, boolean inRange, Window window, byte[] mask, double[] highest) {
        int bits = inRange ? HIT : HIT | BAD;
        if (highest.length == 0) {
            window.each(runs, frame, (from, to) -> {
                for (int i = from; i < to; i++) {
                    mask[i] |= (byte) bits;
                }
            });
            return;
        }
        window.each(runs, frame, (from, to) -> {
            for (int i = from; i < to; i++) {
                highest[i] = (mask[i] & HIT) == 0 ? top : Math.max(highest[i], top);
                mask[i] = (byte) (mask[i] | bits);
            }
        });
    }
}
