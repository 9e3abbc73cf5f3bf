package troupe.run.view;

import java.util.List;
import troupe.grid.GridFrame;

/** A view to lay over the scene: a field, points or lines, with its unit and what its legend needs. Immutable by contract. */
public sealed interface Overlay {

    /** Returns the key of this kind of view: {@code clearance}, {@code skeleton}, … */
    String key();

    /** Returns the layer it belongs to, 0 the lowest. */
    int layer();

    /** How the values of a field are to be read. */
    sealed interface Scale {}

    /** Values between {@code min} and {@code max} in {@code unit}, shown by a colour map; contour lines each {@code contour} (0: none). */
    record Continuous(String unit, double min, double max, double contour) implements Scale {}

    /** Values are the indices of {@code words}. */
    record Categories(List<String> words) implements Scale {}

    /** A value for each cell of a frame, row-major; NaN where there is none. The array must not be changed. */
    record Field(String key, int layer, GridFrame frame, float[] values, Scale scale) implements Overlay {}

    /** Points in metres, {@code x0, y0, x1, y1, …}. The array must not be changed. */
    record Points(String key, int layer, double[] coordinates) implements Overlay {}

    /** Polylines in metres, each {@code x0, y0, x1, y1, …}. The arrays must not be changed. */
    record Lines(String key, int layer, List<double[]> lines) implements Overlay {}
}
