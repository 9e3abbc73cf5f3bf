package troupe.unified.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import troupe.grid.region.Region;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.unified.body.SweptBody;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.manipulation.Transfer;
import troupe.unified.obstacle.Movable;
import troupe.unified.search.JourneyPath;

/**
 * Makes of a path the stretches that an actor travels: those of its ways, each in the scene as it stands by
 * then, and one for each obstacle that is moved. The energies of the stretches add up to that of the path.
 */
public final class RouteBuilder {
    private final Scene scene;
    private final Actor actor;
    private final JourneyCosts costs;

    /** Makes the routes of an actor, which has already lost the abilities that preferences switch off. */
    public RouteBuilder(Scene scene, Actor actor, JourneyCosts costs) {
        this.scene = scene;
        this.actor = actor;
        this.costs = costs;
    }

    /** Returns the stretches of a path; one stretch of a single point where the path has no step. */
    public List<Stretch> route(JourneyPath path) {
        List<Stretch> route = new ArrayList<>();
        Scene now = scene;
        JourneyPath.Way last = null;
        for (JourneyPath.Part part : path.parts()) {
            SweptBody body = new SweptBody(now, actor);
            if (part instanceof JourneyPath.Way way) {
                boolean alone = path.parts().size() == 1;
                route.addAll(new WayBuilder(way, costs, body).stretches(alone));
                last = way;
            } else if (part instanceof JourneyPath.Push push) {
                route.add(moved(push, Objects.requireNonNull(last).region(), body));
                Movable movable = push.movable();
                now = now.with(movable.obstacle()
                        .withOutline(movable.outline(push.transfer().last())));
            }
        }
        return route;
    }

    private Stretch moved(JourneyPath.Push push, Region region, SweptBody body) {
        Transfer transfer = push.transfer();
        Haul haul =
                new Haul(push.movable(), transfer, stand(region, transfer.from()), stand(region, transfer.to()), body);
        Obstacle obstacle = push.movable().obstacle();
        double energy = costs.moveEnergy(obstacle.mass(), transfer.length(), transfer.turn())
                + transfer.walked() * costs.energy(Ability.WALK);
        return new Stretch(Ability.MOVE, obstacle.id(), energy, haul.points(), Optional.of(haul));
    }

    private static Haul.Stand stand(Region region, int q) {
        return new Haul.Stand(region.x(q), region.y(q), region.elevation(q));
    }
}
