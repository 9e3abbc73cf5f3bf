package troupe.scene.xml;

import java.util.Map;
import troupe.scene.Scene;

/** Holds a scene as read, with the line at which each element begins, by id. */
public record SceneSource(Scene scene, Map<String, Integer> lines) {

    /** Copies the map. */
    public SceneSource {
        lines = Map.copyOf(lines);
    }
}
