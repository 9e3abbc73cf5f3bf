package troupe.work.explain;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.FrameRecorder;
import troupe.scene.Ability;
import troupe.scene.Obstacle;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.search.Outcome;

/** Compares corners found by planning with those of a walk along all crossings of random lines. */
class CostLinesOracleTest {
    private static final Scene EMPTY =
            new Scene("", new World(1, 1, 0.1), List.<Obstacle>of(), List.of(), List.of(), List.of());

    private static Route line(double walk, double vault, String what) {
        Report energy = Report.builder().put("walk", walk).put("vault", vault).build();
        List<Run.Leg> legs = new ArrayList<>();
        legs.add(new Run.Leg("ann", "walk", "", 0, 1, walk, List.of()));
        if (vault > 0) {
            legs.add(new Run.Leg("ann", "vault", what, 1, 2, vault, List.of()));
        }
        Report report = Report.builder().put("energy_by_ability", energy).build();
        return new Route(
                Set.of(),
                new Run(EMPTY, "t", Outcome.FOUND, report, new FrameRecorder(25, List.of()).frames(), legs, List.of()));
    }

    private static Route least(List<Route> lines, double preference) {
        Preferences there = Preferences.NEUTRAL.with(Ability.VAULT, preference);
        Route best = lines.get(0);
        for (Route line : lines) {
            if (line.cost(there) < best.cost(there)) {
                best = line;
            }
        }
        return best;
    }

    /** Returns every corner of the lower envelope right of 1, left to right, found by looking at all pairs. */
    private static List<Flip> corners(List<Route> lines, double most) {
        List<Flip> corners = new ArrayList<>();
        double at = 1;
        Route now = least(lines, 1);
        while (true) {
            Route next = null;
            double nearest = most;
            for (Route line : lines) {
                double slope = now.energy(Ability.VAULT) - line.energy(Ability.VAULT);
                double cross = (line.energy(Ability.WALK) - now.energy(Ability.WALK)) / slope;
                if (slope > 0 && cross >= at && cross < nearest) {
                    nearest = cross;
                    next = line;
                }
            }
            if (next == null) {
                return corners;
            }
            corners.add(new Flip(Ability.VAULT, nearest, nearest, now, next));
            at = nearest;
            now = next;
        }
    }

    @Test
    void findsTheCornersOfRandomLines() {
        long seed = Long.getLong("troupe.seed", 11);
        Random random = new Random(seed);
        int several = 0;
        for (int round = 0; round < 2_000; round++) {
            String name = "troupe.seed=" + seed + ", round " + round;
            List<Route> lines = new ArrayList<>();
            double slack = 0.2 + random.nextDouble();
            lines.add(line(10 + 10 * random.nextDouble(), 0, ""));
            for (int i = random.nextInt(12); i >= 0; i--) {
                double vault = 0.05 + 3 * random.nextDouble();
                lines.add(line(1 + slack * random.nextDouble() + 6 / (0.5 + vault), vault, "" + random.nextInt(3)));
            }
            double most = 500;
            List<Flip> corners = corners(lines, most);
            several += corners.size() > 2 ? 1 : 0;
            Route left = least(lines, 1);
            Route right = lines.get(0);
            CostLines search = new CostLines(Ability.VAULT, Preferences.NEUTRAL, most, p -> least(lines, p));
            Optional<Flip> last = corners.isEmpty() ? Optional.empty() : Optional.of(corners.get(corners.size() - 1));
            assertSame(last, search.last(left, right), name);
            Optional<Flip> first = corners.stream()
                    .filter(f -> !f.above().course().equals(left.course()))
                    .findFirst();
            assertSame(first, search.first(left, right), name);
        }
        assertEquals(true, several > 200, "only " + several + " rounds with three corners or more");
    }

    private static void assertSame(Optional<Flip> expected, Optional<Flip> found, String name) {
        assertEquals(expected.isPresent(), found.isPresent(), name);
        if (expected.isPresent()) {
            assertEquals(expected.get().preference(), found.get().preference(), 1e-6, name);
            assertEquals(expected.get().below(), found.get().below(), name);
            assertEquals(expected.get().above(), found.get().above(), name);
        }
    }
}
