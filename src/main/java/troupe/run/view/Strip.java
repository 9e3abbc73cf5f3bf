package troupe.run.view;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Holds values over time, a row for each of several things: a plot whose colour is the value.
 *
 * @param key what the values are
 * @param step seconds between two values of a row
 * @param names the name of each row
 * @param rows the values, in [0, 1] or NaN where there is none; the arrays must not be changed
 */
public record Strip(String key, double step, List<String> names, List<double[]> rows) {

    /** Copies the lists and checks that each row has a name. */
    public Strip {
        names = List.copyOf(names);
        rows = List.copyOf(rows);
        if (names.size() != rows.size()) {
            throw new IllegalArgumentException(rows.size() + " rows with " + names.size() + " names");
        }
    }

    /** Returns the greatest value of a row, 0 if it has none. */
    public double most(int row) {
        return Arrays.stream(rows.get(row))
                .filter(value -> !Double.isNaN(value))
                .max()
                .orElse(0);
    }

    /** Returns the {@code count} rows of the greatest values, fewer if there are not so many, in the order they had. */
    public Strip greatest(int count) {
        int[] kept = IntStream.range(0, rows.size())
                .boxed()
                .sorted(Comparator.comparingDouble(row -> -most(row)))
                .limit(count)
                .mapToInt(Integer::intValue)
                .sorted()
                .toArray();
        List<String> keptNames = new ArrayList<>();
        List<double[]> keptRows = new ArrayList<>();
        for (int row : kept) {
            keptNames.add(names.get(row));
            keptRows.add(rows.get(row));
        }
        return new Strip(key, step, keptNames, keptRows);
    }
}
