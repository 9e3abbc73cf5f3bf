package troupe.scene;

/** Anything in a scene that has an id, {@code [A-Za-z_][\w.-]*}, unique in its scene. */
public sealed interface Element permits Obstacle, Ditch, Actor, Task {

    /** Returns the id. */
    String id();

    /** Returns the name to show, empty for none. */
    String label();

    /** Returns the same with another id and label. */
    Element named(String otherId, String otherLabel);

    /** Returns the label, or the id where there is none. */
    default String name() {
        return label().isEmpty() ? id() : label();
    }
}
