package troupe.grid.region;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import troupe.grid.GridFrame;
import troupe.grid.layer.Layers;
import troupe.grid.layer.Spans;
import troupe.scene.Actor;
import troupe.scene.Scene;

/** Compares legal steps, layers and reach of random layered scenes with what their descriptions say. */
class StepsPropertyTest {
    private static final int SCENES = 120;

    private record Step(int direction, int target) {}

    @Test
    void legalStepsAreWhatTheDescriptionSaysAndGoBothWays() {
        int elsewhere = 0;
        int crossings = 0;
        for (long seed = 5000; seed < 5000 + SCENES; seed++) {
            Region region = region(seed);
            int[] targets = new int[Region.MAX_NEIGHBOURS];
            int[] directions = new int[Region.MAX_NEIGHBOURS];
            List<List<Integer>> over = over(region);
            for (int q = 0; q < region.size(); q++) {
                List<Step> expected = new ArrayList<>();
                for (int d = 0; d < 8 && region.open(q); d++) {
                    for (int t : over.get(region.cell(q) + region.frame().offsets()[d])) {
                        if (legal(region, over, q, t, d)) {
                            expected.add(new Step(d, t));
                        }
                    }
                }
                List<Step> found = new ArrayList<>();
                int n = region.neighbours(q, targets, directions);
                for (int i = 0; i < n; i++) {
                    found.add(new Step(directions[i], targets[i]));
                    elsewhere += targets[i] < region.spanCount()
                                    && q < region.spanCount()
                                    && targets[i] / region.frame().size()
                                            != q / region.frame().size()
                            ? 1
                            : 0;
                    crossings += targets[i] >= region.spanCount() ? 1 : 0;
                }
                String place = "seed " + seed + " configuration " + q;
                assertEquals(expected, found, place);
                moves(region, q, found, place);
            }
        }
        assertTrue(elsewhere > 100 && crossings > 1000, elsewhere + " " + crossings);
    }

    private static Region region(long seed) {
        Scene scene = RandomScenes.layered(seed, 5, 0.2);
        return Region.of(scene, RandomScenes.actor(seed));
    }

    /** Returns the open configurations over each cell, ascending. */
    private static List<List<Integer>> over(Region region) {
        List<List<Integer>> over = new ArrayList<>();
        for (int cell = 0; cell < region.frame().size(); cell++) {
            over.add(new ArrayList<>());
        }
        for (int q = 0; q < region.size(); q++) {
            if (region.open(q)) {
                over.get(region.cell(q)).add(q);
            }
        }
        return over;
    }

    private static boolean joined(Region region, int a, int b) {
        boolean spanA = a < region.spanCount();
        boolean spanB = b < region.spanCount();
        if (!spanA && !spanB) {
            return region.kind(a) == region.kind(b) && region.elevation(a) == region.elevation(b);
        }
        Actor actor = region.actor();
        boolean step = Math.abs(region.elevation(a) - region.elevation(b)) <= actor.stepHeight() + 1e-9;
        if (!spanA || !spanB) {
            return step;
        }
        double ceiling = Math.min(region.spans().ceiling(a), region.spans().ceiling(b));
        double floor = Math.max(region.elevation(a), region.elevation(b));
        return step && ceiling - floor >= actor.bodyHeight() - 1e-9;
    }

    private static boolean legal(Region region, List<List<Integer>> over, int q, int t, int d) {
        if (!joined(region, q, t)) {
            return false;
        }
        if (d < 4) {
            return true;
        }
        boolean spansOnly = q < region.spanCount() && t < region.spanCount();
        int[] straight = {GridFrame.dx(d), GridFrame.dy(d) * region.frame().cols()};
        for (int offset : straight) {
            if (over.get(region.cell(q) + offset).stream()
                    .noneMatch(s ->
                            (!spansOnly || s < region.spanCount()) && joined(region, q, s) && joined(region, s, t))) {
                return false;
            }
        }
        return true;
    }

    private static void moves(Region region, int q, List<Step> found, String place) {
        int mask = 0;
        for (Step step : found) {
            if (q < region.spanCount() && step.target() == q + region.frame().offsets()[step.direction()]) {
                mask |= 1 << step.direction();
            }
        }
        assertEquals(mask, region.moves(q), place);
        if (region.plain(q)) {
            assertEquals(Integer.bitCount(mask), found.size(), place + " is not plain");
        }
    }

    @Test
    void layersCoverEverySpanOnceAndNoCellTwice() {
        for (long seed = 7000; seed < 7000 + SCENES; seed++) {
            Scene scene = RandomScenes.layered(seed, 6, 0.2);
            Actor actor = RandomScenes.actor(seed);
            RegionBuilder builder = new RegionBuilder(scene, actor);
            Layers layers = builder.layers();
            Spans spans = builder.spans();
            int cells = spans.frame().size();
            TreeSet<Long> taken = new TreeSet<>();
            int[] least = new int[layers.count()];
            java.util.Arrays.fill(least, Integer.MAX_VALUE);
            int met = 0;
            for (int cell = 0; cell < cells; cell++) {
                for (int span = cell; span < spans.size(); span += cells) {
                    assertEquals(spans.exists(span), layers.layer(span) >= 0, "seed " + seed);
                    if (!spans.exists(span)) {
                        continue;
                    }
                    int layer = layers.layer(span);
                    assertTrue(taken.add((long) layer * cells + cell), "seed " + seed + ": cell " + cell + " twice");
                    if (layer == met) {
                        met++;
                    }
                    assertTrue(layer < met, "seed " + seed + ": layers are numbered as they are first met");
                    assertTrue(spans.floor(span) >= layers.lowest(layer) && spans.floor(span) <= layers.highest(layer));
                }
            }
            assertEquals(layers.count(), met);
            assertEquals(grown(spans, actor), numbers(layers, spans), "seed " + seed);
        }
    }

    private static List<Integer> numbers(Layers layers, Spans spans) {
        List<Integer> numbers = new ArrayList<>();
        for (int span = 0; span < spans.size(); span++) {
            numbers.add(layers.layer(span));
        }
        return numbers;
    }

    /** Grows layers breadth-first, one span at a time, as the description says. */
    private static List<Integer> grown(Spans spans, Actor actor) {
        int cells = spans.frame().size();
        double body = actor.vault()
                .map(v -> Math.min(v.bodyHeight(), actor.bodyHeight()))
                .orElse(actor.bodyHeight());
        List<Integer> layer = new ArrayList<>(java.util.Collections.nCopies(spans.size(), -1));
        int count = 0;
        for (int cell = 0; cell < cells; cell++) {
            for (int seed = cell; seed < spans.size(); seed += cells) {
                if (!spans.exists(seed) || layer.get(seed) >= 0) {
                    continue;
                }
                TreeSet<Integer> taken = new TreeSet<>(List.of(cell));
                java.util.ArrayDeque<Integer> queue = new java.util.ArrayDeque<>(List.of(seed));
                layer.set(seed, count);
                while (!queue.isEmpty()) {
                    int span = queue.remove();
                    for (int d = 0; d < 4; d++) {
                        int to = span % cells + spans.frame().offsets()[d];
                        for (int next = to; next < spans.size(); next += cells) {
                            if (spans.exists(next)
                                    && layer.get(next) < 0
                                    && Math.abs(spans.floor(next) - spans.floor(span)) <= actor.stepHeight() + 1e-9
                                    && Math.min(spans.ceiling(next), spans.ceiling(span))
                                                    - Math.max(spans.floor(next), spans.floor(span))
                                            >= body - 1e-9
                                    && taken.add(to)) {
                                layer.set(next, count);
                                queue.add(next);
                            }
                        }
                    }
                }
                count++;
            }
        }
        return layer;
    }

    @Test
    void reachHoldsWhatStepsLeadToAndNothingElse() {
        for (long seed = 9000; seed < 9040; seed++) {
            Region region = region(seed);
            int start = 0;
            while (start < region.size() - 1 && !region.open(start)) {
                start++;
            }
            Reach reach = Reach.from(region, start);
            int[] targets = new int[Region.MAX_NEIGHBOURS];
            int[] directions = new int[Region.MAX_NEIGHBOURS];
            int count = 0;
            for (int q = 0; q < region.size(); q++) {
                count += reach.reached(q) ? 1 : 0;
                int n = region.neighbours(q, targets, directions);
                for (int i = 0; i < n; i++) {
                    assertEquals(reach.reached(q), reach.reached(targets[i]), "seed " + seed);
                }
            }
            assertEquals(count, reach.count());
        }
    }
}
