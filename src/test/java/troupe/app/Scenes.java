package troupe.app;

import java.util.List;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

/** Makes small scenes for tests of the studio. */
public final class Scenes {
    private Scenes() {}

    /** Makes an obstacle of one metre that stands on the ground. */
    public static Obstacle box(String id, double x, double y, double size) {
        return new Obstacle(
                id, "", Polygon.rectangle(x, y, x + size, y + size), 0, 1, false, Obstacle.DEFAULT_MASS, "");
    }

    /** Makes a room of ten by eight metres with a crate, a post, a ditch, one actor and two journeys. */
    public static Scene room() {
        return new Scene(
                "Room",
                new World(10, 8, 0.1),
                List.of(box("crate", 4, 3, 1), box("post", 7, 6, 0.5)),
                List.of(new Ditch("ditch", "", Polygon.rectangle(0, 7, 2, 8), 1)),
                List.of(Actor.standard("ann")),
                List.of(
                        Journey.of("there", "ann", Place.of(1, 1), Place.of(9, 1)),
                        Journey.of("back", "ann", Place.of(9, 1), Place.of(1, 1))));
    }
}
