package troupe.app.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.app.Scenes;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.scene.Element;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

class HitsTest {

    private static Scene stacked() {
        Scene room = Scenes.room();
        Obstacle high = new Obstacle("deck", "", Polygon.rectangle(4.5, 3, 6, 4), 2, 0.2, false, 20, "");
        return new Scene(
                "", room.world(), List.of(high, room.obstacles().get(0)), room.ditches(), room.actors(), room.tasks());
    }

    private static Optional<String> at(double x, double y) {
        return Hits.element(stacked(), new Point(x, y), 0.01).map(Element::id);
    }

    @Test
    void findsTheHighestThenTheDitch() {
        assertEquals(Optional.of("deck"), at(4.8, 3.5));
        assertEquals(Optional.of("crate"), at(4.2, 3.5));
        assertEquals(Optional.of("ditch"), at(1, 7.5));
        assertEquals(Optional.empty(), at(8, 1));
    }

    @Test
    void reachesThreePixelsBeyondAnEdge() {
        assertEquals(Optional.of("crate"), at(3.98, 3.5));
        assertEquals(Optional.empty(), at(3.96, 3.5));
    }

    @Test
    void aBoxHoldsWhatLiesWhollyInIt() {
        assertEquals(List.of("crate"), Hits.inside(stacked(), new Box(3.9, 2.9, 5.5, 4.1)));
        assertEquals(List.of("deck", "crate", "ditch"), Hits.inside(stacked(), new Box(0, 0, 10, 8)));
    }
}
