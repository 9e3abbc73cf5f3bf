package troupe.crowd;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.crowd.flock.Agents;
import troupe.crowd.flock.Kin;
import troupe.crowd.ground.Ground;
import troupe.crowd.ground.Way;
import troupe.grid.GridLimitException;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Scene;

/** Places the members of one group after the other where they begin, and tells what keeps a group from that. */
public final class Beginning {
    private final Kin kin;
    private final Agents agents;
    private final Ground ground;
    private final Spawning spawning;

    /** Prepares to place the members of a crowd. */
    Beginning(Scene scene, Crowd crowd, Kin kin, Agents agents, Ground ground) {
        this.kin = kin;
        this.agents = agents;
        this.ground = ground;
        double[] world = {scene.world().width(), scene.world().depth()};
        spawning = new Spawning(agents, kin, crowd.seed(), crowd.manner().bodyHeight(), world);
    }

    /** Places the group at a number in {@link Kin#leaves}; returns why it cannot begin, nothing if it can. */
    Optional<String> place(int number) {
        Kin.Leaf leaf = kin.leaves().get(number);
        CrowdGroup.Members members = leaf.members();
        Optional<Way> way = ground.way(leaf.goal(), members.radius());
        if (way.isEmpty()) {
            return Optional.of(Ground.unreachable(leaf.group().id(), leaf.goal(), members.radius()));
        }
        for (int m = 0; m < members.count(); m++) {
            agents.leaf[leaf.first() + m] = number;
        }
        return spawning.place(leaf, way.get());
    }

    /**
     * Returns for each group with members, in document order, why it cannot begin after those before it: the fault, a
     * semicolon, and the cure. Cost: that of the ground of each radius and goal, and of placing everybody.
     *
     * @throws GridLimitException if the world is too large for its cells
     */
    public static List<Optional<String>> faults(Scene scene, Crowd crowd, Ground ground) {
        Kin kin = new Kin(crowd);
        Beginning beginning = new Beginning(scene, crowd, kin, new Agents(kin.agents()), ground);
        List<Optional<String>> faults = new ArrayList<>();
        for (int number = 0; number < kin.leaves().size(); number++) {
            faults.add(beginning.place(number));
        }
        return faults;
    }
}
