package troupe.unified.manipulation;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.obstacle.Grip;
import troupe.unified.obstacle.Movable;
import troupe.unified.obstacle.Support;
import troupe.unified.obstacle.Surroundings;
import troupe.unified.obstacle.Sweeps;

/** Asserts that judging moves takes no memory once the neighbourhood has been looked at. */
class MovesAllocationTest {
    /** Bytes for some forty thousand moves, under 25 each: none on Java 17, while newer runtimes take 17 themselves. */
    private static final long SMALL = 1_000_000;

    private final Scene scene = Plans.scene(
            new World(6, 6, 0.1),
            List.of(
                    Plans.crate(2, 2, 3, 2.6),
                    Plans.wall(3.1, 0, 3.3, 4),
                    Plans.solid(Polygon.of(1, 3, 2.9, 3, 2.2, 3.4), 0, 1, false)),
            List.of(new Ditch("d", "", Polygon.rectangle(0, 0, 6, 1.5), 0.5)));
    private final Movable movable = Plans.movable(scene, 24);
    private final Surroundings surroundings = new Surroundings(scene);
    private final Sweeps sweeps = surroundings.sweeps(movable);
    private final Support support = surroundings.support(movable);
    private final GridFrame frame = GridFrame.of(scene.world());
    private final int trigger = frame.cellAt(1.55, 2.25);

    @Test
    void judgingMovesTakesNoMemory() throws ReflectiveOperationException {
        Region base = new RegionBuilder(scene, Actor.standard("a")).region();
        Grip grip = SlowGrip.grip(scene, movable, base, trigger);
        int[] cells = {trigger, trigger + 1, trigger + 2};
        double[] radii = new double[cells.length];
        Arrays.fill(radii, 0.25);
        ConfigurationSpace space =
                new ConfigurationSpace(movable, new ExpectedPath(frame, 1.7, cells, new double[cells.length], radii));
        int first = judge(grip, space);
        long before = allocated();
        int second = judge(grip, space);
        long taken = allocated() - before;
        assertTrue(first == second && first > 1000, first + " and " + second + " moves had room");
        assertTrue(taken < SMALL, "took " + taken + " bytes");
    }

    private int judge(Grip grip, ConfigurationSpace space) {
        int count = 0;
        for (int k = 0; k < 24; k++) {
            for (int i = -6; i <= 6; i++) {
                for (int j = -6; j <= 6; j++) {
                    sweeps.choose(i, j, k);
                    grip.choose(trigger, i, j, k);
                    for (int d = 0; d < 8; d++) {
                        int to = grip.shifted(d);
                        count += sweeps.canShift(d) && to >= 0 && grip.canShift(d, to) ? 1 : 0;
                    }
                    count += sweeps.canTurn(true) && grip.turned(true) >= 0 && grip.canTurn(true) ? 1 : 0;
                    count += sweeps.canTurn(false) && grip.turned(false) >= 0 && grip.canTurn(false) ? 1 : 0;
                    count += support.rests(i, j, k) && !space.contains(i, j, k) ? 1 : 0;
                }
            }
        }
        return count;
    }

    /** Returns the bytes that this thread has taken so far; by name, as the modules of the tests do not read it. */
    private static long allocated() throws ReflectiveOperationException {
        Object threads = Class.forName("java.lang.management.ManagementFactory")
                .getMethod("getThreadMXBean")
                .invoke(null);
        return (long) Class.forName("com.sun.management.ThreadMXBean")
                .getMethod("getThreadAllocatedBytes", long.class)
                .invoke(threads, Thread.currentThread().getId());
    }
}
