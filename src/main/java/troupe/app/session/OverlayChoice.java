package troupe.app.session;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import troupe.app.document.EventThread;
import troupe.app.document.Listeners;

/**
 * Holds which views lie over the scene, which layer is looked at, and of what the views are where the planner
 * offers a choice ({@link troupe.run.view.Aspect}). Belongs to the event thread.
 */
public final class OverlayChoice {
    /** The key of the plan itself, beside those of the planner's views. */
    public static final String PLAN = "plan";

    /** The key of the legend. */
    public static final String LEGEND = "legend";

    /** The key of the last seconds of each way, in crowds. */
    public static final String TRAILS = "trails";

    /** Stands for all layers at once. */
    public static final int ALL_LAYERS = -1;

    private final Listeners<OverlayChoice> listeners = new Listeners<>();
    private final Set<String> keys = new LinkedHashSet<>();
    private int layer = ALL_LAYERS;
    private List<Integer> chosen = List.of();
    private final Map<String, Integer> picked = new HashMap<>();

    /** Makes a choice of these views on all layers. */
    public OverlayChoice(Collection<String> keys) {
        this.keys.addAll(keys);
    }

    /** Returns the observers, told after each change. */
    public Listeners<OverlayChoice> listeners() {
        return listeners;
    }

    /** Tells whether a view is shown. */
    public boolean shows(String key) {
        return keys.contains(key);
    }

    /** Returns the keys of the views that are shown. */
    public Set<String> keys() {
        return Set.copyOf(keys);
    }

    /** Returns the keys of the views that must be there for what is shown: the skeleton ends where no potential is. */
    public Set<String> needed() {
        Set<String> needed = new LinkedHashSet<>(keys);
        if (keys.contains("skeleton")) {
            needed.add("potential");
        }
        return Set.copyOf(needed);
    }

    /** Shows a view, or hides it. */
    public void show(String key, boolean on) {
        EventThread.require();
        if (on ? keys.add(key) : keys.remove(key)) {
            listeners.tell(this);
        }
    }

    /** Returns the layer looked at, 0 the lowest, or {@link #ALL_LAYERS}. */
    public int layer() {
        return layer;
    }

    /** Looks at another layer, 0 the lowest, or at {@link #ALL_LAYERS}. */
    public void lookAt(int other) {
        EventThread.require();
        if (layer != other) {
            layer = other;
            listeners.tell(this);
        }
    }

    /** Returns what is chosen of each aspect of the task, in their order; of those that it leaves out, the first. */
    public List<Integer> chosen() {
        return chosen;
    }

    /** Chooses of the aspect with this number, from 0; what is chosen of the others stays. */
    public void choose(int aspect, int choice) {
        EventThread.require();
        List<Integer> changed = new ArrayList<>(chosen);
        while (changed.size() <= aspect) {
            changed.add(0);
        }
        if (changed.set(aspect, choice) != choice) {
            chosen = List.copyOf(changed);
            listeners.tell(this);
        }
    }

    /** Returns what is picked of a respect in which a run can be looked at ({@link RunViews#aspects}), from 0. */
    public int picked(String aspect) {
        return picked.getOrDefault(aspect, 0);
    }

    /** Picks of a respect in which a run can be looked at, from 0. */
    public void pick(String aspect, int choice) {
        EventThread.require();
        if (picked(aspect) != choice) {
            picked.put(aspect, choice);
            listeners.tell(this);
        }
    }

    /** Chooses the first of every aspect again, and tells nobody: for another task, before it is planned. */
    public void chooseFirst() {
        EventThread.require();
        chosen = List.of();
        picked.clear();
    }
}
