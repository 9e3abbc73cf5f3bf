package troupe.scene.check;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Element;
import troupe.scene.Numbers;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.check.SceneChecks.Findings;

/** Checks crowds against the rest of the scene. */
final class CrowdRules {
    /** The most agents of a crowd; a frame of so many fits into a run. */
    static final int MOST_AGENTS = 100_000;

    /** The most groups that have members, so that the table of their relations stays small. */
    static final int MOST_GROUPS = 4_000;

    private CrowdRules() {}

    private static List<Crowd> crowds(Scene scene) {
        return scene.tasks().stream()
                .filter(Crowd.class::isInstance)
                .map(Crowd.class::cast)
                .toList();
    }

    static void trees(Scene scene, Findings findings) {
        for (Crowd crowd : crowds(scene)) {
            Set<String> ids = new HashSet<>(scene.elements().map(Element::id).toList());
            crowd.allGroups().forEach(g -> {
                if (!ids.add(g.id())) {
                    findings.error(g.id(), "the id is used twice", "rename one of the two");
                }
                DocumentRules.idForm(g.id(), findings);
                DocumentRules.text(g.id(), "the label", g.label(), findings);
                DocumentRules.colour(g.id(), g.colour(), findings);
                if (g.members().isPresent() == !g.parts().isEmpty()) {
                    findings.error(
                            g.id(),
                            g.parts().isEmpty()
                                    ? "the group has neither members nor parts"
                                    : "the group has members and parts",
                            "give it either a count and a spawn outline, or groups inside it");
                }
            });
            crowd.groups().forEach(g -> goals(g, false, findings));
            long agents = crowd.allGroups()
                    .mapToLong(g -> g.members().map(CrowdGroup.Members::count).orElse(0))
                    .sum();
            long leaves = crowd.allGroups().filter(g -> g.members().isPresent()).count();
            if (agents < 1 || agents > MOST_AGENTS) {
                findings.error(crowd.id(), "the crowd has " + agents + " agents", "needs 1 to " + MOST_AGENTS);
            }
            if (leaves > MOST_GROUPS) {
                findings.error(crowd.id(), leaves + " groups have members", "needs at most " + MOST_GROUPS);
            }
        }
    }

    private static void goals(CrowdGroup group, boolean above, Findings findings) {
        boolean known = above || group.goal().isPresent();
        if (group.members().isPresent() && !known) {
            findings.error(group.id(), "the group has no goal", "give it, or a group above it, a goal");
        }
        group.parts().forEach(part -> goals(part, known, findings));
    }

    static void numbers(Scene scene, Findings findings) {
        for (Crowd crowd : crowds(scene)) {
            Crowd.Manner m = crowd.manner();
            within(crowd.id(), "view", m.view(), Crowd.Manner.LEAST_VIEW, Crowd.Manner.MOST_VIEW, findings);
            findings.number(crowd.id(), "bodyHeight", m.bodyHeight(), 0, false);
            findings.number(crowd.id(), "stepHeight", m.stepHeight(), 0, true);
            if (m.bodyHeight() <= 2 * m.stepHeight()) {
                findings.error(
                        crowd.id(), "a body is not taller than two steps", "lower stepHeight, or raise bodyHeight");
            }
            within(crowd.id(), "seconds", crowd.seconds(), Crowd.STEP_SECONDS, 36_000, findings);
            Crowd.Weights w = crowd.weights();
            weight(crowd.id(), "weights separation", w.separation(), findings);
            weight(crowd.id(), "weights cohesion", w.cohesion(), findings);
            weight(crowd.id(), "weights alignment", w.alignment(), findings);
            weight(crowd.id(), "weights path", w.path(), findings);
            weight(crowd.id(), "weights anticipation", w.anticipation(), findings);
            for (Crowd.Relation r : crowd.relations()) {
                String name = "relation " + r.depth() + " ";
                if (r.depth() < 0 || r.depth() > crowd.deepest()) {
                    findings.error(crowd.id(), name + "has no groups", "give a depth from 0 to " + crowd.deepest());
                }
                weight(crowd.id(), name + "cohesion", r.cohesion(), findings);
                weight(crowd.id(), name + "alignment", r.alignment(), findings);
                weight(crowd.id(), name + "separation", r.separation(), findings);
            }
            crowd.allGroups().forEach(g -> members(scene.world(), g, findings));
        }
    }

    private static void members(World world, CrowdGroup group, Findings findings) {
        group.goal().ifPresent(goal -> JourneyRules.place(world, group.id(), "the goal", goal, findings));
        if (group.members().isEmpty()) {
            return;
        }
        CrowdGroup.Members m = group.members().get();
        if (m.count() < 1 || m.count() > MOST_AGENTS) {
            findings.error(group.id(), "count is " + m.count(), "give a whole number from 1 to " + MOST_AGENTS);
        }
        within(group.id(), "radius", m.radius(), world.cell(), 5, findings);
        within(group.id(), "speed", m.speed(), 0.01, world.cell() / Crowd.STEP_SECONDS, findings);
        if (m.floor().isPresent()) {
            within(group.id(), "floor", m.floor().getAsDouble(), -SceneChecks.LARGEST, SceneChecks.LARGEST, findings);
        }
        if (m.spawn().size() < 3 || !(Math.abs(m.spawn().signedArea()) > 0)) {
            findings.error(group.id(), "the spawn outline has no area", "draw it round some ground");
        }
    }

    private static void weight(String id, String name, double value, Findings findings) {
        within(id, name, value, 0, Crowd.Weights.MOST, findings);
    }

    private static void within(String id, String name, double value, double least, double most, Findings findings) {
        if (!(value >= least && value <= most)) {
            findings.error(
                    id,
                    name + " is " + Numbers.text(value),
                    "give a number from " + Numbers.text(least) + " to " + Numbers.text(most));
        }
    }
}
