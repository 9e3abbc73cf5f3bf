package troupe.app.document;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import troupe.scene.Element;
import troupe.scene.Scene;

/**
 * Holds the ids of the elements, and of the parts of tasks ({@link Parts}), that are selected, in the order in which they
 * were. Belongs to the event thread.
 */
public final class Selection {
    private final Listeners<Selection> listeners = new Listeners<>();
    private Set<String> ids = new LinkedHashSet<>();

    /** Returns the observers, told after each change. */
    public Listeners<Selection> listeners() {
        return listeners;
    }

    /** Returns the ids of what is selected. */
    public List<String> ids() {
        return List.copyOf(ids);
    }

    /** Tells whether the element is selected. */
    public boolean contains(String id) {
        return ids.contains(id);
    }

    /** Returns the element, if exactly one is selected and the scene holds it. */
    public Optional<Element> single(Scene scene) {
        return ids.size() == 1 ? scene.element(ids.iterator().next()) : Optional.empty();
    }

    /** Selects just these. */
    public void set(Collection<String> chosen) {
        EventThread.require();
        Set<String> changed = new LinkedHashSet<>(chosen);
        if (!changed.equals(ids)) {
            ids = changed;
            listeners.tell(this);
        }
    }

    /** Selects nothing. */
    public void clear() {
        set(List.of());
    }

    /** Adds an element to the selection, or takes it out. */
    public void toggle(String id) {
        Set<String> changed = new LinkedHashSet<>(ids);
        if (!changed.remove(id)) {
            changed.add(id);
        }
        set(changed);
    }

    /** Takes out what the scene no longer holds. */
    public void retain(Scene scene) {
        set(ids.stream().filter(id -> Parts.isThere(scene, id)).toList());
    }
}
