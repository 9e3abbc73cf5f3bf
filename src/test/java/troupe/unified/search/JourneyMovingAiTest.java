package troupe.unified.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import troupe.SharedData;
import troupe.exchange.scenario.MovingAiMap;
import troupe.exchange.scenario.MovingAiProblems;
import troupe.grid.region.Region;
import troupe.scene.Preferences;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.cost.JourneyQuery;

/**
 * Compares lengths with the published ones on real grid maps: a sample spread over all problems, easy to
 * hard, on one workspace. {@link MovingAiComparison} does all of them.
 */
class JourneyMovingAiTest {
    private static final int SAMPLE = 40;

    @ParameterizedTest
    @CsvSource({
        "arena2, 1e-5, 0",
        "AR0072SR, 0, 0.01",
        "ht_chantry, 1e-5, 0",
        "32room_000, 1e-5, 0",
        "maze512-32-0, 0, 0.01",
        "Berlin_0_256, 1e-5, 0"
    })
    void lengthsEqualThePublishedOnes(String name, double relative, double absolute) throws Exception {
        Path file = SharedData.require("movingai/" + name + ".map");
        MovingAiMap map = MovingAiMap.read(file);
        List<MovingAiProblems.Problem> problems = MovingAiProblems.read(Path.of(file + ".scen"));
        Region region = Region.of(map.scene(), map.scene().actors().get(0));
        JourneyCosts costs = new JourneyCosts(
                region.actor(), Preferences.NEUTRAL, region.frame().cell());
        JourneyWorkspace work = new JourneyWorkspace(region);
        for (int i = SAMPLE; i >= 1; i--) {
            MovingAiProblems.Problem problem = problems.get(i * problems.size() / SAMPLE - 1);
            int start = region.locate(problem.start());
            int goal = region.locate(problem.goal());
            JourneySearch search = new JourneySearch(work, costs, JourneyQuery.optimal(start, goal));
            search.step(Long.MAX_VALUE);
            JourneyPath path = search.path().orElseThrow();
            double tolerance = relative * problem.length() + absolute;
            assertEquals(problem.length(), path.length(), tolerance, problem::toString);
            assertEquals(path.length(), path.cost(), 1e-9);
            assertTrue(
                    search.expanded() <= Ways.steps(path) + 1 + Ways.steps(path) / 10,
                    () -> "expanded " + search.expanded() + " labels for " + Ways.steps(path) + " steps of " + problem);
        }
    }
}
