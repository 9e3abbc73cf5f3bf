package troupe.scene.check;

import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Numbers;
import troupe.scene.Scene;
import troupe.scene.check.SceneChecks.Findings;
import troupe.scene.setting.ActorForm;

/** Checks the numbers of actors, alone and against each other. */
final class ActorRules {
    /** The longest stride or vault in metres; no body is near it, and the work of finding crossings grows with it. */
    private static final double LONGEST = 10;

    /** The longest stride or vault in cells. */
    private static final double MOST_CELLS = 1_000;

    /** The lowest speed in m/s; a slower way through a small room would take more frames than a run can hold. */
    private static final double SLOWEST = 0.01;

    private ActorRules() {}

    static void crossings(Scene scene, Findings findings) {
        double most = Math.min(LONGEST, MOST_CELLS * scene.world().cell());
        for (Actor actor : scene.actors()) {
            actor.stride().ifPresent(s -> crossing(findings, actor.id(), "stride.gait", s.gait(), most));
            actor.vault().ifPresent(v -> crossing(findings, actor.id(), "vault.reach", v.reach(), most));
        }
    }

    private static void crossing(Findings findings, String id, String name, double length, double most) {
        if (length > most) {
            findings.error(
                    id,
                    name + " " + Numbers.text(length) + " is above " + Numbers.text(most),
                    "lower it; at most " + Numbers.text(LONGEST) + " m and " + Numbers.text(MOST_CELLS) + " cells");
        }
    }

    static void numbers(Scene scene, Findings findings) {
        for (Actor actor : scene.actors()) {
            ActorForm form = ActorForm.of(actor);
            for (String name : ActorForm.BODY) {
                findings.number(actor.id(), name, form.body(name), 0, !name.equals("bodyHeight"));
            }
            for (Ability ability : form.abilities()) {
                for (String name : ActorForm.names(ability)) {
                    double least = name.equals("speed") ? SLOWEST : 0;
                    boolean orEqual = least > 0 || mayBeZero(name);
                    findings.number(actor.id(), ability.key() + "." + name, form.number(ability, name), least, orEqual);
                }
            }
        }
    }

    private static boolean mayBeZero(String name) {
        return name.equals("radius") || name.equals("takeOff") || name.equals("turnEnergy");
    }

    static void relations(Scene scene, Findings findings) {
        for (Actor actor : scene.actors()) {
            String id = actor.id();
            atMost(
                    findings,
                    id,
                    "footRadius",
                    actor.footRadius(),
                    "walk.radius",
                    actor.walk().radius());
            actor.sidestep().ifPresent(s -> {
                atMost(findings, id, "footRadius", actor.footRadius(), "sidestep.radius", s.radius());
                atMost(
                        findings,
                        id,
                        "sidestep.radius",
                        s.radius(),
                        "walk.radius",
                        actor.walk().radius());
            });
            twiceTheStep(findings, id, "bodyHeight", actor.bodyHeight(), actor.stepHeight());
            actor.vault().ifPresent(v -> {
                twiceTheStep(findings, id, "vault.bodyHeight", v.bodyHeight(), actor.stepHeight());
                atMost(findings, id, "vault.minHeight", v.minHeight(), "vault.maxHeight", v.maxHeight());
                if (v.minHeight() <= actor.stepHeight()) {
                    findings.error(
                            id,
                            "vault.minHeight " + Numbers.text(v.minHeight()) + " is not above stepHeight "
                                    + Numbers.text(actor.stepHeight()),
                            "what can be stepped on need not be vaulted: raise vault.minHeight");
                }
            });
        }
    }

    private static void atMost(Findings findings, String id, String small, double a, String large, double b) {
        if (a > b) {
            findings.error(
                    id,
                    small + " " + Numbers.text(a) + " is above " + large + " " + Numbers.text(b),
                    "lower " + small + " or raise " + large);
        }
    }

    private static void twiceTheStep(Findings findings, String id, String name, double height, double step) {
        if (height <= 2 * step) {
            findings.error(
                    id,
                    name + " " + Numbers.text(height) + " is not above twice stepHeight " + Numbers.text(step),
                    "raise " + name + " or lower stepHeight");
        }
    }
}
