package troupe.grid.region;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/** Compares regions after sequences of edits with regions built anew, configuration by configuration. */
class PatchPropertyTest {
    private static final int SCENES = 150;
    private static final int EDITS = 6;

    private int crossings;
    private int different;

    @Test
    void patchesEqualFullBuilds() {
        for (long seed = 1; seed <= SCENES; seed++) {
            double side = seed % 3 == 0 ? 9 : 5;
            Scene scene = MovableScenes.scene(seed, side, seed % 2 == 0 ? 0.2 : 0.25);
            edit("seed " + seed, scene, MovableScenes.actor(seed), side, new Random(7 * seed));
        }
        assertTrue(crossings > 20_000, "too few crossings: " + crossings);
        assertTrue(different > 300, "too few edits that change anything: " + different);
    }

    private void edit(String seed, Scene scene, Actor actor, double side, Random random) {
        Region base = Region.of(scene, actor);
        Region region = base;
        List<Optional<Polygon>> outlines = new ArrayList<>();
        List<Integer> movable = new ArrayList<>();
        for (Obstacle obstacle : scene.obstacles()) {
            outlines.add(Optional.of(obstacle.outline()));
            if (obstacle.movable()) {
                movable.add(outlines.size() - 1);
            }
        }
        for (int edit = 0; edit < EDITS; edit++) {
            if (random.nextBoolean()) {
                touch(region, random);
            }
            int obstacle = movable.get(random.nextInt(movable.size()));
            Region before = region;
            if (random.nextInt(3) == 0) {
                outlines.set(obstacle, Optional.empty());
                region = region.without(obstacle);
            } else {
                Polygon own = scene.obstacles().get(obstacle).outline();
                Polygon outline = random.nextInt(4) == 0
                        ? own
                        : MovableScenes.moved(outlines.get(obstacle).orElse(own), side, random);
                outlines.set(obstacle, Optional.of(outline));
                region = region.with(obstacle, outline);
            }
            different += before == region ? 0 : 1;
            assertEquals(outlines.get(obstacle), region.outline(obstacle));
            Region whole = Region.of(MovableScenes.with(scene, outlines), actor);
            compare(seed + " edit " + edit, whole, region, edit == EDITS - 1);
        }
        compare(seed + " base", Region.of(scene, actor), base, false);
    }

    /** Asks for some neighbours, so that what is found on demand is there before the next edit. */
    private static void touch(Region region, Random random) {
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        for (int k = 0; k < 100; k++) {
            region.neighbours(random.nextInt(region.size()), targets, directions);
        }
    }

    private void compare(String which, Region whole, Region patched, boolean clearance) {
        assertEquals(whole.size(), patched.size(), which);
        assertEquals(whole.spanCount(), patched.spanCount(), which);
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        int[] otherTargets = new int[Region.MAX_NEIGHBOURS];
        int[] otherDirections = new int[Region.MAX_NEIGHBOURS];
        for (int q = 0; q < whole.size(); q++) {
            String place = which + " configuration " + q;
            assertEquals(whole.cell(q), patched.cell(q), place);
            assertEquals(whole.level(q), patched.level(q), place);
            assertEquals(whole.abilities(q), patched.abilities(q), place);
            assertEquals(whole.open(q), patched.open(q), place);
            assertEquals(whole.kind(q), patched.kind(q), place);
            assertEquals(whole.moves(q), patched.moves(q), place);
            assertEquals(whole.plain(q), patched.plain(q), place);
            int n = whole.neighbours(q, targets, directions);
            assertEquals(n, patched.neighbours(q, otherTargets, otherDirections), place);
            if (n > 0) {
                assertArrayEquals(Arrays.copyOf(targets, n), Arrays.copyOf(otherTargets, n), place);
                assertArrayEquals(Arrays.copyOf(directions, n), Arrays.copyOf(otherDirections, n), place);
            }
            if (q >= whole.spanCount()) {
                crossings++;
                assertEquals(q, patched.crossing(whole.cell(q), whole.level(q), whole.kind(q)), place);
            } else if (clearance) {
                assertEquals(whole.clearance(q), patched.clearance(q), place);
            }
        }
    }
}
