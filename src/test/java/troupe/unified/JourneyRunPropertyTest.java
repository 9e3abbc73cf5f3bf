package troupe.unified;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.region.RandomScenes;
import troupe.grid.region.Region;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.motion.Motion;
import troupe.unified.search.JourneyPath;
import troupe.unified.search.Ways;

/** Plans random journeys among walls, low walls, plates, beams and ditches, and replays every frame on the polygons. */
class JourneyRunPropertyTest {
    private static final long SEED = Long.getLong("seed", 88);
    private static final int SCENES = 250;

    private final Actor actor = lightFooted();

    /** Makes an actor for whom crossings are so cheap that it makes many. */
    private static Actor lightFooted() {
        Actor a = Actor.standard("ann");
        return new Actor(
                a.id(),
                a.label(),
                a.colour(),
                a.bodyHeight(),
                a.footRadius(),
                a.stepHeight(),
                a.maxBorder(),
                a.walk(),
                a.sidestep(),
                Optional.of(new Actor.Stride(0.9, 1, 1, 0.05, 1.5)),
                Optional.of(new Actor.Vault(0.4, 1.1, 1.4, 1.2, 1.54, 1, 0.05, 1)),
                Optional.empty());
    }

    private Scene scene(Random random) {
        List<Obstacle> obstacles = new ArrayList<>();
        List<Ditch> ditches = new ArrayList<>();
        for (int i = 0; i < 3 + random.nextInt(9); i++) {
            Polygon outline = outline(random);
            double offset = random.nextInt(5) == 0 ? 1.2 + random.nextDouble() : 0;
            double height =
                    switch (random.nextInt(4)) {
                        case 0 -> 0.15 + 0.1 * random.nextDouble();
                        case 1, 2 -> 0.4 + 0.7 * random.nextDouble();
                        default -> 2.5;
                    };
            obstacles.add(new Obstacle("o" + i, "", outline, offset, height, random.nextInt(4) == 0, 20, ""));
        }
        for (int i = 0; i < random.nextInt(3); i++) {
            ditches.add(new Ditch("d" + i, "", outline(random), random.nextInt(3) == 0 ? 0.2 : 1.5));
        }
        Journey journey = Journey.of("j", "ann", place(random), place(random));
        return new Scene("", new World(6, 6, 0.1), obstacles, ditches, List.of(actor), List.of(journey));
    }

    /** Makes a thin or thick quadrilateral somewhere, turned as it comes. */
    private static Polygon outline(Random random) {
        double x = random.nextDouble() * 6;
        double y = random.nextDouble() * 6;
        double length = 0.3 + random.nextDouble() * 2.5;
        double width = 0.05 + random.nextDouble() * (random.nextBoolean() ? 0.3 : 1.2);
        double angle = random.nextInt(3) == 0 ? random.nextDouble() * 3 : random.nextInt(2) * Math.PI / 2;
        double[] xs = new double[4];
        double[] ys = new double[4];
        for (int i = 0; i < 4; i++) {
            double u = i == 1 || i == 2 ? length / 2 : -length / 2;
            double v = i >= 2 ? width / 2 : -width / 2;
            xs[i] = Math.max(0, Math.min(6, x + u * Math.cos(angle) - v * Math.sin(angle)));
            ys[i] = Math.max(0, Math.min(6, y + u * Math.sin(angle) + v * Math.cos(angle)));
        }
        return new Polygon(xs, ys);
    }

    private static Place place(Random random) {
        return Place.of(0.4 + random.nextDouble() * 5.2, 0.4 + random.nextDouble() * 5.2);
    }

    private static Place place(Region region, Random random) {
        int q = random.nextInt(region.spanCount());
        while (!region.open(q)) {
            q = random.nextInt(region.spanCount());
        }
        return Place.of(region.x(q), region.y(q), region.elevation(q));
    }

    @Test
    void actorsOfAllSortsGetUpAndDownLayeredScenesUnharmed() {
        int solved = 0;
        int climbed = 0;
        for (int i = 0; i < SCENES; i++) {
            String which = "layered scene " + i;
            Actor someone = RandomScenes.actor(SEED * 1000 + i);
            Scene bare = RandomScenes.layered(SEED * 1000 + i, 8, 0.1);
            Region region = Region.of(bare, someone);
            Random random = new Random(SEED * 1000 + i);
            Journey journey = Journey.of("j", someone.id(), place(region, random), place(region, random));
            Scene scene =
                    new Scene("", bare.world(), bare.obstacles(), bare.ditches(), List.of(someone), List.of(journey));
            JourneyEngine engine = JourneyEngine.of(scene, journey);
            Run run = engine.finish();
            if (run.outcome().isFound()) {
                solved++;
                climbed += run.frames().value(0, 2, 0)
                                != run.frames().value(run.frames().count() - 1, 2, 0)
                        ? 1
                        : 0;
                RunCheck.assertCollisionFree(run, someone, which);
                assertMoves(run.frames(), which);
                assertAddsUp(run, engine.path().orElseThrow(), region, which);
            }
        }
        assertTrue(solved > SCENES / 3, solved + " of " + SCENES);
        assertTrue(climbed > 5, climbed + " end on another floor");
    }

    @Test
    void everyFrameIsFreeAndWhatIsReportedAddsUp() {
        TreeMap<String, Integer> used = new TreeMap<>();
        int solved = 0;
        for (int i = 0; i < SCENES; i++) {
            String which = "seed " + SEED + ", scene " + i;
            Scene scene = scene(new Random(SEED * 1000 + i));
            JourneyEngine engine =
                    JourneyEngine.of(scene, (Journey) scene.tasks().get(0));
            Run run = engine.finish();
            if (run.outcome().isFound()) {
                solved++;
                run.legs().forEach(leg -> used.merge(leg.ability(), 1, Integer::sum));
                RunCheck.assertCollisionFree(run, actor, which);
                assertMoves(run.frames(), which);
                assertAddsUp(run, engine.path().orElseThrow(), engine.region().orElseThrow(), which);
            }
        }
        assertTrue(solved > SCENES / 3, solved + " of " + SCENES);
        assertEquals(List.of("sidestep", "stride", "vault", "walk"), List.copyOf(used.keySet()), used.toString());
    }

    private static void assertMoves(Frames frames, String which) {
        for (int f = 1; f < frames.count(); f++) {
            double way = Math.hypot(
                    frames.value(f, 0, 0) - frames.value(f - 1, 0, 0),
                    frames.value(f, 1, 0) - frames.value(f - 1, 1, 0));
            double turn = Math.abs(Motion.wrapped(frames.value(f, 3, 0) - frames.value(f - 1, 3, 0)));
            assertTrue(way <= 1.5 / 25 + 1e-9, which + ", frame " + f + " leaps " + way);
            assertTrue(turn <= 2 * Math.PI / 25 + 1e-9, which + ", frame " + f + " spins " + turn);
        }
    }

    private static void assertAddsUp(Run run, JourneyPath path, Region region, String which) {
        double energy = run.legs().stream().mapToDouble(Run.Leg::energy).sum();
        assertEquals(path.energy(), energy, 1e-6, which);
        double smoothed = (double) run.report().values().get("smoothed_length");
        assertTrue(smoothed <= 1.02 * path.length() + 1e-9, which + ": smoothed " + smoothed + " of " + path.length());
        GridFrame frame = region.frame();
        int goal = Ways.configurations(path)[Ways.steps(path)];
        int last = run.frames().count() - 1;
        assertEquals(frame.centreX(frame.col(region.cell(goal))), run.frames().value(last, 0, 0), 0, which);
        assertEquals(region.elevation(goal), run.frames().value(last, 2, 0), 0, which);
        for (int i = 1; i < run.legs().size(); i++) {
            assertEquals(run.legs().get(i - 1).end(), run.legs().get(i).begin(), 0, which);
        }
    }
}
