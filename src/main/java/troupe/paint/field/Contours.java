package troupe.paint.field;

import java.awt.geom.Path2D;
import java.util.Arrays;
import troupe.grid.GridFrame;
import troupe.run.view.Overlay;

/**
 * Traces lines of equal value through a field, by linear interpolation between the centres of cells
 * (marching squares; where a square is a saddle its middle decides). A square with a corner that has no
 * value holds no line. Fields of more than a million cells are thinned first. Cost O(cells) for each level.
 */
final class Contours {
    private static final int MAX_LEVELS = 200;
    private static final int NONE = -1;
    private static final int MAX_CELLS = 1 << 20;

    private final GridFrame frame;
    private final float[] values;
    private final int[] first;
    private final int[] second;
    private final int[] touched;
    private int count;

    /** Makes a tracer of a field; it holds scratch arrays and serves one thread. */
    Contours(Overlay.Field field) {
        Overlay.Field traced = thinned(field);
        frame = traced.frame();
        values = traced.values();
        first = new int[2 * frame.size()];
        second = new int[2 * frame.size()];
        touched = new int[2 * frame.size()];
        Arrays.fill(first, NONE);
        Arrays.fill(second, NONE);
    }

    /** Takes one cell of each square of cells, so that at most a million are left. */
    private static Overlay.Field thinned(Overlay.Field field) {
        GridFrame frame = field.frame();
        int every = (int) Math.ceil(Math.sqrt((double) frame.size() / MAX_CELLS));
        if (every <= 1) {
            return field;
        }
        int cols = (frame.cols() + every - 1) / every;
        int rows = (frame.rows() + every - 1) / every;
        // the sample lies in the first cell of its square, so the coarse frame begins half a square before
        double shift = (every - 1) / 2.0 * frame.cell();
        GridFrame coarse =
                new GridFrame(frame.originX() - shift, frame.originY() - shift, every * frame.cell(), cols, rows);
        float[] values = new float[coarse.size()];
        for (int i = 0; i < values.length; i++) {
            values[i] = field.values()[frame.index(coarse.col(i) * every, coarse.row(i) * every)];
        }
        return new Overlay.Field(field.key(), field.layer(), coarse, values, field.scale());
    }

    /** Returns the lines at {@code min + step, min + 2 step, …} below {@code max}, in metres; at most 200 levels. */
    Path2D lines(double min, double max, double step) {
        Path2D path = new Path2D.Double();
        for (int k = 1; k <= MAX_LEVELS && min + k * step < max; k++) {
            trace(min + k * step, path);
        }
        return path;
    }

    /** Adds the lines of one level to the path. */
    void trace(double level, Path2D path) {
        count = 0;
        for (int row = 0; row + 1 < frame.rows(); row++) {
            for (int col = 0; col + 1 < frame.cols(); col++) {
                square(frame.index(col, row), level);
            }
        }
        for (int k = 0; k < count; k++) {
            if (first[touched[k]] == NONE != (second[touched[k]] == NONE)) {
                follow(touched[k], level, path);
            }
        }
        for (int k = 0; k < count; k++) {
            if (first[touched[k]] != NONE) {
                follow(touched[k], level, path);
            }
        }
    }

    /** Links the crossed edges of the square whose lower left corner is cell {@code i}. */
    private void square(int i, double level) {
        int up = i + frame.cols();
        float a = values[i];
        float b = values[i + 1];
        float c = values[up + 1];
        float d = values[up];
        float sum = a + b + c + d;
        if (!(sum - sum == 0)) {
            return;
        }
        int code = (a >= level ? 1 : 0) | (b >= level ? 2 : 0) | (c >= level ? 4 : 0) | (d >= level ? 8 : 0);
        int south = 2 * i;
        int west = 2 * i + 1;
        int east = 2 * (i + 1) + 1;
        int north = 2 * up;
        boolean middle = sum / 4 >= level;
        switch (code) {
            case 1, 14 -> link(south, west);
            case 2, 13 -> link(south, east);
            case 3, 12 -> link(west, east);
            case 4, 11 -> link(east, north);
            case 6, 9 -> link(south, north);
            case 7, 8 -> link(west, north);
            case 5 -> saddle(middle, south, east, north, west);
            case 10 -> saddle(!middle, south, east, north, west);
            default -> {}
        }
    }

    private void saddle(boolean joined, int south, int east, int north, int west) {
        link(south, joined ? east : west);
        link(north, joined ? west : east);
    }

    private void link(int a, int b) {
        join(a, b);
        join(b, a);
    }

    private void join(int edge, int other) {
        if (first[edge] == NONE) {
            if (second[edge] == NONE) {
                touched[count++] = edge;
            }
            first[edge] = other;
        } else {
            second[edge] = other;
        }
    }

    private void follow(int start, double level, Path2D path) {
        int edge = start;
        path.moveTo(x(edge, level), y(edge, level));
        while (true) {
            int next = first[edge] != NONE ? first[edge] : second[edge];
            if (next == NONE) {
                return;
            }
            forget(edge, next);
            forget(next, edge);
            if (next == start) {
                path.closePath();
                return;
            }
            path.lineTo(x(next, level), y(next, level));
            edge = next;
        }
    }

    private void forget(int edge, int other) {
        if (first[edge] == other) {
            first[edge] = NONE;
        } else {
            second[edge] = NONE;
        }
    }

    /** Edges have even numbers if they run east from cell {@code edge / 2}, odd ones if they run north. */
    private double x(int edge, double level) {
        int i = edge >> 1;
        double x = frame.centreX(frame.col(i));
        return (edge & 1) == 0 ? x + frame.cell() * share(values[i], values[i + 1], level) : x;
    }

    private double y(int edge, double level) {
        int i = edge >> 1;
        double y = frame.centreY(frame.row(i));
        return (edge & 1) == 1 ? y + frame.cell() * share(values[i], values[i + frame.cols()], level) : y;
    }

    private static double share(float from, float to, double level) {
        return (level - from) / (to - from);
    }
}
