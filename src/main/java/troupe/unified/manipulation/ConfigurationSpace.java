package troupe.unified.manipulation;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicReferenceArray;
import troupe.grid.GridFrame;
import troupe.unified.obstacle.Bits;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;

/**
 * Knows the poses of an obstacle in which it bars an expected path: S of Unified section 6.3. A heading is
 * stamped along the path when it is first asked for, each row of poses only as far as the path reaches;
 * from then on a question costs O(1). May be shared by all instances with the same path; safe for any thread.
 */
public final class ConfigurationSpace {
    private final Movable movable;
    private final ExpectedPath path;
    private final GridFrame frame;
    private final int homeCol;
    private final int homeRow;
    private final double[] radii;
    private final int[][] places;
    private final AtomicReferenceArray<Heading> headings;

    /** The barred poses of one heading, as rows of bits; {@code from} the first word of each row, {@code at} where it lies. */
    private record Heading(int[] from, int[] at, long[] bits) {
        boolean get(int col, int row) {
            int word = (col >> 6) - from[row];
            return word >= 0 && word < at[row + 1] - at[row] && (bits[at[row] + word] >>> col & 1) != 0;
        }
    }

    /** Makes the space of an obstacle and a path; nothing is stamped yet. */
    public ConfigurationSpace(Movable movable, ExpectedPath path) {
        this.movable = movable;
        this.path = path;
        this.frame = path.frame();
        this.homeCol = frame.colAt(movable.centroid().x());
        this.homeRow = frame.rowAt(movable.centroid().y());
        this.headings = new AtomicReferenceArray<>(movable.headings());
        int[] met = new int[path.size()];
        int count = 0;
        for (int n = 0; n < path.size(); n++) {
            if (path.meets(n, movable)) {
                met[count++] = n;
            }
        }
        int[] meeting = Arrays.copyOf(met, count);
        this.radii = Arrays.stream(meeting).mapToDouble(path::radius).distinct().toArray();
        this.places = new int[radii.length][];
        for (int r = 0; r < radii.length; r++) {
            double radius = radii[r];
            places[r] =
                    Arrays.stream(meeting).filter(n -> path.radius(n) == radius).toArray();
        }
    }

    /** Returns the expected path. */
    public ExpectedPath path() {
        return path;
    }

    /** Returns the obstacle. */
    public Movable movable() {
        return movable;
    }

    /** Tells whether the obstacle at the pose {@code (i, j, k)} collides with the path, {@code 0 <= k < headings}. */
    public boolean contains(int i, int j, int k) {
        int col = homeCol + i;
        int row = homeRow + j;
        if (col < 0 || row < 0 || col >= frame.cols() || row >= frame.rows()) {
            return path.collides(movable, new LatticePose(i, j, k));
        }
        return heading(k).get(col, row);
    }

    /** Returns the greatest radius in metres of a place of the path that the obstacle can bar, 0 if there is none. */
    double widest() {
        return Arrays.stream(radii).max().orElse(0);
    }

    /**
     * Marks in a square of poses, {@code half} to each side, those of a heading that are barred and keep the centroid over
     * the frame.
     *
     * @param square row by row; what is marked becomes {@link Prices#BLOCKED}
     */
    void mark(int k, int half, long[] square) {
        Heading heading = heading(k);
        for (int j = lowest(half); j <= highest(half); j++) {
            int at = (j + half) * (2 * half + 1) + half;
            for (int i = leftmost(half); i <= rightmost(half); i++) {
                if (heading.get(homeCol + i, homeRow + j)) {
                    square[at + i] = Prices.BLOCKED;
                }
            }
        }
    }

    /**
     * Marks in a square of poses, {@code half} to each side, those at which a disc about the centroid collides with the
     * path and which keep the centroid over the frame: whatever the heading, an obstacle that holds the disc does, too.
     *
     * @param radius of the disc in metres; nothing is marked unless above 0
     * @param square row by row; what is marked becomes {@link Prices#BLOCKED}
     */
    void markDisc(double radius, int half, long[] square) {
        for (int r = 0; r < radii.length && radius > 0; r++) {
            double reach = (radius + radii[r]) / frame.cell();
            for (int n : places[r]) {
                int cell = path.cell(n);
                double x = (frame.centreX(frame.col(cell)) - movable.centroid().x()) / frame.cell();
                double y = (frame.centreY(frame.row(cell)) - movable.centroid().y()) / frame.cell();
                int low = Math.max(lowest(half), (int) Math.ceil(y - reach));
                int high = Math.min(highest(half), (int) Math.floor(y + reach));
                for (int j = low; j <= high; j++) {
                    double across = Math.sqrt(Math.max(0, reach * reach - (y - j) * (y - j)));
                    int left = Math.max(leftmost(half), (int) Math.ceil(x - across));
                    int right = Math.min(rightmost(half), (int) Math.floor(x + across));
                    int at = (j + half) * (2 * half + 1) + half;
                    for (int i = left; i <= right; i++) {
                        square[at + i] = Prices.BLOCKED;
                    }
                }
            }
        }
    }

    private int lowest(int half) {
        return Math.max(-half, -homeRow);
    }

    private int highest(int half) {
        return Math.min(half, frame.rows() - 1 - homeRow);
    }

    private int leftmost(int half) {
        return Math.max(-half, -homeCol);
    }

    private int rightmost(int half) {
        return Math.min(half, frame.cols() - 1 - homeCol);
    }

    /**
     * Returns the barred poses of a heading that keep the centroid over the frame, as the cells that hold the
     * centroid, ascending; for showing. Cost O(rows and poses).
     */
    public int[] poses(int k) {
        Heading heading = heading(k);
        int[] found = new int[64];
        int count = 0;
        for (int row = 0; row < frame.rows(); row++) {
            for (int w = heading.at[row]; w < heading.at[row + 1]; w++) {
                int base = (heading.from[row] + w - heading.at[row]) * Long.SIZE;
                for (long rest = heading.bits[w]; rest != 0; rest &= rest - 1) {
                    if (count == found.length) {
                        found = Arrays.copyOf(found, 2 * count);
                    }
                    found[count++] = frame.index(base + Long.numberOfTrailingZeros(rest), row);
                }
            }
        }
        return Arrays.copyOf(found, count);
    }

    private Heading heading(int k) {
        Heading known = headings.get(k);
        if (known == null) {
            known = new Stamping(k).heading();
            headings.set(k, known);
        }
        return known;
    }

    /** Stamps one heading along the path: once to find how far each row reaches, once to set the bits. */
    private final class Stamping {
        private final int[] low = new int[frame.rows()];
        private final int[] high = new int[frame.rows()];
        private final int[] from = new int[frame.rows()];
        private final int[] at = new int[frame.rows() + 1];
        private long[] bits;

        Stamping(int k) {
            Arrays.fill(low, frame.cols());
            pass(k);
            for (int row = 0; row < frame.rows(); row++) {
                from[row] = low[row] >> 6;
                at[row + 1] = at[row] + (low[row] < high[row] ? (high[row] - 1 >> 6) - from[row] + 1 : 0);
            }
            bits = new long[at[frame.rows()]];
            pass(k);
        }

        Heading heading() {
            return new Heading(from, at, bits);
        }

        private void pass(int k) {
            for (int r = 0; r < radii.length; r++) {
                int[] runs = movable.stamp(k, radii[r]).runs();
                int[] along = places[r];
                for (int n = 0; n < along.length; n++) {
                    int first = path.cell(along[n]);
                    int last = first;
                    while (n + 1 < along.length && goesOn(first, last, path.cell(along[n + 1]))) {
                        last = path.cell(along[++n]);
                    }
                    stamp(runs, Math.min(first, last), Math.max(first, last));
                }
            }
        }

        /** Tells whether a cell lies next to the last of a straight run within a row, on the far side of the first. */
        private boolean goesOn(int first, int last, int next) {
            return Math.abs(next - last) == 1
                    && (first == last || next > last == last > first)
                    && frame.row(next) == frame.row(last);
        }

        /** Sets, or only measures, the poses that bring the stamp over one of the cells of a row. */
        private void stamp(int[] runs, int firstCell, int lastCell) {
            int row = homeRow + frame.row(firstCell);
            int left = homeCol + frame.col(firstCell) + 1;
            int right = homeCol + frame.col(lastCell) + 1;
            for (int run = 0; run < runs.length; run += 3) {
                int r = row - runs[run];
                int a = Math.max(0, left - runs[run + 2]);
                int b = Math.min(frame.cols(), right - runs[run + 1]);
                if (r < 0 || r >= frame.rows() || a >= b) {
                    continue;
                }
                if (bits == null) {
                    low[r] = Math.min(low[r], a);
                    high[r] = Math.max(high[r], b);
                } else {
                    Bits.set(bits, at[r] - from[r], a, b);
                }
            }
        }
    }
}
