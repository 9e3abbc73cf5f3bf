package troupe.unified.manipulation;

import java.util.List;
import troupe.unified.obstacle.LatticePose;

/**
 * Says how an obstacle was moved.
 *
 * @param obstacle its number among the obstacles of the scene
 * @param gripped whether the actor held it and moved with it
 * @param from the configuration at which the actor began
 * @param to the configuration from which it goes on; {@code from} if not gripped
 * @param poses from where the obstacle stood to where it was put; each one move from the one before
 * @param length metres that its centroid travelled
 * @param turn radians that it turned, both senses added up
 * @param walked metres along the grid that the actor travelled with it, 0 if not gripped
 */
public record Transfer(
        int obstacle,
        boolean gripped,
        int from,
        int to,
        List<LatticePose> poses,
        double length,
        double turn,
        double walked) {

    /** Copies the poses and checks that there is one. */
    public Transfer {
        poses = List.copyOf(poses);
        if (poses.isEmpty()) {
            throw new IllegalArgumentException("transfer of obstacle " + obstacle + " without poses");
        }
    }

    /** Returns the same transfer by an actor that stands at a configuration all the while. */
    public Transfer beside(int configuration) {
        return new Transfer(obstacle, false, configuration, configuration, poses, length, turn, 0);
    }

    /** Returns where the obstacle was put. */
    public LatticePose last() {
        return poses.get(poses.size() - 1);
    }
}
