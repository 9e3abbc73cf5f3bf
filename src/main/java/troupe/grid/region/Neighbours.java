package troupe.grid.region;

import java.util.Locale;
import troupe.grid.GridFrame;
import troupe.grid.GridLimitException;
import troupe.grid.Window;
import troupe.grid.layer.Column;
import troupe.grid.layer.Spans;
import troupe.grid.region.crossing.Crossings;
import troupe.grid.region.ground.Words;
import troupe.scene.Actor;

/** Finds the legal neighbours of configurations that have some on other sheets or crossings near. */
final class Neighbours {
    private static final long[] NO_SHEETS = {};

    private final GridFrame frame;
    private final Spans spans;
    private final int[] columnAt;
    private final Crossings crossings;
    private final Words words;
    private final Joints joints;
    private final double stepHeight;
    private final int[] offsets;
    private final int spanCount;

    /**
     * Prepares the search for neighbours in finished words.
     *
     * @throws GridLimitException if too many crossings lie over a cell
     */
    Neighbours(Actor actor, Spans spans, Crossings crossings, Words words) {
        this.frame = spans.frame();
        this.spans = spans;
        this.columnAt = spans.columnAt();
        this.crossings = crossings;
        this.words = words;
        this.joints = new Joints(actor, spans, words);
        this.stepHeight = actor.stepHeight();
        this.offsets = frame.offsets();
        this.spanCount = spans.size();
        for (int n = 0; n < crossings.cells(); n++) {
            int over = crossings.start(n + 1) - crossings.start(n);
            if (over >= Region.MAX_NEIGHBOURS / GridFrame.DIRECTIONS) {
                int cell = crossings.cell(crossings.start(n));
                throw new GridLimitException(
                        String.format(
                                Locale.ROOT,
                                "%d crossings begin or pass at (%.3g, %.3g); at most %d fit",
                                over,
                                frame.centreX(frame.col(cell)),
                                frame.centreY(frame.row(cell)),
                                Region.MAX_NEIGHBOURS / GridFrame.DIRECTIONS - 1),
                        "give steps near there fewer different heights");
            }
        }
    }

    /**
     * Marks as special, over the cells of a window, the open spans that may have a crossing for a neighbour. Cost
     * O(crossings near + cells of the boxes around those of each level).
     */
    void markNear(Window window) {
        Window around = window.grown(1, frame);
        int[] start = new int[spans.levels() + 1];
        for (int row = around.row0(); row < around.row0() + around.rows(); row++) {
            int from = frame.index(around.col0(), row);
            int end = crossings.first(from + around.cols());
            for (int i = crossings.first(from); i < end; i++) {
                start[crossings.level(i) + 1]++;
            }
        }
        for (int level = 0; level < spans.levels(); level++) {
            start[level + 1] += start[level];
        }
        int[] cells = new int[start[spans.levels()]];
        int[] next = start.clone();
        for (int row = around.row0(); row < around.row0() + around.rows(); row++) {
            int from = frame.index(around.col0(), row);
            int end = crossings.first(from + around.cols());
            for (int i = crossings.first(from); i < end; i++) {
                cells[next[crossings.level(i)]++] = crossings.cell(i);
            }
        }
        for (int level = 0; level < spans.levels(); level++) {
            if (start[level] < start[level + 1]) {
                markNear(window, cells, start[level], start[level + 1], sheetsNear(spans.elevation(level)));
            }
        }
    }

    /** Returns for each column a bit set, in longs of their own, of its sheets within a step of an elevation. */
    private long[][] sheetsNear(double elevation) {
        long[][] near = new long[spans.columns()][];
        int sheets = spans.sheets();
        for (int column = 0; column < near.length; column++) {
            near[column] = NO_SHEETS;
            for (int sheet = 0; sheet < sheets && spans.level(column, sheet) >= 0; sheet++) {
                if (Math.abs(spans.floor(column, sheet) - elevation) <= stepHeight + Column.SAME) {
                    near[column] = near[column] == NO_SHEETS ? new long[(sheets >> 6) + 1] : near[column];
                    near[column][sheet >> 6] |= 1L << sheet;
                }
            }
        }
        return near;
    }

    /** Marks what is near crossings of one elevation, which lie over the ascending cells from {@code first} on. */
    private void markNear(Window window, int[] cells, int first, int end, long[][] sheets) {
        int left = frame.cols();
        int right = 0;
        for (int i = first; i < end; i++) {
            int col = frame.col(cells[i]);
            left = Math.min(left, col);
            right = Math.max(right, col);
        }
        int bottom = frame.row(cells[first]);
        int wide = right - left + 5;
        byte[] mask = new byte[wide * (frame.row(cells[end - 1]) - bottom + 5)];
        for (int i = first; i < end; i++) {
            int row = frame.row(cells[i]);
            mask[(row - bottom + 2) * wide + cells[i] - row * frame.cols() - left + 2] = 1;
        }
        Window box = new Window(left - 1, bottom - 1, wide - 2, mask.length / wide - 2).common(window);
        for (int row = box.row0(); row < box.row0() + box.rows(); row++) {
            int at = (row - bottom + 2) * wide + box.col0() - left + 2;
            int cell = frame.index(box.col0(), row);
            int before = mask[at - 1] | mask[at - 1 - wide] | mask[at - 1 + wide];
            int here = mask[at] | mask[at - wide] | mask[at + wide];
            for (int last = cell + box.cols(); cell < last; cell++, at++) {
                int after = mask[at + 1] | mask[at + 1 - wide] | mask[at + 1 + wide];
                if ((before | mask[at - wide] | mask[at + wide] | after) != 0) {
                    mark(cell, sheets[columnAt[cell]]);
                }
                before = here;
                here = after;
            }
        }
    }

    private void mark(int cell, long[] sheets) {
        for (int k = 0; k < sheets.length; k++) {
            for (long rest = sheets[k]; rest != 0; rest &= rest - 1) {
                int q = cell + ((k << 6) + Long.numberOfTrailingZeros(rest)) * frame.size();
                int word = words.get(q);
                if ((word & Words.STANDING) != 0 && (word & Words.SPECIAL) == 0) {
                    words.set(q, word | Words.SPECIAL);
                }
            }
        }
    }

    private boolean near(double floor, int crossing) {
        return Math.abs(floor - spans.elevation(crossings.level(crossing))) <= stepHeight + Column.SAME;
    }

    /** Finds the legal neighbours of an open configuration, ascending by direction, then id. */
    int of(int q, int cell, int[] targets, int[] directions) {
        return of(q, cell, GridFrame.DIRECTIONS, targets, directions);
    }

    /** Finds the legal neighbours of an open configuration in the first {@code limit} directions. */
    int of(int q, int cell, int limit, int[] targets, int[] directions) {
        return q < spanCount
                ? ofSpan(q, cell, limit, targets, directions)
                : ofCrossing(q, cell, limit, targets, directions);
    }

    private int ofSpan(int q, int cell, int limit, int[] targets, int[] directions) {
        int word = words.get(q);
        if ((word & Words.STANDING) == 0) {
            return 0;
        }
        int count = 0;
        for (int d = 0; d < limit; d++) {
            int to = cell + offsets[d];
            int target = q + offsets[d];
            if ((word & Words.ELSEWHERE) != 0) {
                target = joints.legal(q, cell, d);
            } else if ((word >> Words.MOVES + d & 1) == 0) {
                target = -1;
            }
            if (target >= 0) {
                targets[count] = target;
                directions[count++] = d;
            }
            for (int i = crossings.first(to), end = crossings.first(to + 1); i < end; i++) {
                if (legal(q, cell, d, spanCount + i, targets, directions, count)) {
                    targets[count] = spanCount + i;
                    directions[count++] = d;
                }
            }
        }
        return count;
    }

    /**
     * Finds the neighbours of a crossing. One of the same level and kind is joined to all that this one is joined to,
     * so a diagonal past it is bridged on that side.
     */
    private int ofCrossing(int q, int cell, int limit, int[] targets, int[] directions) {
        int level = crossings.level(q - spanCount);
        byte kind = crossings.kind(q - spanCount);
        int count = 0;
        int same = 0;
        for (int d = 0; d < limit; d++) {
            int to = cell + offsets[d];
            int open = d < 4 ? 0 : (1 << d - 4 | 1 << (d - 3 & 3)) & ~same;
            int column = columnAt[to];
            for (int sheet = 0; sheet < spans.sheets() && spans.level(column, sheet) >= 0; sheet++) {
                int target = sheet * frame.size() + to;
                if (near(spans.floor(column, sheet), q - spanCount)
                        && (words.get(target) & Words.STANDING) != 0
                        && bridged(open, cell, target, to, targets, directions, count)) {
                    targets[count] = target;
                    directions[count++] = d;
                }
            }
            int crossing = crossings.find(to, level, kind);
            if (crossing >= 0 && bridged(open, cell, spanCount + crossing, to, targets, directions, count)) {
                targets[count] = spanCount + crossing;
                directions[count++] = d;
                same |= 1 << d;
            }
        }
        return count;
    }

    /** Tells whether something found in each straight direction of a set is joined to the target, too. */
    private boolean bridged(int open, int cell, int target, int to, int[] targets, int[] directions, int count) {
        for (int straight = 0; straight < 4; straight++) {
            if ((open >> straight & 1) != 0 && !bridges(cell, straight, target, to, targets, directions, count)) {
                return false;
            }
        }
        return true;
    }

    /** Tells whether the step from a span to a crossing is legal; straight neighbours have been found before. */
    private boolean legal(int q, int cell, int d, int target, int[] targets, int[] directions, int count) {
        int open = d < 4 ? 0 : 1 << d - 4 | 1 << (d - 3 & 3);
        return joins(q, cell, target, cell + offsets[d])
                && (isEven(q, cell, open)
                        || bridged(open, cell, target, cell + offsets[d], targets, directions, count));
    }

    /** Tells whether steps lead in some straight directions to spans on the same floor: what joins the one joins them. */
    private boolean isEven(int q, int cell, int straight) {
        boolean even = (words.get(q) >> Words.MOVES & straight) == straight;
        for (int d = 0; even && d < 4; d++) {
            even = (straight >> d & 1) == 0 || columnAt[cell + offsets[d]] == columnAt[cell];
        }
        return even;
    }

    /** Tells whether something found in a straight direction is joined to the target, too. */
    private boolean bridges(int cell, int straight, int target, int to, int[] targets, int[] directions, int count) {
        for (int k = 0; k < count && directions[k] < 4; k++) {
            if (directions[k] == straight && joins(targets[k], cell + offsets[straight], target, to)) {
                return true;
            }
        }
        return false;
    }

    /** Tells whether two open configurations of neighbouring cells can follow each other. */
    private boolean joins(int a, int cellA, int b, int cellB) {
        if (a < spanCount && b < spanCount) {
            return joints.joined(a, cellA, cellB - cellA) == b;
        }
        if (a < spanCount) {
            return near(spans.floor(a), b - spanCount);
        }
        if (b < spanCount) {
            return near(spans.floor(b), a - spanCount);
        }
        int i = a - spanCount;
        int j = b - spanCount;
        return crossings.kind(i) == crossings.kind(j) && crossings.level(i) == crossings.level(j);
    }
}
