package troupe.unified.manipulation;

import java.util.Optional;
import troupe.unified.obstacle.Grip;
import troupe.unified.obstacle.Movable;
import troupe.unified.obstacle.Surroundings;

/**
 * Says what an instance is to find out: where to put an obstacle so that a path is free.
 *
 * @param movable the obstacle, at its own pose
 * @param surroundings what else there is in the search space
 * @param barred the poses in which it bars the path
 * @param prices what its moves cost
 * @param grip how the actor moves with it; empty if the actor has no part in it
 * @param trigger the configuration at which the actor begins
 */
public record Question(
        Movable movable,
        Surroundings surroundings,
        ConfigurationSpace barred,
        Prices prices,
        Optional<Grip> grip,
        int trigger) {}
