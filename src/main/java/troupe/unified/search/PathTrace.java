package troupe.unified.search;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import troupe.search.LabelPool;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.manipulation.Transfer;

/** Follows labels back to the start and tells what was done on the way. */
final class PathTrace {
    private final LabelPool labels;
    private final List<SearchSpace> spaces;
    private final List<MoveAttempt> attempts;

    PathTrace(LabelPool labels, List<SearchSpace> spaces, List<MoveAttempt> attempts) {
        this.labels = labels;
        this.spaces = spaces;
        this.attempts = attempts;
    }

    /** Returns the path that ends at a label. Cost O(its steps). */
    JourneyPath path(int reached, JourneyCosts costs) {
        List<JourneyPath.Part> parts = new ArrayList<>();
        List<Integer> way = new ArrayList<>();
        for (int label : chain(reached)) {
            boolean moves = labels.task(label) != LabelPool.NONE;
            if (!moves) {
                way.add(labels.state(label));
            }
            if (moves || label == reached) {
                int[] configurations = way.stream().mapToInt(Integer::intValue).toArray();
                parts.add(JourneyPath.way(spaces.get(labels.space(label)).region(), costs, configurations));
                way.clear();
            }
            if (moves) {
                parts.add(push(label));
            }
        }
        return JourneyPath.of(costs, parts);
    }

    private List<Integer> chain(int reached) {
        List<Integer> chain = new ArrayList<>();
        for (int label = reached; label != LabelPool.NONE; label = labels.parent(label)) {
            chain.add(label);
        }
        Collections.reverse(chain);
        return chain;
    }

    private JourneyPath.Push push(int label) {
        MoveAttempt attempt = attempts.get(labels.task(label));
        Transfer transfer = attempt.instance().transfer();
        return new JourneyPath.Push(
                attempt.obstacle(), transfer.gripped() ? transfer : transfer.beside(labels.state(label)));
    }
}
