package troupe.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Asks the crowd planner to simulate a tree of groups on the way to their goals. The task itself is the root of
 * the tree, everybody, at depth 0; its groups lie at depth 1, their parts at depth 2, and so on (Crowd sections 1.2
 * and 3.2; {@code docs/crowd.md}). Lists are copied.
 *
 * @param manner how everybody moves
 * @param weights the factors of the forces
 * @param relations the relation vectors that differ from {@link #defaultRelation}, at most one for each depth
 * @param groups the groups of depth 1
 * @param seconds the simulated time after which the task gives up, above 0
 */
public record Crowd(
        String id,
        String label,
        Manner manner,
        Weights weights,
        List<Relation> relations,
        List<CrowdGroup> groups,
        double seconds,
        long seed)
        implements Task {
    /** How long a crowd that does not say so is simulated, in seconds. */
    public static final double DEFAULT_SECONDS = 180;
    /** The seconds of a step of the simulation; there is a frame for each. */
    public static final double STEP_SECONDS = 0.04;

    /** How an agent moves: with anticipation and right of way, or by the paper's forces and grid steps alone. */
    public enum Motion {
        ANTICIPATE,
        PAPER
    }

    /** Who may take another way than the shortest when that is crowded: nobody, groups as a whole, each alone. */
    public enum Split {
        STATIC,
        TREE,
        FREE
    }

    /**
     * Says how everybody moves.
     *
     * @param view the distance in metres within which an agent sees others
     * @param bodyHeight the height in metres of every body
     * @param stepHeight the highest step in metres that is taken
     */
    public record Manner(Motion motion, Split split, double view, double bodyHeight, double stepHeight) {
        public static final Manner DEFAULT = new Manner(Motion.ANTICIPATE, Split.STATIC, 2, 1.7, 0.25);
        public static final double LEAST_VIEW = 0.5;
        public static final double MOST_VIEW = 10;
    }

    /** The factors of the five forces; each from 0 to {@value #MOST}. */
    public record Weights(double separation, double cohesion, double alignment, double path, double anticipation) {
        public static final Weights DEFAULT = new Weights(0.3, 0.4, 0.4, 1, 1);
        public static final double MOST = 20;
    }

    /** The factors of cohesion, alignment and separation between agents whose lowest common group has a depth. */
    public record Relation(int depth, double cohesion, double alignment, double separation) {}

    /** Copies the lists. */
    public Crowd {
        relations = List.copyOf(relations);
        groups = List.copyOf(groups);
    }

    /** Makes a crowd with every setting at its default. */
    public static Crowd of(String id, List<CrowdGroup> groups) {
        return new Crowd(id, "", Manner.DEFAULT, Weights.DEFAULT, List.of(), groups, DEFAULT_SECONDS, 1);
    }

    @Override
    public String kind() {
        return "crowd";
    }

    /** Returns all groups, each before its parts, in document order. */
    public Stream<CrowdGroup> allGroups() {
        return groups.stream().flatMap(CrowdGroup::withParts);
    }

    /** Finds a group of any depth by its id. */
    public Optional<CrowdGroup> group(String groupId) {
        return allGroups().filter(g -> g.id().equals(groupId)).findFirst();
    }

    /** Returns the depth of the deepest group, 0 if there is none. */
    public int deepest() {
        return groups.stream().mapToInt(CrowdGroup::height).max().orElse(0);
    }

    /** Returns the relation vector of a depth, from 0: the one given, or else the default. */
    public Relation relation(int depth) {
        return relations.stream()
                .filter(r -> r.depth() == depth)
                .findFirst()
                .orElseGet(() -> defaultRelation(depth, deepest()));
    }

    /**
     * Returns the relation vector that holds where none is given: with {@code t = depth / deepest} it is
     * {@code (2 t, 0.5 + t, 1.5 - t)}, so that closer relatives cohere and align more and push apart less; in a
     * crowd of one level (1, 1, 1).
     */
    public static Relation defaultRelation(int depth, int deepest) {
        if (deepest <= 1) {
            return new Relation(depth, 1, 1, 1);
        }
        double t = Math.min(1, (double) depth / deepest);
        return new Relation(depth, 2 * t, 0.5 + t, 1.5 - t);
    }

    /** Returns this crowd moving in another manner. */
    public Crowd with(Manner changed) {
        return new Crowd(id, label, changed, weights, relations, groups, seconds, seed);
    }

    /** Returns this crowd with other weights. */
    public Crowd with(Weights changed) {
        return new Crowd(id, label, manner, changed, relations, groups, seconds, seed);
    }

    /** Returns this crowd with the relation vector of one depth replaced. */
    public Crowd with(Relation changed) {
        List<Relation> all = new ArrayList<>(relations);
        all.removeIf(r -> r.depth() == changed.depth());
        all.add(changed);
        all.sort(java.util.Comparator.comparingInt(Relation::depth));
        return new Crowd(id, label, manner, weights, all, groups, seconds, seed);
    }

    /** Returns this crowd with other groups. */
    public Crowd with(List<CrowdGroup> changed) {
        return new Crowd(id, label, manner, weights, relations, changed, seconds, seed);
    }

    /** Returns this crowd with another limit of simulated time. */
    public Crowd lasting(double changed) {
        return new Crowd(id, label, manner, weights, relations, groups, changed, seed);
    }

    /** Returns this crowd with another seed. */
    public Crowd seeded(long changed) {
        return new Crowd(id, label, manner, weights, relations, groups, seconds, changed);
    }

    @Override
    public Crowd named(String otherId, String otherLabel) {
        return new Crowd(otherId, otherLabel, manner, weights, relations, groups, seconds, seed);
    }
}
