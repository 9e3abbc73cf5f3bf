package troupe.run.view;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import troupe.grid.region.Region;

/**
 * Joins the configurations of a skeleton into polylines, from one end or branching to the next. A diagonal
 * is left out where two straight steps of the skeleton lead the same way. Used once.
 */
final class SkeletonLines {
    /** Directions below this number are straight. */
    private static final int STRAIGHT = 4;

    private final Region region;
    private final int[] storey;
    private final int[] nodes;
    private final int[][] joined;
    private final boolean[][] drawn;
    private final List<List<double[]>> lines = new ArrayList<>();

    /** Traces the polylines. Cost O(size of the region). */
    SkeletonLines(Region region, IntPredicate skeleton, int[] storey, int storeys) {
        this.region = region;
        this.storey = storey;
        int[] index = new int[region.size()];
        Arrays.fill(index, -1);
        nodes = IntStream.range(0, region.size()).filter(skeleton).toArray();
        for (int i = 0; i < nodes.length; i++) {
            index[nodes[i]] = i;
        }
        joined = new int[nodes.length][];
        drawn = new boolean[nodes.length][];
        join(index);
        for (int k = 0; k < storeys; k++) {
            lines.add(new ArrayList<>());
        }
        trace(true);
        trace(false);
    }

    /** Returns the polylines that begin in a storey. */
    List<double[]> inStorey(int k) {
        return List.copyOf(lines.get(k));
    }

    private void join(int[] index) {
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        int[][] straight = new int[nodes.length][];
        int[][] diagonal = new int[nodes.length][];
        for (int i = 0; i < nodes.length; i++) {
            int count = region.neighbours(nodes[i], targets, directions);
            int[] near = new int[count];
            int[] far = new int[count];
            int nears = 0;
            int fars = 0;
            for (int n = 0; n < count; n++) {
                int other = index[targets[n]];
                if (other >= 0 && directions[n] < STRAIGHT) {
                    near[nears++] = other;
                } else if (other >= 0) {
                    far[fars++] = other;
                }
            }
            straight[i] = Arrays.copyOf(near, nears);
            diagonal[i] = Arrays.copyOf(far, fars);
        }
        for (int i = 0; i < nodes.length; i++) {
            int at = i;
            int[] kept = Arrays.stream(diagonal[i])
                    .filter(other -> Arrays.stream(straight[at])
                            .noneMatch(middle -> Arrays.stream(straight[middle]).anyMatch(o -> o == other)))
                    .toArray();
            joined[i] = Arrays.copyOf(straight[i], straight[i].length + kept.length);
            System.arraycopy(kept, 0, joined[i], straight[i].length, kept.length);
            drawn[i] = new boolean[joined[i].length];
        }
    }

    private void trace(boolean fromEnds) {
        for (int i = 0; i < nodes.length; i++) {
            for (int k = 0; k < joined[i].length; k++) {
                if (!drawn[i][k] && (!fromEnds || joined[i].length != 2)) {
                    follow(i, k);
                }
            }
        }
    }

    private void follow(int begin, int way) {
        List<Integer> line = new ArrayList<>(List.of(begin));
        int at = begin;
        int out = way;
        while (out >= 0) {
            int next = joined[at][out];
            drawn[at][out] = true;
            int back = indexOf(joined[next], at);
            drawn[next][back] = true;
            line.add(next);
            out = joined[next].length == 2 && !drawn[next][1 - back] ? 1 - back : -1;
            at = next;
        }
        double[] points = new double[2 * line.size()];
        for (int i = 0; i < line.size(); i++) {
            points[2 * i] = region.x(nodes[line.get(i)]);
            points[2 * i + 1] = region.y(nodes[line.get(i)]);
        }
        lines.get(storey[nodes[begin]]).add(points);
    }

    private static int indexOf(int[] values, int wanted) {
        for (int i = 0; i < values.length; i++) {
            if (values[i] == wanted) {
                return i;
            }
        }
        throw new IllegalStateException("a step of the region that does not lead back");
    }
}
