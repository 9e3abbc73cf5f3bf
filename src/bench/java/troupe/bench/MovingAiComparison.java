package troupe.bench;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import troupe.exchange.scenario.MovingAiMap;
import troupe.exchange.scenario.MovingAiProblems;
import troupe.grid.region.Region;
import troupe.scene.Actor;
import troupe.scene.Preferences;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.cost.JourneyQuery;
import troupe.unified.search.JourneySearch;
import troupe.unified.search.JourneyWorkspace;
import troupe.unified.search.PlainAStar;

/**
 * Times the planner on the longest problems of grid maps against {@link PlainAStar} in the same process,
 * and checks every length against it. Run with the paths of {@code .map} files; each has its {@code .map.scen} beside
 * it. Prints a line for each map: median microseconds of both and their ratio, and median expansions.
 */
final class MovingAiComparison {
    private static final int PROBLEMS = 100;
    private static final int ROUNDS = 12;

    private MovingAiComparison() {}

    public static void main(String[] arguments) throws Exception {
        for (String name : arguments) {
            MovingAiMap map = MovingAiMap.read(Path.of(name));
            List<MovingAiProblems.Problem> problems = MovingAiProblems.read(Path.of(name + ".scen"));
            long begin = System.nanoTime();
            Region region = Region.of(map.scene(), Actor.walker("walker", 0, 0));
            double millis = (System.nanoTime() - begin) / 1e6;
            System.out.printf(Locale.ROOT, "%s: region in %.1f ms%n", map.name(), millis);
            compare(region, problems);
        }
    }

    private static void compare(Region region, List<MovingAiProblems.Problem> problems) {
        List<MovingAiProblems.Problem> longest = problems.stream()
                .sorted(Comparator.comparingDouble(MovingAiProblems.Problem::length)
                        .reversed())
                .limit(PROBLEMS)
                .toList();
        boolean[] free = new boolean[region.frame().size()];
        for (int cell = 0; cell < free.length; cell++) {
            free[cell] = region.open(cell) && region.elevation(cell) == 0;
        }
        PlainAStar plain = new PlainAStar(free, region.frame().cols());
        JourneyWorkspace work = new JourneyWorkspace(region);
        JourneyCosts costs = new JourneyCosts(
                region.actor(), Preferences.NEUTRAL, region.frame().cell());
        double[] ours = new double[longest.size()];
        double[] theirs = new double[longest.size()];
        Arrays.fill(ours, Double.MAX_VALUE);
        Arrays.fill(theirs, Double.MAX_VALUE);
        long[] expanded = new long[3];
        for (int round = 0; round < ROUNDS; round++) {
            Arrays.fill(expanded, 0);
            for (int i = 0; i < longest.size(); i++) {
                int start = region.locate(longest.get(i).start());
                int goal = region.locate(longest.get(i).goal());
                long begin = System.nanoTime();
                JourneySearch search = new JourneySearch(work, costs, JourneyQuery.optimal(start, goal));
                search.step(Long.MAX_VALUE);
                double length = search.path().orElseThrow().length();
                long middle = System.nanoTime();
                double check = plain.length(start, goal);
                long end = System.nanoTime();
                ours[i] = Math.min(ours[i], (middle - begin) / 1e3);
                theirs[i] = Math.min(theirs[i], (end - middle) / 1e3);
                expanded[0] += search.expanded();
                expanded[1] += search.estimated();
                expanded[2] += plain.expanded();
                if (Math.abs(length - check) > 1e-6) {
                    System.out.println("  differs: " + longest.get(i) + " " + length + " " + check);
                }
            }
        }
        double a = median(ours);
        double b = median(theirs);
        System.out.printf(
                Locale.ROOT,
                "  planner %.0f us, plain %.0f us, ratio %.2f; mean labels %d, cost-to-go %d, plain %d%n",
                a,
                b,
                a / b,
                expanded[0] / longest.size(),
                expanded[1] / longest.size(),
                expanded[2] / longest.size());
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }
}
