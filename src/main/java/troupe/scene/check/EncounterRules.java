package troupe.scene.check;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Element;
import troupe.scene.Encounter;
import troupe.scene.Numbers;
import troupe.scene.Scene;
import troupe.scene.check.SceneChecks.Findings;

/** Checks encounters against the rest of the scene. */
final class EncounterRules {
    private EncounterRules() {}

    private static List<Encounter> encounters(Scene scene) {
        return scene.tasks().stream()
                .filter(Encounter.class::isInstance)
                .map(Encounter.class::cast)
                .toList();
    }

    static void actors(Scene scene, Findings findings) {
        for (Encounter e : encounters(scene)) {
            if (scene.actor(e.actor()).isEmpty()) {
                String known = scene.actors().stream().map(Actor::id).collect(Collectors.joining(", "));
                findings.error(
                        e.id(),
                        "there is no actor '" + e.actor() + "'",
                        known.isEmpty() ? "add an actor" : "name one of " + known);
            }
        }
    }

    static void places(Scene scene, Findings findings) {
        for (Encounter e : encounters(scene)) {
            JourneyRules.place(scene.world(), e.id(), "the start", e.start(), findings);
            JourneyRules.place(scene.world(), e.id(), "the goal", e.goal(), findings);
        }
    }

    static void numbers(Scene scene, Findings findings) {
        for (Encounter e : encounters(scene)) {
            for (Encounter.Quantity quantity : Encounter.Quantity.values()) {
                if (!quantity.takes(e.number(quantity))) {
                    findings.error(
                            e.id(),
                            quantity.key() + " is " + Numbers.text(e.number(quantity)),
                            "give " + quantity.range());
                }
            }
        }
    }

    static void avatars(Scene scene, Findings findings) {
        for (Encounter e : encounters(scene)) {
            Set<String> seen = scene.elements().map(Element::id).collect(Collectors.toCollection(HashSet::new));
            for (Avatar avatar : e.avatars()) {
                String who = "avatar '" + avatar.id() + "'";
                if (!DocumentRules.isId(avatar.id())) {
                    findings.error(
                            e.id(), who + ": the id is not allowed", "use a letter or _, then letters, digits, . _ -");
                }
                if (!seen.add(avatar.id())) {
                    findings.error(e.id(), who + ": the id is used twice", "rename one of the two");
                }
                DocumentRules.text(e.id(), who + ": the label", avatar.label(), findings);
                DocumentRules.colour(e.id(), avatar.colour(), findings);
                findings.number(e.id(), who + ": radius", avatar.radius(), 0, false);
                findings.number(e.id(), who + ": speed", avatar.speed(), 0, false);
                findings.number(e.id(), who + ": mobility", avatar.mobility(), 0, true);
                motion(scene, e, avatar, findings);
            }
        }
    }

    private static void motion(Scene scene, Encounter e, Avatar avatar, Findings findings) {
        String who = "avatar '" + avatar.id() + "'";
        if (avatar.motion() instanceof Avatar.Pointer pointer) {
            JourneyRules.place(scene.world(), e.id(), who + ": the start", pointer.start(), findings);
        } else if (avatar.motion() instanceof Avatar.Script script) {
            JourneyRules.place(scene.world(), e.id(), who + ": the start", script.start(), findings);
            findings.number(e.id(), who + ": pace", script.pace(), 0, false);
            double last = 0;
            for (Avatar.Head head : script.heads()) {
                JourneyRules.place(scene.world(), e.id(), who + ": a goal", head.to(), findings);
                double at = head.at().orElse(last);
                if (!(at >= last && at <= SceneChecks.LARGEST)) {
                    findings.error(
                            e.id(),
                            who + ": a goal at " + Numbers.text(at) + " s comes after one at " + Numbers.text(last)
                                    + " s",
                            "give times from 0 that do not fall");
                    return;
                }
                last = at;
            }
        } else if (avatar.motion() instanceof Avatar.Recording recording) {
            recording(e, avatar, recording, findings);
        }
    }

    private static void recording(Encounter e, Avatar avatar, Avatar.Recording recording, Findings findings) {
        String who = "avatar '" + avatar.id() + "'";
        if (recording.fixes().isEmpty()) {
            findings.error(e.id(), who + " has neither a start nor a track", "give it one of them");
        }
        double last = Double.NEGATIVE_INFINITY;
        for (Avatar.Fix fix : recording.fixes()) {
            boolean fine = fix.time() > last
                    && Math.abs(fix.time()) <= SceneChecks.LARGEST
                    && Math.abs(fix.x()) <= SceneChecks.LARGEST
                    && Math.abs(fix.y()) <= SceneChecks.LARGEST;
            if (!fine) {
                findings.error(
                        e.id(),
                        who + ": the position " + Numbers.text(fix.time()) + "," + Numbers.text(fix.x()) + ","
                                + Numbers.text(fix.y()) + " is not finite, or not later than the one before",
                        "give t,x,y in the order of time");
                return;
            }
            last = fix.time();
        }
    }
}
