package troupe.app.look;

import java.awt.Component;
import java.awt.Container;
import java.util.Optional;

/** Finds components by their names. Belongs to the event thread. */
public final class Named {
    private Named() {}

    /** Returns the first component of a name in a container, at any depth; empty if there is none. */
    public static Optional<Component> find(Container in, String name) {
        for (Component part : in.getComponents()) {
            if (name.equals(part.getName())) {
                return Optional.of(part);
            }
            Optional<Component> found = part instanceof Container inner ? find(inner, name) : Optional.empty();
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }
}
