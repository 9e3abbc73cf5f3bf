package troupe.work.inspect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

/** Asks what blocks a journey from left to right through a hall of ten by four metres. */
class BlockageSearchTest {
    private static final Journey ACROSS = Journey.of("go", "ann", Place.of(1, 2), Place.of(9, 2));

    private static Obstacle wall(String id, double x0, double y0, double x1, double y1, double height) {
        return new Obstacle(id, "", Polygon.rectangle(x0, y0, x1, y1), 0, height, false, Obstacle.DEFAULT_MASS, "");
    }

    private static Scene hall(Obstacle... obstacles) {
        return new Scene(
                "",
                new World(10, 4, 0.05),
                List.of(obstacles),
                List.of(),
                List.of(Actor.standard("ann")),
                List.of(ACROSS));
    }

    @Test
    void aWallFromSideToSideStandsInTheWay() {
        Blockage blockage =
                BlockageSearch.of(hall(wall("wall", 5, 0, 5.2, 4, 3)), ACROSS).orElseThrow();
        assertEquals(List.of("wall"), blockage.obstacles(), blockage.toString());
        assertEquals(List.of(), blockage.gaps());
    }

    @Test
    void theThinnerOfTwoWaysIsBlamed() {
        Scene scene = hall(wall("thick", 4, 0, 7, 2.5, 3), wall("thin", 5, 2.5, 5.2, 4, 3));
        assertEquals(
                List.of("thin"), BlockageSearch.of(scene, ACROSS).orElseThrow().obstacles());
    }

    @Test
    void aGapIsMeasuredAndTheWidthThatIsNeededNamed() {
        Scene scene = hall(wall("low", 5, 0, 5.2, 1.9, 3), wall("high", 5, 2.1, 5.2, 4, 3));
        Blockage blockage = BlockageSearch.of(scene, ACROSS).orElseThrow();
        assertEquals(List.of(), blockage.obstacles());
        assertEquals(1, blockage.gaps().size());
        Blockage.Gap gap = blockage.gaps().get(0);
        assertEquals(0.2, gap.width(), 0.02);
        assertEquals(0.3, gap.needed(), 1e-9);
        assertTrue(List.of(gap.first(), gap.second()).containsAll(List.of("low", "high")));
        assertEquals(5.1, gap.at().x(), 0.2);
    }

    @Test
    void whatIsSteppedOverOrPassedUnderIsNoBlockage() {
        Obstacle beam =
                new Obstacle("beam", "", Polygon.rectangle(5, 0, 5.2, 4), 2, 1, false, Obstacle.DEFAULT_MASS, "");
        assertEquals(Optional.empty(), BlockageSearch.of(hall(beam, wall("sill", 6, 0, 6.2, 4, 0.2)), ACROSS));
    }

    @Test
    void theNearestFreePlaceHasRoomForTheActor() {
        Scene scene = hall(wall("block", 0, 1, 2, 3, 3));
        Place free = BlockageSearch.nearestFree(scene, scene.actors().get(0), Place.of(1.8, 2))
                .orElseThrow();
        assertTrue(free.x() >= 2.25 && free.x() < 2.45, free.toString());
        assertEquals(2, free.y(), 0.06);
    }
}
