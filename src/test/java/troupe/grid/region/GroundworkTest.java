package troupe.grid.region;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;

/** Asks what scenes may share, and that no other ones do. */
class GroundworkTest {
    private static final Actor ACTOR = Actor.walker("a", 0.25, 0.1);
    private static final Obstacle WALL = obstacle("wall", 2, 2, false);
    private static final Obstacle CRATE = obstacle("crate", 1, 1, true);

    private static Obstacle obstacle(String id, double x, double height, boolean movable) {
        return new Obstacle(id, "", Polygon.rectangle(x, 1, x + 0.5, 2), 0, height, movable, 10, "");
    }

    private static Scene scene(Obstacle... obstacles) {
        World world = new World(5, 4, 0.25);
        return new Scene("", world, List.of(obstacles), List.of(), List.of(), List.of());
    }

    @Test
    void scenesWithMovableObstaclesElsewhereShareIt() {
        Groundwork groundwork = new Groundwork(scene(WALL, CRATE), ACTOR);
        Obstacle moved = CRATE.withOutline(Polygon.rectangle(3, 3, 3.5, 3.5));
        assertTrue(groundwork.fits(scene(WALL, CRATE), ACTOR));
        assertTrue(groundwork.fits(scene(WALL, moved), ACTOR));
    }

    @Test
    void nothingElseMayDiffer() {
        Groundwork groundwork = new Groundwork(scene(WALL, CRATE), ACTOR);
        assertFalse(groundwork.fits(scene(WALL.withOutline(CRATE.outline()), CRATE), ACTOR), "a wall elsewhere");
        assertFalse(groundwork.fits(scene(WALL, obstacle("crate", 1, 1.5, true)), ACTOR), "another height");
        assertFalse(groundwork.fits(scene(WALL, obstacle("crate", 1, 1, false)), ACTOR), "not movable any more");
        assertFalse(groundwork.fits(scene(CRATE, WALL), ACTOR), "another order");
        assertFalse(groundwork.fits(scene(WALL), ACTOR), "one less");
        assertFalse(groundwork.fits(scene(WALL, CRATE), Actor.walker("a", 0.3, 0.1)), "another actor");
        Scene other = scene(WALL);
        assertThrows(IllegalArgumentException.class, () -> new RegionBuilder(other, ACTOR, groundwork));
    }

    @Test
    void theLastFewAreKept() {
        Groundworks kept = new Groundworks();
        Groundwork first = kept.of(scene(WALL, CRATE), ACTOR);
        assertSame(first, kept.of(scene(WALL, CRATE.withOutline(WALL.outline())), ACTOR));
        for (int i = 1; i <= 4; i++) {
            kept.of(scene(obstacle("wall", i * 0.1, 2, false)), ACTOR);
        }
        assertNotSame(first, kept.of(scene(WALL, CRATE), ACTOR));
    }
}
