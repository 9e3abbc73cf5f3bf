package troupe.unified.manipulation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import troupe.grid.GridFrame;
import troupe.search.BestFirst;
import troupe.search.Expander;
import troupe.search.MinHeap;
import troupe.search.OpenList;
import troupe.search.Outcome;
import troupe.unified.obstacle.Grip;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;
import troupe.unified.obstacle.Support;
import troupe.unified.obstacle.Sweeps;

/**
 * Searches for the cheapest place to which an obstacle can be moved so that it does not bar an expected
 * path: from where it stands over the poses of its lattice to one that bars nothing (with a grip: and where the
 * actor can let go). Of several that cost as little it is, with a grip, the one that leaves the actor nearest to the end of
 * its path; then that of the least heading, row, column. Poses are taken in the order of their cost and what they still cost at
 * least ({@link ExitDistance}), moves tried in the order east, north, west, south, north-east, north-west, south-west, south-east, counter-clockwise, clockwise. It
 * can pause after any expansion; how it is sliced changes nothing. Used by one thread at a time.
 *
 * <p>With two headings an obstacle is turned counter-clockwise only, so that two poses tell the motion
 * between them; with one it is not turned.
 *
 * <p>Source: Unified section 6.3. The paper's search is not specified further; cost, sweeps on polygons and
 * support are ours.
 */
public final class Instance {
    private static final int UNSUPPORTED = -2;

    private final Question question;
    private final Movable movable;
    private final ConfigurationSpace barred;
    private final Grip grip;
    private final Sweeps sweeps;
    private final Support support;
    private final int headings;
    private final int cols;
    private final int rows;
    private final int homeCol;
    private final int homeRow;
    private final MoveCosts costs;
    private final double share;
    private PoseTable table;
    private OpenList open = new MinHeap(32);
    private BestFirst search;
    private PoseLabels labels = new PoseLabels();
    private ExitDistance exit;
    private int reached = PoseLabels.NONE;

    private Outcome outcome = Outcome.RUNNING;
    private long expanded;
    private long cost = Long.MAX_VALUE;
    private Transfer transfer;

    /** Prepares the search; the first expansion takes the pose in which the obstacle stands. */
    public Instance(Question question) {
        this.question = question;
        movable = question.movable();
        barred = question.barred();
        grip = question.grip().orElse(null);
        sweeps = question.surroundings().sweeps(movable);
        support = question.surroundings().support(movable);
        headings = movable.headings();
        GridFrame frame = barred.path().frame();
        cols = frame.cols();
        rows = frame.rows();
        homeCol = frame.colAt(movable.centroid().x());
        homeRow = frame.rowAt(movable.centroid().y());
        costs = new MoveCosts(question);
        share = costs.obstacleShare();
        exit = new ExitDistance(movable, barred, costs.straight(), costs.diagonal(), costs.leastTurn());
        table = new PoseTable(cols, headings * (grip == null ? 1 : grip.sheets()));
        search = new BestFirst(
                open,
                this::expand,
                new Outcome.Infeasible(movable.obstacle().id() + " cannot be moved out of the way"),
                Long.MAX_VALUE);
        int slot = table.slot(homeCol, homeRow, state(0, question.trigger()));
        take(PoseTable.NONE, slot, PoseLabels.NONE, homeCol, homeRow, 0, question.trigger(), 0);
    }

    /** Returns what is asked. */
    public Question question() {
        return question;
    }

    /**
     * Goes on until {@code budget} expansions are done, the search has ended, or no pose that is open costs
     * {@code most} or less. Returns the number of expansions done; where it stops changes no result.
     *
     * @param budget from 0
     * @param most in units of the prices
     */
    public long advance(long budget, long most) {
        if (search == null) {
            return 0;
        }
        long before = search.expanded();
        while (search.outcome().isRunning() && search.expanded() - before < budget) {
            if (!open.isEmpty() && open.firstKey() > most) {
                break;
            }
            search.step(1);
        }
        if (search.outcome().isRunning() && open.isEmpty()) {
            search.step(1);
        }
        long done = search.expanded() - before;
        if (!search.outcome().isRunning()) {
            end();
        }
        return done;
    }

    /** Keeps what has come out and lets go of the memory of the search. */
    private void end() {
        outcome = search.outcome();
        expanded = search.expanded();
        if (outcome.isFound()) {
            cost = labels.cost(reached);
            transfer = traced();
        }
        search = null;
        table = null;
        open = null;
        labels = null;
        exit = null;
    }

    /** Returns how the search stands: running, found, or infeasible if the obstacle cannot be moved out of the way. */
    public Outcome outcome() {
        return outcome;
    }

    /**
     * Returns a lower bound in units on the cost of the result: the cost itself when known, the least that open poses
     * promise while running, {@link Long#MAX_VALUE} if there is no result.
     */
    public long least() {
        if (search == null) {
            return cost;
        }
        return open.isEmpty() ? Long.MAX_VALUE : open.firstKey();
    }

    /** Returns the expansions so far. */
    public long expanded() {
        return search == null ? expanded : search.expanded();
    }

    /**
     * Returns the cost in units: of moving the obstacle, and with a grip of walking with it.
     *
     * @throws IllegalStateException unless found
     */
    public long cost() {
        requireFound();
        return cost;
    }

    /**
     * Returns the least share, from 0 to 1, that moving the obstacle has in the cost of a move: with a grip
     * the rest is walking.
     */
    public double obstacleShare() {
        return share;
    }

    /**
     * Returns how the obstacle was moved.
     *
     * @throws IllegalStateException unless found
     */
    public Transfer transfer() {
        requireFound();
        return transfer;
    }

    private Transfer traced() {
        List<LatticePose> poses = new ArrayList<>();
        for (int label = reached; label != PoseLabels.NONE; label = labels.parent(label)) {
            int cell = labels.cell(label);
            poses.add(new LatticePose(cell % cols - homeCol, cell / cols - homeRow, labels.heading(label)));
        }
        Collections.reverse(poses);
        return new Travel(movable, grip).along(poses, question.trigger(), labels.stand(reached));
    }

    private void requireFound() {
        if (!outcome().isFound()) {
            throw new IllegalStateException("outcome " + outcome().word() + "; only a search that found has a result");
        }
    }

    private Expander.Verdict expand(int label, long key) {
        boolean passed = reached >= 0 && key > labels.cost(reached);
        Expander.Verdict verdict = passed ? Expander.Verdict.SKIPPED : take(label, key);
        boolean over = reached >= 0 && (passed || open.isEmpty() || open.firstKey() > labels.cost(reached));
        return over ? Expander.Verdict.GOAL : verdict;
    }

    private Expander.Verdict take(int label, long key) {
        int col = labels.cell(label) % cols;
        int row = labels.cell(label) / cols;
        int k = labels.heading(label);
        int i = col - homeCol;
        int j = row - homeRow;
        long least = Prices.sum(labels.cost(label), exit.of(i, j, k));
        if (key < least) {
            open.add(label, least, labels.cost(label));
            return Expander.Verdict.SKIPPED;
        }
        if (key > least || labels.close(label)) {
            return Expander.Verdict.SKIPPED;
        }
        if (!barred.contains(i, j, k) && (grip == null || grip.settles(labels.stand(label), i, j, k))) {
            reached = reached < 0 || precedes(label, reached) ? label : reached;
            return Expander.Verdict.EXPANDED;
        }
        if (!sweeps.isFree()) {
            return Expander.Verdict.EXPANDED;
        }
        sweeps.choose(i, j, k);
        if (grip != null) {
            grip.choose(labels.stand(label), i, j, k);
        }
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            shift(label, col, row, k, d);
        }
        if (headings > 1) {
            turn(label, col, row, k, true);
        }
        if (headings > 2) {
            turn(label, col, row, k, false);
        }
        return Expander.Verdict.EXPANDED;
    }

    /**
     * Tells which of two poses of equal cost is the result: with a grip that which leaves the actor nearer to the end of its
     * path, cell to cell; then that of the lesser heading, row, column, stand.
     */
    private boolean precedes(int label, int other) {
        long far = grip == null ? 0 : farness(labels.stand(label)) - farness(labels.stand(other));
        if (far != 0) {
            return far < 0;
        }
        if (labels.heading(label) != labels.heading(other)) {
            return labels.heading(label) < labels.heading(other);
        }
        return labels.cell(label) != labels.cell(other)
                ? labels.cell(label) < labels.cell(other)
                : labels.stand(label) < labels.stand(other);
    }

    private long farness(int stand) {
        int cell = stand % (cols * rows);
        int end = barred.path().cell(barred.path().size() - 1);
        long dx = cell % cols - end % cols;
        long dy = cell / cols - end / cols;
        return dx * dx + dy * dy;
    }

    private void shift(int label, int fromCol, int fromRow, int k, int direction) {
        int col = fromCol + GridFrame.dx(direction);
        int row = fromRow + GridFrame.dy(direction);
        if (col < 0 || row < 0 || col >= cols || row >= rows) {
            return;
        }
        int stand = grip == null ? labels.stand(label) : grip.shifted(direction);
        if (stand < 0) {
            return;
        }
        long cost = Prices.sum(labels.cost(label), costs.shift(direction));
        int slot = table.slot(col, row, state(k, stand));
        int known = table.get(slot);
        if (isBetter(known, cost)
                && sweeps.canShift(direction)
                && (grip == null || grip.canShift(direction, stand))
                && isSupported(known, slot, col, row, k)) {
            take(known, slot, label, col, row, k, stand, cost);
        }
    }

    private void turn(int label, int col, int row, int from, boolean counterClockwise) {
        int k = counterClockwise ? (from + 1 == headings ? 0 : from + 1) : (from == 0 ? headings : from) - 1;
        int stand = grip == null ? labels.stand(label) : grip.turned(counterClockwise);
        if (stand < 0) {
            return;
        }
        long cost = Prices.sum(labels.cost(label), costs.turn(counterClockwise ? from : k));
        int slot = table.slot(col, row, state(k, stand));
        int known = table.get(slot);
        if (isBetter(known, cost)
                && sweeps.canTurn(counterClockwise)
                && (grip == null || grip.canTurn(counterClockwise))
                && isSupported(known, slot, col, row, k)) {
            take(known, slot, label, col, row, k, stand, cost);
        }
    }

    private int state(int k, int stand) {
        return grip == null ? k : grip.sheet(stand) * headings + k;
    }

    private boolean isBetter(int known, long cost) {
        return cost < Prices.BLOCKED && known != UNSUPPORTED && (known < 0 || cost < labels.cost(known));
    }

    private boolean isSupported(int known, int slot, int col, int row, int k) {
        if (known >= 0 || support.rests(col - homeCol, row - homeRow, k)) {
            return true;
        }
        table.set(slot, UNSUPPORTED);
        return false;
    }

    private void take(int known, int slot, int parent, int col, int row, int k, int stand, long cost) {
        int label = known;
        if (label < 0) {
            label = labels.add(row * cols + col, k);
            table.set(slot, label);
        }
        labels.set(label, parent, stand, cost);
        long least = Prices.sum(cost, exit.quick(col - homeCol, row - homeRow, k));
        open.add(label, least, cost);
    }
}
