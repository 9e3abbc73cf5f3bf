package troupe.crowd;

import java.util.ArrayList;
import java.util.List;
import troupe.crowd.flock.Agents;
import troupe.crowd.flock.Crowding;
import troupe.crowd.flock.Kin;
import troupe.crowd.ground.Detours;
import troupe.crowd.ground.Ground;
import troupe.crowd.ground.Way;
import troupe.scene.Crowd;

/**
 * Renews the potentials of a crowd that may split: every {@value #PERIOD} steps each takes in how crowded and slow the
 * places are. {@code tree}: every group with members has a potential of its own in which its own members do not count,
 * so that it stays together, and takes another way than its siblings where that is faster; they are renewed in turn.
 * {@code free}: one for each goal, in which all count, and everybody chooses alone. The work for each is spread over the
 * steps until the turn of the next. Not in the paper, which names it as future work.
 */
final class Splitting {
    private static final int PERIOD = 50;

    private final List<Branch> branches = new ArrayList<>();
    private final List<Detours> detours = new ArrayList<>();
    private final Crowding crowding;
    /** The number of the branch whose potential was begun last, -1 before the first. */
    private int turn = -1;

    /** A way that is renewed, the group that does not count in it (-1: all do), and its scratch. */
    private record Branch(Way way, int but, Detours detours) {}

    /** Gives the agents of a crowd that may split ways of their own. */
    Splitting(Crowd crowd, Kin kin, Ground ground, Agents agents, double[] world) {
        crowding = new Crowding(agents, world[0], world[1]);
        if (crowd.manner().split() == Crowd.Split.FREE) {
            for (Way way : ground.ways()) {
                branches.add(new Branch(way, -1, detours(way)));
            }
        } else if (crowd.manner().split() == Crowd.Split.TREE) {
            for (int number = 0; number < kin.leaves().size(); number++) {
                Kin.Leaf leaf = kin.leaves().get(number);
                Way own = agents.way[leaf.first()].copy();
                branches.add(new Branch(own, number, detours(own)));
                for (int m = 0; m < leaf.members().count(); m++) {
                    agents.way[leaf.first() + m] = own;
                }
            }
        }
    }

    private Detours detours(Way way) {
        for (int k = 0; k < detours.size(); k++) {
            if (branches.get(k).way().terrain() == way.terrain()) {
                detours.add(detours.get(k));
                return detours.get(k);
            }
        }
        Detours made = new Detours(way.terrain());
        detours.add(made);
        return made;
    }

    /** Goes on with the potential whose turn it is in a step; tells whether one was set. */
    boolean renew(long step) {
        int n = branches.size();
        boolean any = false;
        int at = (int) (step % PERIOD);
        for (int k = 0; k < n; k++) {
            int from = k * PERIOD / n;
            int to = Math.max(from + 1, (k + 1) * PERIOD / n);
            turn = at == from ? k : turn;
            if (turn == k && at < to) {
                any |= goOn(branches.get(k), at == from, at == to - 1, to - from);
            }
        }
        return any;
    }

    private boolean goOn(Branch branch, boolean first, boolean last, int steps) {
        Detours found = branch.detours();
        if (first) {
            found.begin(branch.way().goal(), crowding.measure(branch.but()));
        }
        found.advance(last ? Long.MAX_VALUE : found.size() / steps + 1);
        if (last) {
            branch.way().set(found.found());
        }
        return last;
    }
}
