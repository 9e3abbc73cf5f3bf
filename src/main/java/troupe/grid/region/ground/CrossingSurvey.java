package troupe.grid.region.ground;

import java.util.ArrayList;
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
 * Holds what movable obstacles do not change about crossings: for each take-off floor where it can be taken off
 * from at all, which spans lie within a step of it, and what a closing fills there. Each is found when first
 * asked for. Safe for any thread.
 */
public final class CrossingSurvey {
    /** The most entries of tables that are kept; larger ones are made again each time. */
    private static final long MOST_KEPT = 1 << 20;

    private final Scene scene;
    private final Actor actor;
    private final Spans spans;
    private final Columns columns;
    private final Standing standing;
    private final Solids fixed;
    private final GridFrame frame;
    private final double cell;
    private final int[] takeOff;
    private final int[] drops;
    private final int[][] near;
    private final List<List<Mask>> gaps;

    /** Cells of a window: 1 where a gap may be, 0 elsewhere. */
    public record Mask(Window window, byte[] cells) {}

    /** Looks where spans can be taken off from; {@code fixed} knows the immovable obstacles. Cost O(spans). */
    CrossingSurvey(Scene scene, Actor actor, Columns columns, Spans spans, Standing standing, Solids fixed) {
        this.scene = scene;
        this.actor = actor;
        this.spans = spans;
        this.columns = columns;
        this.standing = standing;
        this.fixed = fixed;
        this.frame = spans.frame();
        this.cell = frame.cell();
        this.takeOff = new int[4 * spans.levels()];
        this.drops = new int[spans.levels()];
        this.near = new int[spans.levels()][];
        this.gaps = new ArrayList<>();
        for (int level = 0; level < spans.levels(); level++) {
            gaps.add(null);
        }
        look();
    }

    /** Finds for each level the cells that bound its take-off places, and how many spans are over a drop. */
    private void look() {
        for (int level = 0; level < spans.levels(); level++) {
            takeOff[4 * level] = Integer.MAX_VALUE;
            takeOff[4 * level + 1] = Integer.MAX_VALUE;
            takeOff[4 * level + 2] = -1;
            takeOff[4 * level + 3] = -1;
        }
        byte[] kinds = standing.kinds();
        byte[] abilities = standing.abilities();
        int[] columnAt = spans.columnAt();
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
                    } else if (kinds[q] == Kind.STABLE && (abilities[q] & Ability.WALK.bit()) != 0) {
                        takeOff[4 * level] = Math.min(takeOff[4 * level], col);
                        takeOff[4 * level + 1] = Math.min(takeOff[4 * level + 1], row);
                        takeOff[4 * level + 2] = Math.max(takeOff[4 * level + 2], col);
                        takeOff[4 * level + 3] = row;
                    }
                }
            }
        }
    }

    /** Tells whether a level has take-off places while no movable obstacle stands there. */
    public boolean takesOff(int level) {
        return takeOff[4 * level + 2] >= takeOff[4 * level];
    }

    /** Returns the window that holds the take-off places of a level. */
    public Window takeOff(int level) {
        int col = takeOff[4 * level];
        int row = takeOff[4 * level + 1];
        return new Window(col, row, takeOff[4 * level + 2] - col + 1, takeOff[4 * level + 3] - row + 1);
    }

    /** Returns per column the first id of the sheet of the span within a step of a level, -1 if there is none. */
    public synchronized int[] sheetsNear(int level) {
        if (near[level] != null) {
            return near[level];
        }
        int[] base = new int[spans.columns()];
        for (int column = 0; column < base.length; column++) {
            base[column] = -1;
            for (int k = 0; k < spans.sheets(); k++) {
                if (within(spans.floor(column, k), spans.elevation(level))) {
                    base[column] = k * frame.size();
                }
            }
        }
        if ((long) base.length * near.length <= MOST_KEPT) {
            near[level] = base;
        }
        return base;
    }

    private boolean within(double height, double floor) {
        return Math.abs(height - floor) <= actor.stepHeight() + Column.SAME;
    }

    /** Returns where the gaps of a level may be, movable obstacles and straight crossings not looked at. */
    public synchronized List<Mask> gaps(int level) {
        if (gaps.get(level) == null) {
            List<Mask> found = new ArrayList<>();
            actor.stride().ifPresent(s -> findGaps(level, s.gait(), found));
            gaps.set(level, found);
        }
        return gaps.get(level);
    }

    private void findGaps(int level, double gait, List<Mask> found) {
        double floor = spans.elevation(level);
        int[] base = sheetsNear(level);
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
            clusters(level, gait).forEach(surface -> findGaps(level, gait, surface, base, free, found));
        }
    }

    /**
     * Returns windows around the surfaces within a step of a level that hold take-off places, such that a
     * crossing of at most {@code limit} metres from that level stays within one of them; they share no cell.
     */
    public List<Window> clusters(int level, double limit) {
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

    private void findGaps(int level, double gait, Window surface, int[] base, boolean[] free, List<Mask> found) {
        byte[] supported = new byte[surface.size()];
        byte[] open = new byte[surface.size()];
        int[] columnAt = spans.columnAt();
        byte[] kinds = standing.kinds();
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
        for (int i = 0; i < candidates.length; i++) {
            candidates[i] &= gap[i];
        }
        fixed.clearNear(spans.elevation(level), window, candidates);
        Window occupied = window.occupied(candidates);
        if (occupied.size() > 0) {
            found.add(new Mask(occupied, window.cut(candidates, occupied)));
        }
    }
}
