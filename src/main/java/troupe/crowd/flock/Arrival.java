package troupe.crowd.flock;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntConsumer;
import troupe.crowd.ground.Terrain;
import troupe.crowd.ground.Way;

/**
 * Lets agents settle around their goals, which hold only so many. Who comes near gets one of the {@link Places} and
 * stays there, or near the goal where it can get no nearer, so that nobody shoves. Not in the paper.
 */
final class Arrival {
    /** The share of the ground around a goal that the bodies cover; those who come from one side use half of it. */
    private static final double PACKING = 0.25;
    /** The same as far out as one settles that is kept out by others. */
    private static final double LOOSE = 0.13;
    /** Metres of way farther out at which one settles at last. */
    private static final double MARGIN = 2;
    /** Metres of way from a place at which one gets it. */
    private static final double BEFORE = 4;
    /** The radii from its place within which one settles that gets no nearer. */
    private static final double BESIDE = 5;
    /** Steps for which one gets no nearer, two seconds, until it settles beside its place or others who have settled. */
    private static final int HELD = 50;
    /** The same, six seconds, for one that has nobody to settle beside, or is still far out. */
    private static final int STALLS = 150;
    /** The same, 24 seconds, for one that stands where nobody can pass it, or farther out still. */
    private static final int SHUT_IN = 600;

    private final Agents agents;
    private final Cells cells;
    private final Proposals proposals;
    private final boolean paper;
    private final List<Places> goals = new ArrayList<>();
    /** For each agent the number of its goal among the goals, and the span of its own place, -1 before it has one. */
    private final int[] goal;

    private final int[] place;
    private final double[] near;
    private final double[] far;
    private final boolean[] asks;

    /** Lays out the places around all goals; {@code paper} leaves everybody with the goal itself. */
    Arrival(Kin kin, Agents agents, Cells cells, Proposals proposals, boolean paper) {
        this.agents = agents;
        this.cells = cells;
        this.proposals = proposals;
        this.paper = paper;
        goal = new int[agents.count];
        place = new int[agents.count];
        near = new double[agents.count];
        far = new double[agents.count];
        asks = new boolean[agents.count];
        Arrays.fill(place, -1);
        for (Kin.Leaf leaf : kin.leaves()) {
            measure(kin.leaves(), leaf);
        }
    }

    private void measure(List<Kin.Leaf> leaves, Kin.Leaf leaf) {
        Way way = agents.way[leaf.first()];
        double bodies = 0;
        double widest = 0;
        Kin.Leaf eldest = null;
        for (Kin.Leaf other : leaves) {
            if (agents.way[other.first()].goal() == way.goal()) {
                double radius = other.members().radius();
                bodies += other.members().count() * Math.PI * radius * radius;
                widest = Math.max(widest, radius);
                eldest = eldest == null ? other : eldest;
            }
        }
        int end = leaf.first() + leaf.members().count();
        Arrays.fill(near, leaf.first(), end, way.holding(bodies / PACKING));
        Arrays.fill(far, leaf.first(), end, way.holding(bodies / LOOSE));
        if (eldest == leaf) {
            goals.add(new Places(way, widest, near[leaf.first()]));
        }
        Arrays.fill(goal, leaf.first(), end, eldest == leaf ? goals.size() - 1 : goal[eldest.first()]);
    }

    /** Returns the span that an agent goes for, which has come to a span where it looks around. */
    int target(int i) {
        Way way = agents.way[i];
        int span = agents.span[i];
        if (place[i] >= 0 && way.terrain().sees(span, place[i])) {
            return place[i];
        }
        asks[i] = !paper && place[i] < 0 && agents.left[i] <= near[i] + BEFORE;
        return way.towards(span);
    }

    /** Hands places to those who have asked in the last step, in the order of their numbers; tells each of them. */
    void handOut(IntConsumer told) {
        for (int i = 0; i < agents.count; i++) {
            if (!asks[i] || agents.state[i] == Agents.ARRIVED) {
                continue;
            }
            Places places = goals.get(goal[i]);
            if (agents.left[i] > places.outermost() + 2 * BEFORE) {
                // the next place is nearer to the goal than that: there is no need to look for it
                continue;
            }
            int p = places.next(agents.x[i], agents.y[i]);
            if (p < 0) {
                asks[i] = false;
                continue;
            }
            Way way = agents.way[i];
            int span = places.span(p);
            if (agents.left[i] <= way.potential(span) + BEFORE && way.terrain().sees(agents.span[i], span)) {
                asks[i] = false;
                places.take(p);
                place[i] = span;
                agents.lowest[i] = Float.POSITIVE_INFINITY;
                told.accept(i);
            }
        }
    }

    /** Notes whether an agent has come nearer to its goal, or to its place once it has one. */
    void progress(int i) {
        float left = place[i] >= 0 ? (float) distance(i) : agents.left[i];
        if (left < agents.lowest[i] - 0.05f) {
            agents.lowest[i] = left;
            agents.stalled[i] = 0;
        } else {
            agents.stalled[i]++;
        }
    }

    private double distance(int i) {
        Terrain terrain = agents.way[i].terrain();
        double dx = terrain.region().x(place[i]) - agents.x[i];
        double dy = terrain.region().y(place[i]) - agents.y[i];
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Tells whether the agent with the proposal at {@code k} stays where it is for good. */
    boolean arrives(int k, int i) {
        double left = agents.left[i];
        if (place[i] >= 0 ? distance(i) <= agents.radius[i] : left <= agents.radius[i]) {
            return true;
        }
        int stalled = agents.stalled[i];
        if (stalled < HELD) {
            return false;
        }
        if (place[i] >= 0 && distance(i) <= BESIDE * agents.radius[i]) {
            return true;
        }
        if (agents.tight[i]) {
            return stalled >= SHUT_IN && left <= near[i];
        }
        int patience = left <= near[i] ? HELD : left <= far[i] ? STALLS : SHUT_IN;
        return left <= near[i] && stalled >= STALLS
                || left <= far[i] + MARGIN && stalled >= patience && touchesArrived(k, i);
    }

    private boolean touchesArrived(int k, int i) {
        int count = Math.min(Proposals.CONTACTS, proposals.contactCount[k]);
        for (int c = 0; c < count; c++) {
            int j = proposals.contacts[k * Proposals.CONTACTS + c];
            // the state of the step before, so that the order of the agents does not matter
            if (cells.state[j] == Agents.ARRIVED && goal[cells.agent[j]] == goal[i]) {
                return true;
            }
        }
        return false;
    }
}
