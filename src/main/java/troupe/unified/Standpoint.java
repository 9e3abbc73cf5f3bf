package troupe.unified;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import troupe.grid.Region;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Finds the configuration at the start or goal of a journey, or says why one cannot stand there.
 *
 * @param configuration the configuration, -1 if one cannot stand there
 * @param reason why not, in one line; empty if one can
 * @param blockedBy ids of the obstacles that forbid it
 */
record Standpoint(int configuration, String reason, List<String> blockedBy) {

    /** Looks up a place; {@code name} is {@code start} or {@code goal}. Cost O(obstacles). */
    static Standpoint at(Region region, Scene scene, Place place, String name) {
        int q = region.locate(place);
        boolean carried = q >= 0
                && Math.abs(place.z().orElse(region.elevation(q)) - region.elevation(q))
                        <= region.actor().stepHeight();
        if (carried && region.open(q)) {
            return new Standpoint(q, "", List.of());
        }
        String where = String.format(Locale.ROOT, "no path: the %s (%.2f, %.2f) ", name, place.x(), place.y());
        Actor actor = region.actor();
        double floor = carried ? region.elevation(q) : place.z().orElse(0);
        Optional<Obstacle> nearest = nearest(scene, actor, place, floor);
        double distance =
                nearest.map(o -> o.outline().distance(place.x(), place.y())).orElse(Double.POSITIVE_INFINITY);
        List<String> ids = nearest.map(o -> List.of(o.id())).orElse(List.of());
        if (distance == 0) {
            return new Standpoint(-1, where + "lies in '" + nearest.get().name() + "'", ids);
        }
        if (!carried) {
            return new Standpoint(-1, where + "has no floor with room for the actor", List.of());
        }
        double radius = actor.sidestep()
                .map(s -> Math.min(s.radius(), actor.walk().radius()))
                .orElse(actor.walk().radius());
        if (distance < radius + region.frame().cell()) {
            return new Standpoint(-1, where + "is too near to '" + nearest.get().name() + "'", ids);
        }
        return new Standpoint(-1, where + "is too near to the edge of the world or over a drop", List.of());
    }

    private static Optional<Obstacle> nearest(Scene scene, Actor actor, Place place, double floor) {
        Obstacle nearest = null;
        double least = Double.POSITIVE_INFINITY;
        for (Obstacle o : scene.obstacles()) {
            double distance = o.outline().distance(place.x(), place.y());
            if (distance < least && o.top() > floor + actor.stepHeight() && o.offset() < floor + actor.bodyHeight()) {
                least = distance;
                nearest = o;
            }
        }
        return Optional.ofNullable(nearest);
    }
}
