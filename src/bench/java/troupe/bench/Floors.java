package troupe.bench;

import java.util.Arrays;
import troupe.geometry.Polygon;
import troupe.scene.Scene;

/**
 * Holds plain-array versions of what the grid core is made of, as fast as they come in simple Java, to
 * measure against. They know one floor, no classes and no exact radii.
 */
final class Floors {
    private static final int FAR = 1 << 28;

    private final int size;
    private final double cell;
    private final Polygon[] outlines;
    private final byte[] solid;
    private final byte[] filled;
    private final byte[] opened;
    private final int[] distance;
    private final int[] origin;
    private final int[] wave;
    private final int[] queue;
    private final int[] apex;
    private final int[] height;
    private final double[] crossing = new double[64];

    Floors(int size, Scene scene) {
        this.size = size;
        this.cell = scene.world().cell();
        this.outlines = scene.obstacles().stream().map(o -> o.outline()).toArray(Polygon[]::new);
        int cells = size * size;
        this.filled = new byte[cells];
        this.opened = new byte[cells];
        this.distance = new int[cells];
        this.origin = new int[cells];
        this.wave = new int[cells];
        this.queue = new int[cells];
        this.apex = new int[size];
        this.height = new int[size];
        this.solid = fillPolygons().clone();
    }

    byte[] solid() {
        return solid;
    }

    int[] copy() {
        System.arraycopy(distance, 0, wave, 0, wave.length);
        return wave;
    }

    /** Fills the outlines by scanlines through cell centres; the outermost ring is solid. */
    byte[] fillPolygons() {
        Arrays.fill(filled, (byte) 0);
        for (Polygon outline : outlines) {
            int from = Math.max(0, (int) Math.ceil(outline.bounds().minY() / cell - 0.5));
            int to = Math.min(size - 1, (int) Math.floor(outline.bounds().maxY() / cell - 0.5));
            for (int row = from; row <= to; row++) {
                fillRow(outline, row);
            }
        }
        for (int i = 0; i < size; i++) {
            filled[i] = filled[(size - 1) * size + i] = filled[i * size] = filled[i * size + size - 1] = 1;
        }
        return filled;
    }

    private void fillRow(Polygon outline, int row) {
        double y = (row + 0.5) * cell;
        int count = 0;
        int corners = outline.size();
        for (int k = 0, last = corners - 1; k < corners; last = k++) {
            double y0 = outline.y(last);
            double y1 = outline.y(k);
            if (y0 <= y != y1 <= y) {
                crossing[count++] = outline.x(last) + (y - y0) / (y1 - y0) * (outline.x(k) - outline.x(last));
            }
        }
        Arrays.sort(crossing, 0, count);
        for (int k = 0; k + 1 < count; k += 2) {
            int from = Math.max(0, (int) Math.ceil(crossing[k] / cell - 0.5));
            int to = Math.min(size, (int) Math.ceil(crossing[k + 1] / cell - 0.5));
            if (from < to) {
                Arrays.fill(filled, row * size + from, row * size + to, (byte) 1);
            }
        }
    }

    int[] breadthFirst() {
        Arrays.fill(wave, -1);
        int start = firstOpen();
        wave[start] = 0;
        queue[0] = start;
        spread(1);
        return wave;
    }

    private int firstOpen() {
        int start = size * size / 2 + size / 2;
        while (solid[start] != 0) {
            start++;
        }
        return start;
    }

    private void spread(int tail) {
        int end = tail;
        for (int head = 0; head < end; head++) {
            int q = queue[head];
            int next = wave[q] + 1;
            end = visit(q + 1, next, end);
            end = visit(q + size, next, end);
            end = visit(q - 1, next, end);
            end = visit(q - size, next, end);
        }
    }

    private int visit(int q, int next, int tail) {
        if (solid[q] != 0 || wave[q] >= 0) {
            return tail;
        }
        wave[q] = next;
        queue[tail] = q;
        return tail + 1;
    }

    /** Squares of the exact distances to the nearest cell that is set (Meijster's two passes). */
    int[] distances(byte[] set) {
        for (int i = 0; i < set.length; i++) {
            distance[i] = set[i] != 0 ? 0 : i < size ? size * 2 : Math.min(size * 2, distance[i - size] + 1);
        }
        for (int i = set.length - size - 1; i >= 0; i--) {
            distance[i] = Math.min(distance[i], distance[i + size] + 1);
        }
        for (int row = 0; row < size; row++) {
            envelope(row * size);
        }
        return distance;
    }

    private void envelope(int base) {
        int top = -1;
        for (int col = 0; col < size; col++) {
            int h = distance[base + col] * distance[base + col];
            while (top > 0 && hidden(apex[top - 1], height[top - 1], apex[top], height[top], col, h)) {
                top--;
            }
            apex[++top] = col;
            height[top] = h;
        }
        int k = 0;
        for (int col = 0; col < size; col++) {
            int best = (col - apex[k]) * (col - apex[k]) + height[k];
            while (k < top && (col - apex[k + 1]) * (col - apex[k + 1]) + height[k + 1] <= best) {
                k++;
                best = (col - apex[k]) * (col - apex[k]) + height[k];
            }
            distance[base + col] = best;
        }
    }

    private static boolean hidden(int a, long ha, int b, long hb, int c, long hc) {
        return (c - a) * hb - (c - b) * ha - (b - a) * hc - (long) (b - a) * (c - b) * (c - a) > 0;
    }

    byte[] open(double radius) {
        int limit = (int) (radius * radius);
        int[] first = distances(solid);
        for (int i = 0; i < first.length; i++) {
            opened[i] = (byte) (first[i] > limit ? 1 : 0);
        }
        int[] second = distances(opened);
        for (int i = 0; i < second.length; i++) {
            opened[i] = (byte) (second[i] <= limit ? 1 : 0);
        }
        return opened;
    }

    /**
     * Grows a breadth-first wave from the solids with origins, marks the ridge where origins part, joins it by
     * climbing from the goal, and spreads the potential along it and then to the rest.
     */
    int[] skeletonAndPotential() {
        growOrigins();
        Arrays.fill(wave, -1);
        markRidge();
        int tail = spreadOnRidge(climb());
        for (int i = 0; i < wave.length; i++) {
            if (wave[i] < -1) {
                wave[i] = -1;
            }
        }
        spread(tail);
        return wave;
    }

    private void growOrigins() {
        int tail = 0;
        for (int i = 0; i < solid.length; i++) {
            boolean wall = solid[i] != 0;
            distance[i] = wall ? 0 : FAR;
            origin[i] = i;
            if (wall) {
                queue[tail++] = i;
            }
        }
        for (int head = 0; head < tail; head++) {
            int q = queue[head];
            int next = distance[q] + 1;
            int col = q % size;
            tail = col < size - 1 ? grow(q, q + 1, next, tail) : tail;
            tail = q + size < solid.length ? grow(q, q + size, next, tail) : tail;
            tail = col > 0 ? grow(q, q - 1, next, tail) : tail;
            tail = q >= size ? grow(q, q - size, next, tail) : tail;
        }
    }

    private int grow(int from, int q, int next, int tail) {
        if (distance[q] <= next) {
            return tail;
        }
        distance[q] = next;
        origin[q] = origin[from];
        queue[tail] = q;
        return tail + 1;
    }

    /** Marks ridge cells with wave -2. */
    private void markRidge() {
        for (int q = 0; q < solid.length - size; q++) {
            if (solid[q] == 0 && (apart(q, q + 1) || apart(q, q + size))) {
                wave[q] = -2;
            }
        }
    }

    private boolean apart(int a, int b) {
        int p = origin[a];
        int q = origin[b];
        int cols = Math.abs(p % size - q % size);
        int rows = Math.abs(p / size - q / size);
        return cols + rows > 2;
    }

    private int climb() {
        int q = firstOpen();
        int goal = q;
        while (wave[q] != -2) {
            wave[q] = -2;
            int best = q;
            best = distance[q + 1] > distance[best] ? q + 1 : best;
            best = distance[q - 1] > distance[best] ? q - 1 : best;
            best = distance[q + size] > distance[best] ? q + size : best;
            best = distance[q - size] > distance[best] ? q - size : best;
            if (best == q) {
                break;
            }
            q = best;
        }
        return goal;
    }

    private int spreadOnRidge(int goal) {
        wave[goal] = 0;
        queue[0] = goal;
        int tail = 1;
        for (int head = 0; head < tail; head++) {
            int q = queue[head];
            for (int dy = -size; dy <= size; dy += size) {
                for (int dx = -1; dx <= 1; dx++) {
                    if (wave[q + dy + dx] == -2) {
                        wave[q + dy + dx] = wave[q] + 1;
                        queue[tail++] = q + dy + dx;
                    }
                }
            }
        }
        return tail;
    }
}
