package troupe.app.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.app.Scenes;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;

class SceneEditsTest {

    @Test
    void shiftsObstaclesDitchesAndBothEndsOfATask() {
        Scene scene = Scenes.room();
        Scene moved = SceneEdits.shifted(scene, List.of("crate", "ditch", "ann", "there"), 1, -2);
        assertEquals(
                Polygon.rectangle(5, 1, 6, 2),
                moved.obstacle("crate").orElseThrow().outline());
        assertEquals(Polygon.rectangle(1, 5, 3, 6), moved.ditches().get(0).outline());
        assertEquals(scene.obstacle("post"), moved.obstacle("post"));
        assertEquals(scene.actors(), moved.actors());
        Journey there = (Journey) moved.task("there").orElseThrow();
        assertEquals(List.of(Place.of(2, -1), Place.of(10, -1)), List.of(there.start(), there.goal()));
        assertEquals(scene.task("back"), moved.task("back"));
    }

    @Test
    void turnsAboutTheCentroid() {
        Polygon turned = SceneEdits.turned(Polygon.rectangle(0, 0, 4, 2), Math.PI / 2);
        assertEquals(new Point(2, 1), turned.centroid());
        assertEquals(1, turned.bounds().minX(), 1e-9);
        assertEquals(3, turned.bounds().maxX(), 1e-9);
        assertEquals(-1, turned.bounds().minY(), 1e-9);
    }

    @Test
    void centresAnOutline() {
        Polygon moved = SceneEdits.centred(Polygon.rectangle(0, 0, 1, 1), new Point(3.25, 7));
        assertEquals(Polygon.rectangle(2.75, 6.5, 3.75, 7.5), moved);
    }

    @Test
    void removesWhatIsNamed() {
        Scene left = SceneEdits.removed(Scenes.room(), List.of("crate", "ditch", "ann"));
        assertTrue(left.obstacle("crate").isEmpty());
        assertTrue(left.ditches().isEmpty());
        assertTrue(left.actors().isEmpty());
        assertEquals(2, left.tasks().size());
    }

    @Test
    void movesTheEndsOfAJourney() {
        Scene scene = Scenes.room();
        Journey there = (Journey) scene.task("there").orElseThrow();
        Scene changed = SceneEdits.startingAt(scene, there, Place.of(2, 2));
        assertEquals(Place.of(2, 2), ((Journey) changed.task("there").orElseThrow()).start());
        changed = SceneEdits.endingAt(scene, there, Place.of(3, 3));
        assertEquals(Place.of(3, 3), ((Journey) changed.task("there").orElseThrow()).goal());
    }

    @Test
    void roundsToATenthOfAMillimetre() {
        assertEquals(0.3, SceneEdits.rounded(0.1 + 0.2));
        assertEquals(1.2346, SceneEdits.rounded(1.23456));
    }
}
