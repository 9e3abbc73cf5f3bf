package troupe.unified.manipulation;

import java.util.Arrays;

/**
 * Finds the label of a pose: an int for each cell that holds the centroid and each state there. Labels of
 * 4 x 4 cells lie side by side; such blocks are made as they are reached, and found by open addressing, so
 * that the neighbours of a pose are mostly found without a search. Costs O(1); allocates only to grow.
 */
final class PoseTable {
    /** Stands for a pose that has no label yet. */
    static final int NONE = -1;

    private static final int SIDE = 2;
    private static final int MASK = (1 << SIDE) - 1;

    private final int states;
    private final int blockCols;
    private final int blockSize;
    private int[] blocks = new int[64];
    private int[] places = new int[64];
    private int[] labels;
    private int count;
    private int lastBlock = -1;
    private int lastPlace;

    /**
     * Makes an empty table.
     *
     * @param cols the number of columns of the frame
     * @param states how many states there are in each cell
     */
    PoseTable(int cols, int states) {
        this.states = states;
        this.blockCols = (cols >> SIDE) + 1;
        this.blockSize = states << 2 * SIDE;
        this.labels = new int[blockSize];
        Arrays.fill(blocks, -1);
        Arrays.fill(labels, NONE);
    }

    /** Returns where the label of a state of a cell lies, for {@link #get} and {@link #set}. */
    int slot(int col, int row, int state) {
        int block = (row >> SIDE) * blockCols + (col >> SIDE);
        if (block != lastBlock) {
            lastPlace = place(block);
            lastBlock = block;
        }
        return lastPlace + ((row & MASK) << SIDE | col & MASK) * states + state;
    }

    /** Returns the label at a slot, {@link #NONE} if it has not been set. */
    int get(int slot) {
        return labels[slot];
    }

    /** Sets the label at a slot. */
    void set(int slot, int label) {
        labels[slot] = label;
    }

    private int place(int block) {
        int mask = blocks.length - 1;
        int at = hash(block) & mask;
        while (blocks[at] != block) {
            if (blocks[at] < 0) {
                return add(block, at);
            }
            at = at + 1 & mask;
        }
        return places[at];
    }

    private static int hash(int block) {
        int mixed = block * 0x9E3779B9;
        return mixed ^ mixed >>> 15;
    }

    private int add(int block, int at) {
        int place = Math.multiplyExact(count++, blockSize);
        blocks[at] = block;
        places[at] = place;
        if (place + blockSize > labels.length) {
            int used = labels.length;
            labels = Arrays.copyOf(labels, Math.addExact(used, used));
            Arrays.fill(labels, used, labels.length, NONE);
        }
        if (2 * count > blocks.length) {
            grow();
        }
        return place;
    }

    private void grow() {
        int[] oldBlocks = blocks;
        int[] oldPlaces = places;
        blocks = new int[2 * oldBlocks.length];
        places = new int[blocks.length];
        Arrays.fill(blocks, -1);
        for (int i = 0; i < oldBlocks.length; i++) {
            if (oldBlocks[i] >= 0) {
                int at = hash(oldBlocks[i]) & blocks.length - 1;
                while (blocks[at] >= 0) {
                    at = at + 1 & blocks.length - 1;
                }
                blocks[at] = oldBlocks[i];
                places[at] = oldPlaces[i];
            }
        }
    }
}
