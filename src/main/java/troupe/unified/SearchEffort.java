package troupe.unified;

import java.util.Arrays;
import java.util.List;
import troupe.grid.Region;
import troupe.run.Overlay;

/** Shows where a search has worked: how many labels each cell got, all configurations over it together. */
final class SearchEffort {
    private SearchEffort() {}

    /** Returns one field, key {@code effort}, in labels; NaN where there is none. Cost O(cells + labels). */
    static List<Overlay> of(Region region, JourneySearch search) {
        float[] labels = new float[region.frame().size()];
        Arrays.fill(labels, Float.NaN);
        search.forEachLabel(q -> {
            int cell = region.cell(q);
            labels[cell] = Float.isNaN(labels[cell]) ? 1 : labels[cell] + 1;
        });
        float most = 1;
        for (float count : labels) {
            most = count > most ? count : most;
        }
        return List.of(
                new Overlay.Field("effort", 0, region.frame(), labels, new Overlay.Continuous("labels", 0, most, 0)));
    }
}
