package troupe.unified;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.grid.GridFrame;
import troupe.grid.layer.Layers;
import troupe.grid.region.Region;
import troupe.run.view.Overlay;
import troupe.unified.search.JourneySearch;
import troupe.unified.search.SearchSpace;

/** Shows where a search has worked: how many labels of a search space it has made over each cell of
 * each layer. */
final class SearchEffort {
    private SearchEffort() {}

    /**
     * Returns one field for each layer, key {@code effort}, in labels; NaN where there is none. A crossing
     * counts in the layer that it is entered from. Cost O(cells of all layers + labels).
     */
    static List<Overlay> of(Layers layers, JourneySearch search, SearchSpace space) {
        Region region = space.region();
        float[][] labels = new float[layers.count()][region.frame().size()];
        for (float[] field : labels) {
            Arrays.fill(field, Float.NaN);
        }
        float[] most = {1};
        search.forEachLabel(space, q -> {
            float[] field = labels[layer(region, layers, q)];
            int cell = region.cell(q);
            field[cell] = Float.isNaN(field[cell]) ? 1 : field[cell] + 1;
            most[0] = Math.max(most[0], field[cell]);
        });
        List<Overlay> views = new ArrayList<>();
        for (int k = 0; k < labels.length; k++) {
            Overlay.Scale scale = new Overlay.Continuous("labels", 0, most[0], 0);
            views.add(new Overlay.Field("effort", k, region.frame(), labels[k], scale));
        }
        return views;
    }

    /** Returns the layer of a span or, for a crossing, that of the nearest span in a row or column on its take-off floor. */
    private static int layer(Region region, Layers layers, int q) {
        if (q < region.spanCount()) {
            return layers.layer(q);
        }
        GridFrame frame = region.frame();
        int col = frame.col(region.cell(q));
        int row = frame.row(region.cell(q));
        for (int away = 1; away < Math.max(frame.cols(), frame.rows()); away++) {
            for (int d = 0; d < 4; d++) {
                int span =
                        span(region, col + away * GridFrame.dx(d), row + away * GridFrame.dy(d), region.elevation(q));
                if (span >= 0) {
                    return layers.layer(span);
                }
            }
        }
        return 0;
    }

    private static int span(Region region, int col, int row, double floor) {
        GridFrame frame = region.frame();
        if (col < 0 || row < 0 || col >= frame.cols() || row >= frame.rows()) {
            return -1;
        }
        for (int q = frame.index(col, row); q < region.spanCount(); q += frame.size()) {
            if (region.spans().exists(q) && region.elevation(q) == floor) {
                return q;
            }
        }
        return -1;
    }
}
