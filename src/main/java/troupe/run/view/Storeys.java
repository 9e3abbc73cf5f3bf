package troupe.run.view;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import troupe.grid.layer.Layers;
import troupe.grid.region.Region;

/**
 * Gathers layers that do not lie over each other into storeys, so that a scene of many small layers (the tops
 * of walls and tables) is shown in few pictures. The layer with the lowest floor comes first; each joins the
 * lowest storey that has room for it. Immutable.
 */
final class Storeys {
    private final int[] storeyOf;
    private final int count;

    /** Gathers the layers of a region. Cost O(spans + layers x cells / 64). */
    Storeys(Region region, Layers layers) {
        storeyOf = new int[layers.count()];
        int[][] cells = cellsOf(region, layers);
        List<BitSet> taken = new ArrayList<>();
        int[] order = IntStream.range(0, storeyOf.length)
                .boxed()
                .sorted(Comparator.comparingDouble((Integer k) -> layers.lowest(k))
                        .thenComparing(k -> k))
                .mapToInt(k -> k)
                .toArray();
        for (int k : order) {
            int storey = 0;
            while (storey < taken.size() && meets(taken.get(storey), cells[k])) {
                storey++;
            }
            if (storey == taken.size()) {
                taken.add(new BitSet(region.frame().size()));
            }
            Arrays.stream(cells[k]).forEach(taken.get(storey)::set);
            storeyOf[k] = storey;
        }
        count = taken.size();
    }

    private static int[][] cellsOf(Region region, Layers layers) {
        int[] sizes = new int[layers.count()];
        for (int q = 0; q < region.spanCount(); q++) {
            if (layers.layer(q) >= 0) {
                sizes[layers.layer(q)]++;
            }
        }
        int[][] cells = new int[sizes.length][];
        Arrays.setAll(cells, k -> new int[sizes[k]]);
        for (int q = region.spanCount() - 1; q >= 0; q--) {
            int k = layers.layer(q);
            if (k >= 0) {
                cells[k][--sizes[k]] = region.cell(q);
            }
        }
        return cells;
    }

    private static boolean meets(BitSet taken, int[] cells) {
        return Arrays.stream(cells).anyMatch(taken::get);
    }

    /** Returns the number of storeys. */
    int count() {
        return count;
    }

    /** Returns the storey of a layer, 0 the lowest. */
    int of(int layer) {
        return storeyOf[layer];
    }
}
