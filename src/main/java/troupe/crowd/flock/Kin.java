package troupe.crowd.flock;

import java.util.ArrayList;
import java.util.List;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;

/**
 * Flattens a crowd's tree: the groups that have members, in document order, the goal of each, and for any two of them
 * the depth of their lowest common group (Crowd section 3.2). Immutable.
 */
public final class Kin {
    private final List<Leaf> leaves = new ArrayList<>();
    private final byte[] depths;

    /**
     * A group that has members.
     *
     * @param chain the groups from depth 1 down to this one
     * @param goal its own goal, or that of the nearest group above that has one
     * @param first the number of its first agent; its agents are numbered in order
     */
    public record Leaf(CrowdGroup group, List<CrowdGroup> chain, Place goal, int first) {
        /** Returns its members. */
        public CrowdGroup.Members members() {
            return group.members().orElseThrow();
        }
    }

    /** Flattens the tree of a crowd that has passed the checks. Cost O(groups with members squared). */
    public Kin(Crowd crowd) {
        crowd.groups().forEach(g -> collect(g, List.of(), null));
        int n = leaves.size();
        depths = new byte[n * n];
        for (int a = 0; a < n; a++) {
            for (int b = 0; b < n; b++) {
                depths[a * n + b] =
                        (byte) common(leaves.get(a).chain(), leaves.get(b).chain());
            }
        }
    }

    private void collect(CrowdGroup group, List<CrowdGroup> above, Place inherited) {
        Place goal = group.goal().orElse(inherited);
        List<CrowdGroup> chain = new ArrayList<>(above);
        chain.add(group);
        if (group.members().isPresent()) {
            leaves.add(new Leaf(group, List.copyOf(chain), goal, agents()));
        }
        group.parts().forEach(part -> collect(part, chain, goal));
    }

    private static int common(List<CrowdGroup> a, List<CrowdGroup> b) {
        int depth = 0;
        while (depth < Math.min(a.size(), b.size()) && a.get(depth) == b.get(depth)) {
            depth++;
        }
        return depth;
    }

    /** Returns the groups that have members, in document order. */
    public List<Leaf> leaves() {
        return leaves;
    }

    /** Returns the number of agents. */
    public int agents() {
        if (leaves.isEmpty()) {
            return 0;
        }
        Leaf last = leaves.get(leaves.size() - 1);
        return last.first() + last.members().count();
    }

    /** Returns the depth of the lowest common group of agents of two groups, by their numbers in {@link #leaves}. */
    public int depth(int a, int b) {
        return depths[a * leaves.size() + b];
    }

    /** Returns the whole table, row by row; not to be changed. */
    byte[] depths() {
        return depths;
    }
}
