package troupe.grid.region;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.geometry.Box;
import troupe.grid.GridFrame;
import troupe.grid.Morphology;
import troupe.grid.Window;
import troupe.grid.layer.Column;
import troupe.grid.layer.Columns;
import troupe.grid.layer.Spans;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Finds the crossings of an actor: per take-off floor the gaps it can stride and the obstacles it can
 * vault, as far as they lie on a legal straight crossing. Works in windows around the surfaces or obstacles
 * in question, so that the cost follows what there is to cross.
 *
 * <p>Source: Unified section 5 (opening); Li and Huang (gaps by closing); semantics in {@code docs/grid.md}.
 */
final class CrossingFinder {
    private final Scene scene;
    private final Actor actor;
    private final Spans spans;
    private final Columns columns;
    private final Solids solids;
    private final byte[] kinds;
    private final byte[] abilities;
    private final GridFrame frame;
    private final double cell;
    private final int[] columnAt;
    private final int[] takeOff;
    private final int[] drops;
    private long[] found = new long[64];
    private int count;

    /** Prepares the search for crossings where movable obstacles stand and leave spans certain abilities. */
    CrossingFinder(Structure structure, Solid[] movables, byte[] abilities) {
        this.scene = structure.scene();
        this.actor = structure.actor();
        this.spans = structure.spans();
        this.columns = structure.columns();
        Standing standing = structure.standing();
        this.solids = new Solids(scene, actor, columns, standing.rims(), structure.solids(movables), spans.frame());
        this.kinds = standing.kinds();
        this.abilities = abilities;
        this.frame = spans.frame();
        this.cell = frame.cell();
        this.columnAt = spans.columnAt();
        this.takeOff = new int[4 * spans.levels()];
        this.drops = new int[spans.levels()];
        survey();
    }

    /** Finds all crossings. */
    Crossings find() {
        for (int level = 0; level < spans.levels(); level++) {
            if (takeOff[4 * level + 2] >= takeOff[4 * level]) {
                if (actor.stride().isPresent()) {
                    gaps(level, actor.stride().get().gait());
                }
                if (actor.vault().isPresent()) {
                    vaults(level, actor.vault().get());
                }
            }
        }
        return new Crossings(frame.size(), found, count);
    }

    /** Finds for each level the cells that bound its take-off places, and how many spans are over a drop. */
    private void survey() {
        for (int level = 0; level < spans.levels(); level++) {
            takeOff[4 * level] = Integer.MAX_VALUE;
            takeOff[4 * level + 1] = Integer.MAX_VALUE;
            takeOff[4 * level + 2] = -1;
            takeOff[4 * level + 3] = -1;
        }
        for (int sheet = 0; sheet < spans.sheets(); sheet++) {
            for (int row = 1; row < frame.rows() - 1; row++) {
                int base = row * frame.cols();
                for (int col = 1; col < frame.cols() - 1; col++) {
                    int q = sheet * frame.size() + base + col;
                    if (kinds[q] == Kind.ABSENT) {
                        continue;
                    }
                    int level = spans.level(columnAt[base + col], sheet);
                    if (kinds[q] == Kind.FORBIDDEN) {
                        drops[level]++;
                    } else if (takesOff(q)) {
                        takeOff[4 * level] = Math.min(takeOff[4 * level], col);
                        takeOff[4 * level + 1] = Math.min(takeOff[4 * level + 1], row);
                        takeOff[4 * level + 2] = Math.max(takeOff[4 * level + 2], col);
                        takeOff[4 * level + 3] = row;
                    }
                }
            }
        }
    }

    private boolean takesOff(int q) {
        return kinds[q] == Kind.STABLE && (abilities[q] & Ability.WALK.bit()) != 0;
    }

    /** Returns per column the first id of the sheet of the span within a step of a floor, -1 if there is none. */
    private int[] sheetsNear(double floor) {
        int[] base = new int[spans.columns()];
        for (int column = 0; column < base.length; column++) {
            base[column] = -1;
            for (int k = 0; k < spans.sheets(); k++) {
                if (Math.abs(spans.floor(column, k) - floor) <= actor.stepHeight() + Column.SAME) {
                    base[column] = k * frame.size();
                }
            }
        }
        return base;
    }

    private void gaps(int level, double gait) {
        double floor = spans.elevation(level);
        int[] base = sheetsNear(floor);
        boolean[] free = new boolean[base.length];
        boolean any = false;
        for (int column = 0; column < base.length; column++) {
            free[column] = !columns.column(column).meets(floor + actor.stepHeight(), floor + actor.bodyHeight());
            any |= free[column] && base[column] < 0;
        }
        for (int other = 0; other < drops.length; other++) {
            any |= drops[other] > 0 && within(spans.elevation(other), floor);
        }
        if (any) {
            clusters(level, gait).forEach(surface -> gaps(level, gait, surface, base, free));
        }
    }

    /**
     * Returns windows around the surfaces within a step of a level that hold take-off places, such that a
     * crossing of at most {@code limit} metres from that level stays within one of them; they share no cell.
     */
    private List<Window> clusters(int level, double limit) {
        double margin = limit / 2 + 2 * cell;
        List<Window> windows = new ArrayList<>();
        for (Box box : Window.apart(surfaces(spans.elevation(level), margin))) {
            Window window = Window.of(frame, box.grown(-margin));
            if (window.meets(takeOff(level))) {
                windows.add(window);
            }
        }
        return windows;
    }

    /** Returns the window that holds the take-off places of a level. */
    private Window takeOff(int level) {
        int col = takeOff[4 * level];
        int row = takeOff[4 * level + 1];
        return new Window(col, row, takeOff[4 * level + 2] - col + 1, takeOff[4 * level + 3] - row + 1);
    }

    private boolean within(double height, double floor) {
        return Math.abs(height - floor) <= actor.stepHeight() + Column.SAME;
    }

    /** Returns the boxes of the surfaces within a step of a floor, grown by a margin in metres. */
    private List<Box> surfaces(double floor, double margin) {
        if (within(0, floor)) {
            return List.of(new Box(0, 0, scene.world().width(), scene.world().depth()).grown(margin));
        }
        List<Box> boxes = new ArrayList<>();
        for (Ditch ditch : scene.ditches()) {
            if (within(-ditch.depth(), floor)) {
                boxes.add(ditch.outline().bounds().grown(margin));
            }
        }
        for (Obstacle obstacle : scene.obstacles()) {
            if (!obstacle.movable() && within(obstacle.top(), floor)) {
                boxes.add(obstacle.outline().bounds().grown(margin));
            }
        }
        return boxes;
    }

    private void gaps(int level, double gait, Window surface, int[] base, boolean[] free) {
        byte[] supported = new byte[surface.size()];
        byte[] open = new byte[surface.size()];
        for (int row = 0, i = 0; row < surface.rows(); row++) {
            int at = (surface.row0() + row) * frame.cols() + surface.col0();
            for (int end = i + surface.cols(); i < end; i++, at++) {
                int column = columnAt[at];
                boolean carries = base[column] >= 0 && kinds[base[column] + at] != Kind.FORBIDDEN;
                supported[i] = (byte) (carries ? 1 : 0);
                open[i] = (byte) (!carries && free[column] ? 1 : 0);
            }
        }
        Window holes = surface.occupied(open);
        if (holes.size() == 0) {
            return;
        }
        Window window = holes.grown((int) Math.ceil(gait / cell) + 1, frame).common(surface);
        byte[] gap = surface.cut(supported, window);
        byte[] candidates = surface.cut(open, window);
        double radius = gait / 2 / cell;
        new Morphology(window.cols(), window.rows(), radius).close(gap, radius, false, gap);
        int any = 0;
        for (int i = 0; i < candidates.length; i++) {
            candidates[i] &= gap[i];
            any |= candidates[i];
        }
        if (any != 0) {
            solids.clearNear(spans.elevation(level), window, candidates);
            keep(level, Kind.GAP, gait, window, candidates, base);
        }
    }

    private void vaults(int level, Actor.Vault vault) {
        double floor = spans.elevation(level);
        List<Box> boxes = solids.vaultable(floor, vault);
        if (boxes.isEmpty()) {
            return;
        }
        Window reachable = takeOff(level).grown((int) Math.ceil(vault.reach() / cell) + 1, frame);
        List<Window> clusters = clusters(level, vault.reach());
        int[] base = sheetsNear(floor);
        List<Window> windows = new ArrayList<>();
        for (Box box : Window.apart(boxes)) {
            for (Window cluster : clusters) {
                Window window = Window.of(frame, box).common(reachable).common(cluster);
                if (window.size() > 0) {
                    windows.add(window);
                }
            }
        }
        int margin = 3 * (int) Math.ceil(vault.reach() / 2 / cell);
        Window.merged(windows, margin).forEach(window -> vaults(level, vault, window, base));
    }

    private void vaults(int level, Actor.Vault vault, Window inner, int[] base) {
        Window window = inner.grown((int) Math.ceil(vault.reach() / cell) + 1, frame);
        byte[] vaultable = new byte[window.size()];
        if (!solids.vaultable(spans.elevation(level), vault, window, vaultable)) {
            return;
        }
        byte[] barred = new byte[window.size()];
        int walk = Ability.WALK.bit();
        for (int row = 0, i = 0; row < window.rows(); row++) {
            int at = (window.row0() + row) * frame.cols() + window.col0();
            for (int end = i + window.cols(); i < end; i++, at++) {
                int first = base[columnAt[at]];
                boolean walkable = first >= 0 && (abilities[first + at] & walk) != 0;
                barred[i] = walkable ? vaultable[i] : 1;
            }
        }
        double radius = vault.reach() / 2 / cell;
        new Morphology(window.cols(), window.rows(), radius).open(barred, radius, true, barred);
        byte[] candidates = new byte[window.size()];
        int any = 0;
        for (int row = inner.row0(); row < inner.row0() + inner.rows(); row++) {
            int i = (row - window.row0()) * window.cols() + inner.col0() - window.col0();
            for (int end = i + inner.cols(); i < end; i++) {
                candidates[i] = (byte) (vaultable[i] & ~barred[i]);
                any |= candidates[i];
            }
        }
        if (any != 0) {
            keep(level, Kind.JUMPABLE, vault.reach(), window, candidates, base);
        }
    }

    /** Keeps of the candidates in a window what lies on a legal straight crossing. */
    private void keep(int level, byte kind, double limit, Window window, byte[] candidates, int[] base) {
        Window ends = window.occupied(candidates).grown(1, frame).common(window);
        byte[] state = window.cut(candidates, ends);
        for (int row = 0, i = 0; row < ends.rows(); row++) {
            int at = (ends.row0() + row) * frame.cols() + ends.col0();
            for (int end = i + ends.cols(); i < end; i++, at++) {
                int first = base[columnAt[at]];
                if (first >= 0 && takesOff(first + at)) {
                    boolean begins = spans.level(columnAt[at], first / frame.size()) == level;
                    state[i] |= (byte) (begins ? Pruning.END | Pruning.BEGIN : Pruning.END);
                }
            }
        }
        byte[] kept = new Pruning(ends.cols(), ends.rows(), state).kept(Pruning.squaredCells(limit, cell));
        for (int row = 0, i = 0; row < ends.rows(); row++) {
            int at = (ends.row0() + row) * frame.cols() + ends.col0();
            for (int end = i + ends.cols(); i < end; i++, at++) {
                if (kept[i] != 0) {
                    if (count == found.length) {
                        found = Arrays.copyOf(found, 2 * count);
                    }
                    found[count++] = Crossings.key(at, level, kind);
                }
            }
        }
    }
}
