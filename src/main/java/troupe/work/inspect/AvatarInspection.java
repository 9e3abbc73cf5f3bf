package troupe.work.inspect;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import troupe.risk.Course;
import troupe.risk.EncounterViews;
import troupe.risk.forecast.Ways;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Follows the avatars of an encounter over the ground, and finds those that walk through what stands there, or begin
 * where the actor does. Nothing of that keeps an encounter from being planned.
 */
final class AvatarInspection {
    /** Seconds between the places of a course that are looked at: some centimetres of way. */
    private static final double EACH = 0.05;

    private final Scene scene;
    private final Encounter encounter;
    private final Actor actor;
    private final Ways ways;

    private AvatarInspection(Scene scene, Encounter encounter, Actor actor) {
        this.scene = scene;
        this.encounter = encounter;
        this.actor = actor;
        this.ways = EncounterViews.ways(scene);
    }

    /**
     * Returns what is odd about the avatars, in their order. Cost O(cells), and O(1) for each {@value #EACH} s of an
     * avatar's course.
     */
    static List<SceneInspection.Fault> of(Scene scene, Encounter encounter, Actor actor) {
        AvatarInspection inspection = new AvatarInspection(scene, encounter, actor);
        List<SceneInspection.Fault> faults = new ArrayList<>();
        for (Avatar avatar : encounter.avatars()) {
            Course course = Course.of(avatar);
            inspection.touching(avatar, course).ifPresent(faults::add);
            inspection.barred(avatar, course).ifPresent(faults::add);
        }
        return faults;
    }

    private Optional<SceneInspection.Fault> touching(Avatar avatar, Course course) {
        Place start = encounter.start();
        double apart = Math.hypot(course.x(0) - start.x(), course.y(0) - start.y());
        double bodies = actor.walk().radius() + avatar.radius();
        return apart < bodies
                ? Optional.of(new SceneInspection.Fault(
                        String.format(
                                Locale.ROOT,
                                "avatar '%s' begins %.2f m from the actor, so they touch",
                                avatar.id(),
                                apart),
                        String.format(Locale.ROOT, "keep them %.2f m apart", bodies)))
                : Optional.empty();
    }

    private Optional<SceneInspection.Fault> barred(Avatar avatar, Course course) {
        double end = Math.min(course.end(), encounter.number(Encounter.Quantity.DURATION));
        for (int k = 0; k * EACH <= end + EACH; k++) {
            double time = Math.min(k * EACH, end);
            int cell = course.isThere(time) ? ways.frame().cellAt(course.x(time), course.y(time)) : -1;
            if (cell >= 0 && !ways.isFree(cell)) {
                return Optional.of(barred(avatar, time, Place.of(course.x(time), course.y(time))));
            }
        }
        return Optional.empty();
    }

    private SceneInspection.Fault barred(Avatar avatar, double time, Place place) {
        String where = String.format(Locale.ROOT, "(%.2f, %.2f)", place.x(), place.y());
        String what = scene.obstacles().stream()
                .filter(o -> o.offset() < actor.bodyHeight() && o.top() > actor.stepHeight())
                .filter(o -> o.outline().contains(place.x(), place.y()))
                .findFirst()
                .map(Obstacle::id)
                .map(id -> "obstacle '" + id + "'")
                .orElse("a place without floor or room");
        boolean stands = time == 0;
        return new SceneInspection.Fault(
                stands
                        ? "avatar '" + avatar.id() + "' begins inside " + what + ", at " + where
                        : String.format(
                                Locale.ROOT,
                                "avatar '%s' walks through %s, %.1f s after the start at %s",
                                avatar.id(),
                                what,
                                time,
                                where),
                "lead it round, or leave it if that is meant");
    }
}
