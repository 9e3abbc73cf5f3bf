package troupe.unified;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import troupe.geometry.Point;
import troupe.geometry.Pose;
import troupe.grid.region.Groundworks;
import troupe.run.Digest;
import troupe.run.Run;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.unified.reference.MovingWorlds;

/** Drags obstacles through random worlds: plans that share what they can are those that begin from nothing. */
class SharedGroundworkTest {
    private static final long FIRST_SEED = Long.getLong("troupe.seed", 1);
    private static final int WORLDS = 40;
    private static final int MOMENTS = 4;

    @Test
    void plansThatShareGroundworkAreThoseThatDoNot() {
        AtomicInteger moved = new AtomicInteger();
        LongStream.range(FIRST_SEED, FIRST_SEED + WORLDS).parallel().forEach(seed -> {
            Journey.Manipulation how = seed % 2 == 0 ? Journey.Manipulation.FREE : Journey.Manipulation.GRIP;
            Scene scene = seed % 4 == 1 ? LayeredStores.scene(seed) : MovingWorlds.scene(seed, how);
            Groundworks kept = new Groundworks();
            for (int moment = 0; moment < MOMENTS; moment++) {
                Scene dragged = dragged(scene, moment);
                Journey journey = (Journey) dragged.tasks().get(0);
                String which = "seed " + seed + ", moment " + moment;
                Run fresh = JourneyEngine.of(dragged, journey).finish();
                Run shared = JourneyEngine.of(dragged, journey, kept).finish();
                assertEquals(fresh.outcome(), shared.outcome(), which);
                assertEquals(Digest.of(fresh.frames()), Digest.of(shared.frames()), which);
                assertEquals(RunCheck.untimed(fresh), RunCheck.untimed(shared), which);
                moved.addAndGet(((List<?>) shared.report().values().get("moved")).isEmpty() ? 0 : 1);
            }
        });
        assertTrue(moved.get() > WORLDS / 2, moved + " runs move something");
    }

    /** Puts the movable obstacles a little elsewhere, and turns them at odd moments. */
    private static Scene dragged(Scene scene, int moment) {
        Scene dragged = scene;
        for (Obstacle obstacle : scene.obstacles()) {
            if (obstacle.movable()) {
                Point centre = obstacle.outline().centroid();
                Pose pose = new Pose(centre.x() + 0.03 * moment, centre.y() - 0.02 * moment, moment % 2 * 0.1);
                dragged = dragged.with(obstacle.withOutline(obstacle.outline().at(pose)));
            }
        }
        return dragged;
    }
}
