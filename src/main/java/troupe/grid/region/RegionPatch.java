package troupe.grid.region;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import troupe.grid.GridFrame;
import troupe.grid.Window;
import troupe.grid.layer.Column;
import troupe.grid.layer.Spans;
import troupe.grid.region.crossing.CrossingFinder;
import troupe.grid.region.crossing.Crossings;
import troupe.grid.region.ground.Kind;
import troupe.grid.region.ground.Solid;
import troupe.grid.region.ground.Structure;
import troupe.grid.region.ground.Words;

/**
 * Works out what changes in a region when movable obstacles are put, taken or moved, in the boxes where
 * something can change: bodies within the box of an outline and the walk radius, gaps within the gait of that,
 * vaults within twice the reach (an opening spreads a change by the reach, and a crossing passes on by as much),
 * steps one cell further. Everything else is shared. Used once.
 */
final class RegionPatch {
    private final Structure structure;
    private final Solid[] movables;
    private final List<Solid> changed = new ArrayList<>();
    private final GridFrame frame;
    private final Spans spans;
    private final Words words;
    private final boolean[] stale;
    private final boolean[] affected;
    private Crossings crossings;
    private Neighbours neighbours;

    /** Prepares the change from where movable obstacles stood to where they stand; null where one is not there. */
    RegionPatch(Structure structure, Solid[] before, Words words, Crossings crossings, Solid[] movables) {
        this.structure = structure;
        this.movables = movables;
        this.spans = structure.spans();
        this.frame = spans.frame();
        this.words = words.copy();
        this.crossings = crossings;
        this.stale = new boolean[TargetBand.bands(frame)];
        this.affected = new boolean[spans.levels()];
        for (int i = 0; i < movables.length; i++) {
            if (before[i] != movables[i]) {
                Arrays.asList(before[i], movables[i]).stream()
                        .filter(Objects::nonNull)
                        .filter(s -> s.box().size() > 0)
                        .forEach(changed::add);
            }
        }
    }

    /** Makes the changes. */
    void run() {
        List<Window> boxes = new ArrayList<>();
        for (Solid solid : changed) {
            boxes.add(solid.box());
            structure.standing().stand(movables, solid.box(), words);
        }
        List<Window> steps = new ArrayList<>();
        for (Window box : boxes) {
            steps.add(box.grown(1, frame));
        }
        if (structure.crosses()) {
            cross(boxes, steps);
        }
        neighbours = new Neighbours(structure.actor(), spans, crossings, words);
        Moves moves = new Moves(spans, words, new Joints(structure.actor(), spans, words));
        for (Window window : steps) {
            moves.compute(window);
            neighbours.markNear(window);
            outdate(window.row0() - 1, window.row0() + window.rows());
        }
    }

    private void cross(List<Window> boxes, List<Window> steps) {
        for (int level = 0; level < affected.length; level++) {
            affected[level] = affects(level);
        }
        CrossingFinder finder = new CrossingFinder(structure, movables, words);
        List<List<Window>> gaps = new ArrayList<>();
        List<List<Window>> vaults = new ArrayList<>();
        for (int level = 0; level < affected.length; level++) {
            List<Window> gapsHere = new ArrayList<>();
            List<Window> vaultsHere = new ArrayList<>();
            if (affected[level]) {
                for (Window box : boxes) {
                    gapsHere.addAll(finder.gapsAround(level, box));
                    vaultsHere.addAll(finder.vaultsAround(level, box, changed));
                }
            }
            gaps.add(Window.merged(gapsHere, 0));
            vaults.add(Window.merged(vaultsHere, 0));
            for (Window area : gaps.get(level)) {
                finder.gaps(level, area);
            }
            for (Window area : vaults.get(level)) {
                finder.vaults(level, area);
            }
        }
        replace(finder.found(), gaps, vaults, steps);
    }

    /** Tells whether what changes may change crossings of a level: where they end, what they pass or pass under. */
    private boolean affects(int level) {
        double floor = spans.elevation(level);
        for (Solid solid : changed) {
            if (solid.hangsAbove(floor)) {
                return true;
            }
            for (int near = 0; near < affected.length; near++) {
                if (solid.blocks(spans.elevation(near))
                        && Math.abs(spans.elevation(near) - floor)
                                <= structure.actor().stepHeight() + Column.SAME) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Puts what was found in place of the crossings of each level in its areas. */
    private void replace(long[] found, List<List<Window>> gaps, List<List<Window>> vaults, List<Window> steps) {
        long[] keys = new long[crossings.size() + found.length];
        int count = 0;
        int next = 0;
        Bounds differing = new Bounds();
        for (long key : crossings.keys()) {
            int level = Crossings.level(key);
            if (!affected[level] || !lies(key, Crossings.kind(key) == Kind.GAP ? gaps.get(level) : vaults.get(level))) {
                while (next < found.length && found[next] < key) {
                    differing.add(Crossings.cell(found[next]));
                    keys[count++] = found[next++];
                }
                keys[count++] = key;
                continue;
            }
            while (next < found.length && found[next] < key) {
                differing.add(Crossings.cell(found[next]));
                keys[count++] = found[next++];
            }
            if (next < found.length && found[next] == key) {
                keys[count++] = found[next++];
            } else {
                differing.add(Crossings.cell(key));
            }
        }
        while (next < found.length) {
            differing.add(Crossings.cell(found[next]));
            keys[count++] = found[next++];
        }
        differing.finish(steps);
        if (differing.any) {
            crossings = new Crossings(frame.size(), Arrays.copyOf(keys, count));
        }
    }

    private boolean lies(long key, List<Window> areas) {
        int row = frame.row(Crossings.cell(key));
        int col = Crossings.cell(key) - row * frame.cols();
        for (Window area : areas) {
            if (area.holds(col, row)) {
                return true;
            }
        }
        return false;
    }

    /** Collects where crossings differ, in bands of rows. */
    private final class Bounds {
        private final int[] left = new int[stale.length];
        private final int[] right = new int[stale.length];
        private boolean any;

        Bounds() {
            Arrays.fill(left, Integer.MAX_VALUE);
            Arrays.fill(right, -1);
        }

        void add(int cell) {
            int row = frame.row(cell);
            int band = row / TargetBand.ROWS;
            left[band] = Math.min(left[band], cell - row * frame.cols());
            right[band] = Math.max(right[band], cell - row * frame.cols());
            any = true;
        }

        /** Hands on the windows in which steps change: whole bands, because targets count crossings in bands. */
        void finish(List<Window> steps) {
            for (int band = 0; band < left.length; band++) {
                if (right[band] >= 0) {
                    int row = band * TargetBand.ROWS;
                    int rows = Math.min(TargetBand.ROWS, frame.rows() - row);
                    steps.add(new Window(left[band], row, right[band] - left[band] + 1, rows).grown(1, frame));
                }
            }
        }
    }

    /** Outdates the bands that hold rows from {@code first} to {@code last}. */
    private void outdate(int first, int last) {
        int to = Math.min(stale.length - 1, last / TargetBand.ROWS);
        for (int band = Math.max(0, first) / TargetBand.ROWS; band <= to; band++) {
            stale[band] = true;
        }
    }

    /** Returns the words after the change. */
    Words words() {
        return words;
    }

    /** Returns the crossings after the change. */
    Crossings crossings() {
        return crossings;
    }

    /** Returns how neighbours are found after the change. */
    Neighbours neighbours() {
        return neighbours;
    }

    /** Returns the bands of before, new ones where something changed in them or beside them. */
    TargetBand[] bands(TargetBand[] before) {
        TargetBand[] bands = before.clone();
        for (int band = 0; band < bands.length; band++) {
            if (stale[band]) {
                bands[band] = new TargetBand();
            }
        }
        return bands;
    }
}
