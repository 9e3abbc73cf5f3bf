package troupe.scene;

import java.util.Map;

/** Holds a scene as read, with the line at which each element begins, by id. */
public record SceneSource(Scene scene, Map<String, Integer> lines) {

    /** Copies the map. */
    public SceneSource {
        lines = Map.copyOf(lines);
    }
}
