package troupe.unified.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.region.RandomScenes;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.grid.region.ground.Kind;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Scene;

/** Compares the regions of search spaces, patched from one another, with {@link Space}, built whole each time. */
class SpaceOracleTest {
    private static final long FIRST_SEED = Long.getLong("troupe.seed", 1);

    @Test
    void regionsHoldTheSameConfigurationsAndStepsWhateverHasBeenMoved() {
        AtomicInteger crossings = new AtomicInteger();
        LongStream.range(FIRST_SEED, FIRST_SEED + 150).parallel().forEach(seed -> {
            boolean layered = seed % 5 == 0;
            Scene scene = layered
                    ? RandomScenes.layered(seed, 3.5, 0.25)
                    : MovingWorlds.scene(seed, Journey.Manipulation.FREE);
            Actor actor = layered ? RandomScenes.actor(seed) : scene.actors().get(0);
            Ground ground = new Ground(scene, actor);
            RegionBuilder builder = new RegionBuilder(scene, actor);
            Region region = builder.region();
            Polygon[] outlines = scene.obstacles().stream()
                    .map(o -> o.movable() ? o.outline() : null)
                    .toArray(Polygon[]::new);
            Polygon[] base = outlines;
            crossings.addAndGet(compare("seed " + seed, region, new Space(ground, outlines)));
            Random random = new Random(seed);
            for (int change = 0; change < 4 && outlines.length > 0; change++) {
                int n = random.nextInt(outlines.length);
                if (scene.obstacles().get(n).movable()) {
                    Mover mover = new Mover(ground, n, base, 5);
                    Mover.Pose pose = new Mover.Pose(random.nextInt(9) - 4, random.nextInt(9) - 4, random.nextInt(5));
                    outlines = Space.with(outlines, n, random.nextInt(3) == 0 ? null : mover.outline(pose));
                    region = outlines[n] == null ? region.without(n) : region.with(n, outlines[n]);
                    crossings.addAndGet(
                            compare("seed " + seed + ", change " + change, region, new Space(ground, outlines)));
                }
            }
            if (builder.widest() != builder.region()) {
                Space widest = Space.widest(
                        ground, new Polygon[outlines.length], actor.vault().isPresent());
                crossings.addAndGet(compare("seed " + seed + ", widest", builder.widest(), widest));
            }
        });
        assertTrue(crossings.get() > 1000, "only " + crossings + " crossings");
    }

    /** Compares all configurations and steps, and returns how many are crossings. */
    private static int compare(String which, Region region, Space space) {
        Ground ground = space.ground;
        int[] numbers = new int[region.size()];
        TreeSet<Integer> open = new TreeSet<>();
        int crossings = 0;
        for (int q = 0; q < region.size(); q++) {
            numbers[q] = q;
            if (q >= region.spanCount()) {
                int level = ground.level(region.elevation(q));
                numbers[q] = ground.crossing(region.cell(q), level, region.kind(q) == Kind.JUMPABLE);
                assertEquals(Ground.CROSS, space.abilities[numbers[q]], () -> which + ": a crossing that is none");
                crossings++;
            } else if (q < ground.spanCount) {
                int span = q;
                assertEquals(space.abilities[q], region.abilities(q), () -> which + ": abilities on " + span);
                if (region.open(q)) {
                    assertEquals(
                            ground.kind[q] == Ground.BORDER, region.kind(q) == Kind.BORDER, () -> which + ": " + span);
                    assertEquals(ground.floor[q], region.elevation(q), 1e-9, which);
                }
            } else {
                assertTrue(!region.open(q), which);
            }
            if (region.open(q)) {
                open.add(numbers[q]);
            }
        }
        for (int q = 0; q < ground.size; q++) {
            assertTrue(!space.open(q) || open.contains(q), which + ": " + q + " is not open");
        }
        compareSteps(which, region, space, numbers);
        return crossings;
    }

    private static void compareSteps(String which, Region region, Space space, int[] numbers) {
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        for (int q = 0; q < region.size(); q++) {
            if (region.open(q)) {
                int count = region.neighbours(q, targets, directions);
                List<Space.Step> steps = new ArrayList<>();
                for (int i = 0; i < count; i++) {
                    steps.add(new Space.Step(directions[i], numbers[targets[i]]));
                }
                assertEquals(List.of(space.steps(numbers[q])), steps, which + ": steps from " + q);
            }
        }
    }
}
