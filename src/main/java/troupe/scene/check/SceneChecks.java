package troupe.scene.check;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import troupe.scene.Numbers;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Finds everything that is wrong with a scene, all at once. What needs the grid (a start inside an
 * obstacle, a goal that no layer carries) is checked in {@code work}.
 */
public final class SceneChecks {
    /** The largest length, mass or energy of a scene: beyond it doubles no longer tell nanometres apart. */
    public static final double LARGEST = 1e6;

    /** Every rule, in the order in which equally bad problems are reported. */
    private static final List<BiConsumer<Scene, Findings>> RULES = List.of(
            DocumentRules::ids,
            DocumentRules::texts,
            DocumentRules::world,
            ShapeRules::outlines,
            ShapeRules::stretches,
            ActorRules::numbers,
            ActorRules::relations,
            JourneyRules::actors,
            JourneyRules::places,
            JourneyRules::budgets,
            EncounterRules::actors,
            EncounterRules::places,
            EncounterRules::numbers,
            EncounterRules::avatars,
            CrowdRules::trees,
            CrowdRules::numbers,
            ShapeRules::overlaps,
            ShapeRules::carrying);

    /** The rules that count cells or steps: of a world that has no grid they would only tell the same again. */
    private static final List<BiConsumer<Scene, Findings>> GRID_RULES =
            List.of(DocumentRules::memory, ActorRules::crossings, JourneyRules::costs);

    private SceneChecks() {}

    /** Returns the problems of a scene that has no file, worst first; empty if there are none. */
    public static List<Problem> check(Scene scene) {
        return check(scene, Map.of());
    }

    /** Returns the problems of a scene, worst first and then by line, with the lines at which the elements begin. */
    public static List<Problem> check(Scene scene, Map<String, Integer> lines) {
        Findings findings = new Findings(lines);
        RULES.forEach(rule -> rule.accept(scene, findings));
        World world = scene.world();
        if (sized(world.width()) && sized(world.depth()) && sized(world.cell())) {
            GRID_RULES.forEach(rule -> rule.accept(scene, findings));
        }
        return findings.problems.stream()
                .sorted(Comparator.comparing(Problem::severity).thenComparingInt(Problem::line))
                .toList();
    }

    private static boolean sized(double length) {
        return length > 0 && length <= LARGEST;
    }

    /** Collects what the rules find. */
    static final class Findings {
        private final Map<String, Integer> lines;
        private final List<Problem> problems = new ArrayList<>();

        private Findings(Map<String, Integer> lines) {
            this.lines = lines;
        }

        void error(String element, String message, String cure) {
            add(Severity.ERROR, element, message, cure);
        }

        void warning(String element, String message, String cure) {
            add(Severity.WARNING, element, message, cure);
        }

        private void add(Severity severity, String element, String message, String cure) {
            problems.add(new Problem(severity, element, lines.getOrDefault(element, 0), message, cure));
        }

        /**
         * Reports a number that is not finite, not above {@code least} (or not at least, if {@code orEqual}), or
         * above {@link #LARGEST}; tells whether it is fine.
         */
        boolean number(String element, String name, double value, double least, boolean orEqual) {
            boolean fine = value <= LARGEST && (orEqual ? value >= least : value > least);
            if (!fine) {
                error(
                        element,
                        name + " is " + Numbers.text(value),
                        "give a number " + (orEqual ? "from " : "above ") + Numbers.text(least) + " to "
                                + Numbers.text(LARGEST));
            }
            return fine;
        }
    }
}
