package troupe.grid.field;

import troupe.grid.GridFrame;
import troupe.grid.region.StepRelation;

/** Makes the legal steps of a flat mask: open where it is set, a diagonal needs both its straight neighbours. */
final class MaskSteps implements StepRelation {
    private final GridFrame frame;
    private final byte[] moves;
    private final boolean[] open;

    MaskSteps(boolean[] mask, int cols, double cell) {
        this.frame = new GridFrame(0, 0, cell, cols, mask.length / cols);
        this.open = mask.clone();
        this.moves = new byte[mask.length];
        for (int q = 0; q < mask.length; q++) {
            for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
                boolean legal = at(q, GridFrame.dx(d), GridFrame.dy(d))
                        && at(q, GridFrame.dx(d), 0)
                        && at(q, 0, GridFrame.dy(d));
                if (mask[q] && legal) {
                    moves[q] |= 1 << d;
                }
            }
        }
    }

    /** Reads rows of text, the top one first; everything but {@code #} is open. */
    static MaskSteps of(String... rows) {
        int cols = rows[0].length();
        boolean[] mask = new boolean[rows.length * cols];
        for (int q = 0; q < mask.length; q++) {
            mask[q] = rows[rows.length - 1 - q / cols].charAt(q % cols) != '#';
        }
        return new MaskSteps(mask, cols, 1);
    }

    private boolean at(int q, int dx, int dy) {
        int col = frame.col(q) + dx;
        int row = frame.row(q) + dy;
        return col >= 0 && row >= 0 && col < frame.cols() && row < frame.rows() && open[frame.index(col, row)];
    }

    @Override
    public GridFrame frame() {
        return frame;
    }

    @Override
    public int size() {
        return moves.length;
    }

    @Override
    public int cell(int q) {
        return q;
    }

    @Override
    public boolean open(int q) {
        return open[q];
    }

    @Override
    public boolean plain(int q) {
        return true;
    }

    @Override
    public int moves(int q) {
        return moves[q] & 0xFF;
    }

    @Override
    public int neighbours(int q, int[] targets, int[] directions) {
        int[] offset = frame.offsets();
        int count = 0;
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            if ((moves[q] >> d & 1) != 0) {
                targets[count] = q + offset[d];
                directions[count++] = d;
            }
        }
        return count;
    }
}
