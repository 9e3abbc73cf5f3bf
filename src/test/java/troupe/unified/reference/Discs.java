package troupe.unified.reference;

import java.util.ArrayList;
import java.util.List;

/** Opens and closes masks by a disc, cell by cell, and lists the cells within a distance or along a line. */
final class Discs {
    private Discs() {}

    /** Closes a mask by a disc of a radius in metres; what lies outside the frame is not in the mask. */
    static boolean[] closed(Ground ground, boolean[] mask, double radius) {
        Plane plane = new Plane(ground, radius);
        return plane.cut(plane.eroded(plane.dilated(plane.wide(mask, false))));
    }

    /** Opens a mask by a disc of a radius in metres; what lies outside the frame is in the mask. */
    static boolean[] opened(Ground ground, boolean[] mask, double radius) {
        Plane plane = new Plane(ground, radius);
        return plane.cut(plane.dilated(plane.eroded(plane.wide(mask, true))));
    }

    /** A plane that goes on around the frame, and a disc. */
    private record Plane(Ground ground, int reach, double squared, int cols, int rows) {
        Plane(Ground ground, double radius) {
            this(
                    ground,
                    (int) (radius / ground.cell) + 1,
                    radius / ground.cell * (radius / ground.cell) + 1e-6,
                    ground.cols + 4 * ((int) (radius / ground.cell) + 1),
                    ground.cells / ground.cols + 4 * ((int) (radius / ground.cell) + 1));
        }

        boolean[] wide(boolean[] mask, boolean around) {
            boolean[] wide = new boolean[cols * rows];
            java.util.Arrays.fill(wide, around);
            for (int at = 0; at < mask.length; at++) {
                wide[index(at)] = mask[at];
            }
            return wide;
        }

        private int index(int at) {
            return (at / ground.cols + 2 * reach) * cols + at % ground.cols + 2 * reach;
        }

        boolean[] cut(boolean[] wide) {
            boolean[] mask = new boolean[ground.cells];
            for (int at = 0; at < mask.length; at++) {
                mask[at] = wide[index(at)];
            }
            return mask;
        }

        boolean[] dilated(boolean[] mask) {
            return swept(mask, true);
        }

        boolean[] eroded(boolean[] mask) {
            return swept(mask, false);
        }

        /** Gives the value to each cell that has a cell of that value within the disc; the rim stays as it is. */
        private boolean[] swept(boolean[] mask, boolean value) {
            boolean[] swept = mask.clone();
            for (int at = 0; at < mask.length; at++) {
                int row = at / cols;
                int col = at % cols;
                if (mask[at] != value) {
                    continue;
                }
                for (int y = Math.max(row - reach, reach); y <= Math.min(row + reach, rows - reach - 1); y++) {
                    for (int x = Math.max(col - reach, reach); x <= Math.min(col + reach, cols - reach - 1); x++) {
                        if ((y - row) * (y - row) + (x - col) * (x - col) <= squared) {
                            swept[y * cols + x] = value;
                        }
                    }
                }
            }
            return swept;
        }
    }

    /** Returns the column and row steps to the cells whose centre is no further than a distance in metres. */
    static List<int[]> within(Ground ground, double metres) {
        int reach = (int) (metres / ground.cell) + 1;
        List<int[]> steps = new ArrayList<>();
        for (int dy = -reach; dy <= reach; dy++) {
            for (int dx = -reach; dx <= reach; dx++) {
                if (Math.sqrt(dx * dx + dy * dy) * ground.cell <= metres + Ground.SAME) {
                    steps.add(new int[] {dx, dy});
                }
            }
        }
        return steps;
    }

    /** Returns the steps to the cells, ends excepted, whose inside the segment to a centre so far away runs through. */
    static List<int[]> between(int dx, int dy) {
        List<int[]> steps = new ArrayList<>();
        for (int y = Math.min(0, dy); y <= Math.max(0, dy); y++) {
            for (int x = Math.min(0, dx); x <= Math.max(0, dx); x++) {
                boolean end = x == 0 && y == 0 || x == dx && y == dy;
                if (!end && Shapes.touches(new double[] {0, 0, dx, dy}, x, y, 0.5)) {
                    steps.add(new int[] {x, y});
                }
            }
        }
        return steps;
    }
}
