package troupe.grid.region;

import troupe.grid.layer.Spans;
import troupe.grid.region.ground.Words;
import troupe.scene.Actor;

/** Joins single spans to their neighbours, for cells where neighbouring columns differ. */
final class Joints {
    private final Spans spans;
    private final Words words;
    private final int[] at;
    private final int[] offsets;
    private final int cells;
    private final double stepHeight;
    private final double bodyHeight;

    Joints(Actor actor, Spans spans, Words words) {
        this.spans = spans;
        this.words = words;
        this.at = spans.columnAt();
        this.offsets = spans.frame().offsets();
        this.cells = spans.frame().size();
        this.stepHeight = actor.stepHeight();
        this.bodyHeight = actor.bodyHeight();
    }

    /** Returns the open span over {@code cell + offset} that is joined to an open span, -1 if there is none. */
    int joined(int q, int cell, int offset) {
        int from = at[cell];
        int to = at[cell + offset];
        int base = q - cell;
        if (from != to) {
            int sheet = spans.linked(from, base / cells, to, stepHeight, bodyHeight);
            if (sheet < 0) {
                return -1;
            }
            base = sheet * cells;
        }
        int target = base + cell + offset;
        return (words.get(target) & Words.STANDING) != 0 ? target : -1;
    }

    /** Returns the legal neighbour of an open span in direction {@code d} among the spans, -1 if there is none. */
    int legal(int q, int cell, int d) {
        int target = joined(q, cell, offsets[d]);
        if (d < 4 || target < 0) {
            return target;
        }
        return bridged(q, cell, offsets[d - 4], offsets[d - 3 & 3], target)
                        && bridged(q, cell, offsets[d - 3 & 3], offsets[d - 4], target)
                ? target
                : -1;
    }

    /** Tells whether two straight steps lead from a span to {@code target}. */
    private boolean bridged(int q, int cell, int first, int second, int target) {
        int middle = joined(q, cell, first);
        return middle >= 0 && joined(middle, cell + first, second) == target;
    }
}
