package troupe.unified;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import troupe.grid.region.Region;
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
        Near asked = Near.of(scene, actor, place, place.z().orElse(0));
        if (asked.metres() == 0) {
            return new Standpoint(-1, where + "lies in '" + asked.name() + "'", asked.ids());
        }
        if (!carried) {
            return new Standpoint(-1, where + "has no floor with room for the actor", List.of());
        }
        Near there = Near.of(scene, actor, place, region.elevation(q));
        double radius = actor.sidestep()
                .map(s -> Math.min(s.radius(), actor.walk().radius()))
                .orElse(actor.walk().radius());
        if (there.metres() < radius + region.frame().cell()) {
            return new Standpoint(-1, where + "is too near to '" + there.name() + "'", there.ids());
        }
        return new Standpoint(-1, where + "is too near to the edge of the world or over a drop", List.of());
    }

    /** The obstacle nearest to a place among those that a body standing on a floor there would meet. */
    private record Near(Optional<Obstacle> obstacle, double metres) {
        static Near of(Scene scene, Actor actor, Place place, double floor) {
            Obstacle nearest = null;
            double least = Double.POSITIVE_INFINITY;
            for (Obstacle o : scene.obstacles()) {
                double distance = o.outline().distance(place.x(), place.y());
                if (distance < least
                        && o.top() > floor + actor.stepHeight()
                        && o.offset() < floor + actor.bodyHeight()) {
                    least = distance;
                    nearest = o;
                }
            }
            return new Near(Optional.ofNullable(nearest), least);
        }

        String name() {
            return obstacle.map(Obstacle::name).orElse("");
        }

        List<String> ids() {
            return obstacle.map(o -> List.of(o.id())).orElse(List.of());
        }
    }
}
