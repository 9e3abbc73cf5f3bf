package troupe.grid.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.StepRelation;

/** Checks what must hold of NF1 and NF2 by slow searches over the legal steps alone. */
final class FieldsOracle {
    private final StepRelation steps;
    private final String message;
    private final int[][] neighbours;
    private final int[][] directions;
    private final int[] seen;
    private int search;

    FieldsOracle(StepRelation steps, String message) {
        this.steps = steps;
        this.message = message;
        this.neighbours = new int[steps.size()][];
        this.directions = new int[steps.size()][];
        this.seen = new int[steps.size()];
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] headings = new int[Region.MAX_NEIGHBOURS];
        for (int q = 0; q < steps.size(); q++) {
            int count = steps.open(q) ? steps.neighbours(q, targets, headings) : 0;
            neighbours[q] = Arrays.copyOf(targets, count);
            directions[q] = Arrays.copyOf(headings, count);
        }
    }

    /** Checks the potential: unreachable elsewhere, no local minimum but the goal, the skeleton below its sides. */
    void checkPotential(Nf2 fields) {
        int[] distance = breadthFirst(fields.goal(), null);
        for (int q = 0; q < steps.size(); q++) {
            if (distance[q] < 0) {
                assertEquals(Nf2.UNREACHABLE, fields.potential(q), message + ": unreached " + q);
                continue;
            }
            assertTrue(fields.potential(q) < Nf2.UNREACHABLE, message + ": reached " + q);
            double lowest = Double.POSITIVE_INFINITY;
            for (int next : neighbours[q]) {
                lowest = Math.min(lowest, fields.potential(next));
                if (fields.skeleton(q) && !fields.skeleton(next)) {
                    assertTrue(
                            fields.potential(q) < fields.potential(next),
                            message + ": skeleton not below its side at " + at(q));
                }
            }
            if (q == fields.goal()) {
                assertEquals(0, fields.potential(q), message);
                assertTrue(lowest > 0, message + ": goal is not the minimum");
            } else {
                assertTrue(lowest < fields.potential(q), message + ": local minimum at " + at(q));
            }
        }
    }

    /** Checks that the skeleton is open, and that it has exactly one piece in each piece of the region. */
    void checkPieces(Nf2 fields) {
        boolean[] skeleton = skeleton(fields);
        int[] region = pieces(null);
        int[] curve = pieces(skeleton);
        int[] curveOf = new int[steps.size() + 1];
        for (int q = 0; q < steps.size(); q++) {
            if (skeleton[q]) {
                assertTrue(steps.open(q), message + ": skeleton outside the region at " + at(q));
                int known = curveOf[region[q]];
                assertTrue(known == 0 || known == curve[q], message + ": two skeletons in one piece, at " + at(q));
                curveOf[region[q]] = curve[q];
            }
        }
        for (int q = 0; q < steps.size(); q++) {
            assertFalse(steps.open(q) && curveOf[region[q]] == 0, message + ": piece without skeleton at " + at(q));
        }
    }

    /**
     * Checks, on a flat scene, that the skeleton has one loop around each hole: what it separates from one
     * another are exactly the 8-connected pieces of what is closed.
     */
    void checkLoops(Nf2 fields) {
        int[] holes = background(new boolean[steps.size()], true);
        int[] faces = background(skeleton(fields), false);
        int[] holeOf = new int[steps.size() + 2];
        for (int q = 0; q < steps.size(); q++) {
            if (!steps.open(q)) {
                int known = holeOf[faces[q]];
                assertTrue(known == 0 || known == holes[q], message + ": no loop between holes, at " + at(q));
                holeOf[faces[q]] = holes[q];
            }
        }
        for (int q = 0; q < steps.size(); q++) {
            assertFalse(
                    steps.open(q) && !fields.skeleton(q) && holeOf[faces[q]] == 0,
                    message + ": loop around nothing at " + at(q));
        }
    }

    /** Counts pieces and faces of the skeleton with one cell taken out; only for small flat scenes. */
    void checkThinByRecount(Nf2 fields) {
        boolean[] skeleton = skeleton(fields);
        int pieces = max(pieces(skeleton));
        int faces = max(background(skeleton, false));
        for (int q = 0; q < steps.size(); q++) {
            if (skeleton[q] && q != fields.goal() && degree(q, skeleton) > 1) {
                skeleton[q] = false;
                boolean same = pieces == max(pieces(skeleton)) && faces == max(background(skeleton, false));
                skeleton[q] = true;
                assertFalse(same, message + ": not thin at " + at(q));
            }
        }
    }

    /** Checks that no cell but an end can go without parting its neighbours on the skeleton from one another. */
    void checkThin(Nf2 fields) {
        boolean[] skeleton = skeleton(fields);
        for (int q = 0; q < steps.size(); q++) {
            if (!skeleton[q] || q == fields.goal() || degree(q, skeleton) < 2) {
                continue;
            }
            int[] link =
                    Arrays.stream(neighbours[q]).filter(next -> skeleton[next]).toArray();
            assertFalse(isConnected(link) && characteristic(link) == 1, message + ": not thin at " + at(q));
        }
    }

    private boolean isConnected(int[] set) {
        boolean[] within = new boolean[steps.size()];
        for (int q : set) {
            within[q] = true;
        }
        int[] distance = breadthFirst(set[0], within);
        return Arrays.stream(set).allMatch(q -> distance[q] >= 0);
    }

    /** Returns corners minus edges plus triangles of a set joined by legal steps. */
    private int characteristic(int[] set) {
        int sum = set.length;
        for (int a = 0; a < set.length; a++) {
            for (int b = 0; b < a; b++) {
                if (!joined(set[a], set[b])) {
                    continue;
                }
                sum--;
                for (int c = 0; c < b; c++) {
                    sum += joined(set[a], set[c]) && joined(set[b], set[c]) ? 1 : 0;
                }
            }
        }
        return sum;
    }

    private boolean joined(int a, int b) {
        return Arrays.stream(neighbours[a]).anyMatch(next -> next == b);
    }

    /**
     * Counts the cells of the ridge, goal link and connectors excepted, and of these the ones from which two
     * places where the region ends, more than two cells from each other, are equally far but for one cell.
     *
     * @return both numbers
     */
    int[] ridgeAndMedial(Nf2 fields) {
        int[] counts = new int[2];
        for (int q = 0; q < steps.size(); q++) {
            if (fields.ridge(q) && q != fields.goal()) {
                counts[0]++;
                counts[1] += isMedial(q, 2) ? 1 : 0;
            }
        }
        return counts;
    }

    /** Checks that 95 % of the ridge is medial. */
    void checkMedial(Nf2 fields) {
        int[] counts = ridgeAndMedial(fields);
        assertTrue(counts[1] >= 0.95 * counts[0], message + ": " + counts[1] + " of " + counts[0] + " are medial");
    }

    /** Follows the lowest neighbour from {@code start}; fails if that does not end at the goal. */
    void descend(Nf2 fields, int start) {
        int q = start;
        for (int step = 0; q != fields.goal(); step++) {
            int lowest = q;
            for (int next : neighbours[q]) {
                lowest = fields.potential(next) < fields.potential(lowest) ? next : lowest;
            }
            if (lowest == q || step > steps.size()) {
                fail(message + ": descent from " + at(start) + " stops at " + at(q));
            }
            q = lowest;
        }
    }

    /** Returns the number of steps to each node, -1 where there is no way, within a set or everywhere. */
    int[] breadthFirst(int start, boolean[] within) {
        int[] distance = new int[steps.size()];
        Arrays.fill(distance, -1);
        distance[start] = 0;
        List<Integer> queue = new ArrayList<>(List.of(start));
        for (int head = 0; head < queue.size(); head++) {
            int q = queue.get(head);
            for (int next : neighbours[q]) {
                if (distance[next] < 0 && (within == null || within[next])) {
                    distance[next] = distance[q] + 1;
                    queue.add(next);
                }
            }
        }
        return distance;
    }

    private boolean isMedial(int q, double apart) {
        List<int[]> ends = ends(q);
        if (ends.isEmpty()) {
            return false;
        }
        int[] nearest = ends.get(0);
        for (int[] end : ends) {
            nearest = length(end) < length(nearest) ? end : nearest;
        }
        for (int[] end : ends) {
            if (Math.hypot(end[0] - nearest[0], end[1] - nearest[1]) > apart && length(end) <= length(nearest) + 1) {
                return true;
            }
        }
        return false;
    }

    private static double length(int[] v) {
        return Math.hypot(v[0], v[1]);
    }

    /**
     * Finds the places where the region ends that a way leading only onwards from {@code start} comes upon, as
     * vectors from there, a little further than the nearest. A
     * diagonal is an end only if two straight steps do not lead to its corner.
     */
    private List<int[]> ends(int start) {
        List<int[]> ends = new ArrayList<>();
        List<int[]> queue = new ArrayList<>();
        seen[start] = ++search;
        queue.add(new int[] {start, 0, 0});
        double nearest = Double.POSITIVE_INFINITY;
        for (int head = 0; head < queue.size(); head++) {
            int[] node = queue.get(head);
            if (length(new int[] {node[1], node[2]}) > nearest + 3) {
                continue;
            }
            int present = 0;
            for (int k = 0; k < neighbours[node[0]].length; k++) {
                int d = directions[node[0]][k];
                present |= 1 << d;
                int next = neighbours[node[0]][k];
                int[] reached = {next, node[1] + GridFrame.dx(d), node[2] + GridFrame.dy(d)};
                boolean onwards = Math.hypot(reached[1], reached[2]) >= Math.hypot(node[1], node[2]);
                if (seen[next] != search && onwards) {
                    seen[next] = search;
                    queue.add(reached);
                }
            }
            for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
                if ((present >> d & 1) == 0
                        && (d < 4
                                || (present & 1 << d - 4 | present & 1 << (d - 3 & 3)) != 0
                                        && !goesRound(node[0], d))) {
                    int[] end = {node[1] + GridFrame.dx(d), node[2] + GridFrame.dy(d)};
                    ends.add(end);
                    nearest = Math.min(nearest, length(end));
                }
            }
        }
        return ends;
    }

    private boolean goesRound(int q, int d) {
        return leads(q, d - 4, d - 3 & 3) || leads(q, d - 3 & 3, d - 4);
    }

    private boolean leads(int q, int d, int then) {
        for (int k = 0; k < neighbours[q].length; k++) {
            if (directions[q][k] == d) {
                int next = neighbours[q][k];
                for (int heading : directions[next]) {
                    if (heading == then) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private boolean[] skeleton(Nf2 fields) {
        boolean[] skeleton = new boolean[steps.size()];
        for (int q = 0; q < skeleton.length; q++) {
            skeleton[q] = fields.skeleton(q);
        }
        return skeleton;
    }

    private int degree(int q, boolean[] set) {
        int degree = 0;
        for (int next : neighbours[q]) {
            degree += set[next] ? 1 : 0;
        }
        return degree;
    }

    /** Numbers the pieces of a set, or of the region, from 1. */
    private int[] pieces(boolean[] within) {
        int[] piece = new int[steps.size()];
        int count = 0;
        for (int q = 0; q < piece.length; q++) {
            if (piece[q] == 0 && (within == null ? steps.open(q) : within[q])) {
                count++;
                int[] distance = breadthFirst(q, within);
                for (int k = 0; k < piece.length; k++) {
                    piece[k] = distance[k] >= 0 ? count : piece[k];
                }
            }
        }
        return piece;
    }

    /** Numbers from 1 the pieces of the plane that a set leaves, or of what is closed; diagonals pass where no step does. */
    private int[] background(boolean[] set, boolean closedOnly) {
        GridFrame frame = steps.frame();
        int[] piece = new int[steps.size()];
        int count = 0;
        for (int start = 0; start < piece.length; start++) {
            if (piece[start] != 0 || set[start] || closedOnly && steps.open(start)) {
                continue;
            }
            piece[start] = ++count;
            List<Integer> queue = new ArrayList<>(List.of(start));
            for (int head = 0; head < queue.size(); head++) {
                int q = queue.get(head);
                for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
                    int col = frame.col(q) + GridFrame.dx(d);
                    int row = frame.row(q) + GridFrame.dy(d);
                    if (col < 0 || row < 0 || col >= frame.cols() || row >= frame.rows()) {
                        continue;
                    }
                    int next = frame.index(col, row);
                    if (piece[next] == 0
                            && !set[next]
                            && !(closedOnly && steps.open(next))
                            && !(d >= 4
                                    && barred(frame.index(col, frame.row(q)), frame.index(frame.col(q), row), set))) {
                        piece[next] = count;
                        queue.add(next);
                    }
                }
            }
        }
        return piece;
    }

    /** Tells whether two cells of the set bar the diagonal between them: both in, with a legal step. */
    private boolean barred(int a, int b, boolean[] set) {
        return set[a] && set[b] && joined(a, b);
    }

    private static int max(int[] values) {
        return Arrays.stream(values).max().orElse(0);
    }

    private String at(int q) {
        return q + " (column " + steps.frame().col(steps.cell(q)) + ", row "
                + steps.frame().row(steps.cell(q)) + ")";
    }
}
