package troupe.grid.region;

import troupe.grid.GridFrame;

/**
 * Tells which configurations are open and which legal steps join them: what NF1 and NF2 need to know of a
 * region. Configurations are numbered {@code 0 <= q < size()}; the relation of legal steps is symmetric.
 */
public interface StepRelation {
    /** Returns the frame of the cells. */
    GridFrame frame();

    /** Returns the number of configurations, open or not. */
    int size();

    /** Returns the cell over which a configuration lies. */
    int cell(int q);

    /** Tells whether a configuration is not forbidden. */
    boolean open(int q);

    /** Tells whether all legal steps from {@code q} are given by {@link #moves}. */
    boolean plain(int q);

    /** Returns the directions, one bit each, in which {@code q} plus the offset of the direction is a legal step. */
    int moves(int q);

    /**
     * Lists all legal steps from {@code q} in ascending order of direction, then target.
     *
     * @param targets receives the targets; at least {@link Region#MAX_NEIGHBOURS} long
     * @param directions receives the directions; as long
     * @return how many there are; the first entries of both arrays are filled
     */
    int neighbours(int q, int[] targets, int[] directions);
}
