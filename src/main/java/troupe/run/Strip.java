package troupe.run;

import java.util.List;

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
}
