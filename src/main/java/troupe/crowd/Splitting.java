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
 * {@code free}: one for each goal, in which all count, and everybody chooses alone. Not in the paper, which names it as
 * future work.
 */
final class Splitting {
    private static final int PERIOD = 50;

    private final List<Branch> branches = new ArrayList<>();
    private final List<Detours> detours = new ArrayList<>();
    private final Crowding crowding;

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

    /** Renews the potentials whose turn it is in a step; tells whether there were any. */
    boolean renew(long step) {
        int n = branches.size();
        boolean any = false;
        for (int k = 0; k < n; k++) {
            if (step % PERIOD == (long) k * PERIOD / n) {
                Branch branch = branches.get(k);
                branch.way().set(branch.detours().find(branch.way().goal(), crowding.measure(branch.but())));
                any = true;
            }
        }
        return any;
    }
}
