package troupe.scene.check;

import java.util.List;
import java.util.Locale;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Numbers;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.check.SceneChecks.Findings;

/** Checks journeys against the rest of the scene. */
final class JourneyRules {
    private JourneyRules() {}

    private static List<Journey> journeys(Scene scene) {
        return scene.tasks().stream()
                .filter(Journey.class::isInstance)
                .map(Journey.class::cast)
                .toList();
    }

    static void actors(Scene scene, Findings findings) {
        for (Journey journey : journeys(scene)) {
            if (scene.actor(journey.actor()).isEmpty()) {
                findings.error(
                        journey.id(),
                        "there is no actor '" + journey.actor() + "'",
                        scene.actors().isEmpty()
                                ? "add an actor"
                                : "name one of "
                                        + String.join(
                                                ", ",
                                                scene.actors().stream()
                                                        .map(Actor::id)
                                                        .toList()));
            }
            if (!journey.preferences().allows(Ability.WALK)) {
                findings.error(journey.id(), "walking is switched off", "give walk a factor; every actor walks");
            }
        }
    }

    static void costs(Scene scene, Findings findings) {
        for (Journey journey : journeys(scene)) {
            double spread = scene.actor(journey.actor())
                    .map(a -> journey.preferences().spread(a, scene.world().cell()))
                    .orElse(1.0);
            if (spread > Preferences.WIDEST) {
                findings.error(
                        journey.id(),
                        "the dearest step of '" + journey.actor() + "' costs "
                                + String.format(Locale.ROOT, "%.3g", spread) + " times the cheapest",
                        String.format(
                                Locale.ROOT,
                                "bring its energies and preferences within a factor of %.0e, or switch an ability off",
                                Preferences.WIDEST));
            }
        }
    }

    static void places(Scene scene, Findings findings) {
        for (Journey journey : journeys(scene)) {
            place(scene.world(), journey.id(), "the start", journey.start(), findings);
            place(scene.world(), journey.id(), "the goal", journey.goal(), findings);
        }
    }

    static void place(World world, String id, String what, Place place, Findings findings) {
        boolean finite = Double.isFinite(place.x())
                && Double.isFinite(place.y())
                && Double.isFinite(place.z().orElse(0));
        if (!finite) {
            findings.error(id, what + " is not finite", "give it finite numbers");
        } else if (place.x() < 0 || place.y() < 0 || place.x() > world.width() || place.y() > world.depth()) {
            findings.error(id, what + " " + Numbers.text(place) + " lies outside the world", "move it inside");
        }
    }

    static void budgets(Scene scene, Findings findings) {
        for (Journey journey : journeys(scene)) {
            if (journey.slice() < 1) {
                findings.error(journey.id(), "slice is " + journey.slice(), "give a whole number from 1");
            }
            if (journey.headings() < 1 || journey.headings() > Journey.MOST_HEADINGS) {
                findings.error(
                        journey.id(),
                        "headings is " + journey.headings(),
                        "give a whole number from 1 to " + Journey.MOST_HEADINGS);
            }
            if (journey.expansions() < 1) {
                findings.error(journey.id(), "expansions is " + journey.expansions(), "give a whole number from 1");
            }
            if (journey.spaces() < 1) {
                findings.error(journey.id(), "spaces is " + journey.spaces(), "give a whole number from 1");
            }
        }
    }
}
