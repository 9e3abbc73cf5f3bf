package troupe.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import troupe.geometry.Polygon;

/** Reads and writes the numbers of scene files: decimal points in any locale, shortest form that reads back equal. */
final class Numbers {
    private Numbers() {}

    /** Returns the shortest text that reads back to the same double, without a trailing {@code .0}. */
    static String text(double value) {
        String text = Double.toString(value);
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }

    /** Returns {@code x,y} or {@code x,y,z}. */
    static String text(Place place) {
        String flat = text(place.x()) + "," + text(place.y());
        return place.z().isPresent() ? flat + "," + text(place.z().getAsDouble()) : flat;
    }

    /** Returns the corners as {@code x,y x,y …}. */
    static String text(Polygon outline) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < outline.size(); i++) {
            text.append(i == 0 ? "" : " ")
                    .append(text(outline.x(i)))
                    .append(',')
                    .append(text(outline.y(i)));
        }
        return text.toString();
    }

    /**
     * Reads a number; {@code NaN} and {@code Infinity} are read as such, for the checks to name.
     *
     * @throws IllegalArgumentException if it is none
     */
    static double number(String text) {
        try {
            return Double.parseDouble(text.strip());
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + shortened(text) + "' where a number is expected", e);
        }
    }

    /**
     * Reads a whole number.
     *
     * @throws IllegalArgumentException if it is none
     */
    static long whole(String text) {
        try {
            return Long.parseLong(text.strip());
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("'" + shortened(text) + "' where a whole number is expected", e);
        }
    }

    /**
     * Reads {@code x,y} or {@code x,y,z}.
     *
     * @throws IllegalArgumentException if it is neither
     */
    static Place place(String text) {
        String[] parts = text.strip().split(",", -1);
        if (parts.length != 2 && parts.length != 3) {
            throw new IllegalArgumentException("'" + shortened(text) + "' where x,y or x,y,z is expected");
        }
        OptionalDouble z = parts.length == 3 ? OptionalDouble.of(number(parts[2])) : OptionalDouble.empty();
        return new Place(number(parts[0]), number(parts[1]), z);
    }

    /**
     * Reads corners written as {@code x,y x,y …}, any white space between them.
     *
     * @throws IllegalArgumentException if a corner is not {@code x,y} or there is none
     */
    static Polygon polygon(String text) {
        List<double[]> corners = new ArrayList<>();
        for (String corner : text.strip().split("\\s+")) {
            String[] parts = corner.split(",", -1);
            if (parts.length != 2) {
                throw new IllegalArgumentException("corner '" + shortened(corner) + "' where x,y is expected");
            }
            double[] read = {number(parts[0]), number(parts[1])};
            if (!Double.isFinite(read[0]) || !Double.isFinite(read[1])) {
                throw new IllegalArgumentException(
                        "corner '" + shortened(corner) + "' where finite numbers are expected");
            }
            corners.add(read);
        }
        return new Polygon(
                corners.stream().mapToDouble(c -> c[0]).toArray(),
                corners.stream().mapToDouble(c -> c[1]).toArray());
    }

    private static String shortened(String text) {
        String line = text.replaceAll("\\s+", " ");
        return line.length() <= 40 ? line : line.substring(0, 40) + "…";
    }
}
