package troupe.app.document;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import troupe.geometry.Polygon;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.Task;

/**
 * Takes elements out of one scene and puts them into another: what would have an id that is taken gets a free
 * one, and a label of its own; what would lie exactly on another thing is shifted aside. Pure.
 */
public final class Pasting {
    /** How far aside something is put that would lie on its like, in metres. */
    public static final double ASIDE = 0.5;

    private Pasting() {}

    /** Holds a scene into which something was pasted, and the ids that this has there. */
    public record Pasted(Scene scene, List<String> ids) {}

    /** Returns a scene of the same world that holds only those elements, and tasks that carry those avatars and groups. */
    public static Scene extract(Scene scene, List<String> ids) {
        List<Task> tasks = new ArrayList<>(chosen(scene.tasks(), ids));
        tasks.addAll(PartPasting.carriers(scene, ids));
        return new Scene(
                "",
                scene.world(),
                chosen(scene.obstacles(), ids),
                chosen(scene.ditches(), ids),
                chosen(scene.actors(), ids),
                tasks);
    }

    private static <E extends Element> List<E> chosen(List<E> all, List<String> ids) {
        return all.stream().filter(e -> ids.contains(e.id())).toList();
    }

    /**
     * Puts all elements of one scene into another, those whose id is taken there under a free one; avatars and groups
     * that came without their task into the task that is looked at, or else the first that can have them.
     *
     * @param looked the id of the task that is looked at, empty if there is none
     */
    public static Pasted into(Scene scene, Scene pasted, String looked) {
        List<Element> elements =
                pasted.elements().filter(e -> !PartPasting.isCarrier(e)).toList();
        double aside = aside(scene, pasted);
        Scene changed = scene;
        List<String> ids = new ArrayList<>();
        Map<String, String> renamed = new LinkedHashMap<>();
        for (Element element : elements) {
            boolean taken = changed.element(element.id()).isPresent();
            Element free = taken ? renamed(changed, element) : element;
            renamed.put(element.id(), free.id());
            changed = NewElements.with(changed, acted(shifted(free, aside), renamed));
            ids.add(free.id());
        }
        for (Task carrier :
                pasted.tasks().stream().filter(PartPasting::isCarrier).toList()) {
            Pasted parts = PartPasting.into(changed, carrier, looked);
            changed = parts.scene();
            ids.addAll(parts.ids());
        }
        return new Pasted(changed, ids);
    }

    /** Returns how far aside the outlines must be put so that none lies exactly on another. */
    private static double aside(Scene scene, Scene pasted) {
        Set<Polygon> there = new HashSet<>();
        scene.obstacles().forEach(o -> there.add(o.outline()));
        scene.ditches().forEach(d -> there.add(d.outline()));
        List<Polygon> coming = new ArrayList<>();
        pasted.obstacles().forEach(o -> coming.add(o.outline()));
        pasted.ditches().forEach(d -> coming.add(d.outline()));
        return aside(there, coming);
    }

    /** Returns how far aside some outlines must be put so that none lies exactly on one that is there. */
    static double aside(Set<Polygon> there, List<Polygon> coming) {
        double aside = 0;
        while (covered(there, coming, aside)) {
            aside += ASIDE;
        }
        return aside;
    }

    private static boolean covered(Set<Polygon> there, List<Polygon> coming, double aside) {
        return coming.stream().anyMatch(p -> there.contains(shifted(p, aside)));
    }

    static Polygon shifted(Polygon outline, double aside) {
        return aside == 0 ? outline : SceneEdits.rounded(outline.shifted(aside, -aside));
    }

    private static Element shifted(Element element, double aside) {
        if (element instanceof Obstacle obstacle) {
            return obstacle.withOutline(shifted(obstacle.outline(), aside));
        }
        return element instanceof Ditch ditch ? ditch.withOutline(shifted(ditch.outline(), aside)) : element;
    }

    private static Element renamed(Scene scene, Element element) {
        String stem = element.id().replaceAll("-\\d+$", "");
        String id = NewElements.freeId(scene, stem);
        String label = element.label();
        if (label.isEmpty()) {
            return element.named(id, "");
        }
        String plain = label.replaceAll(" \\d+$", "");
        int number = 2;
        while (isLabel(scene, plain + " " + number)) {
            number++;
        }
        return element.named(id, plain + " " + number);
    }

    private static boolean isLabel(Scene scene, String label) {
        return scene.elements().anyMatch(e -> e.label().equals(label));
    }

    /** Lets a task that was pasted together with its actor be that actor's under its new id. */
    private static Element acted(Element element, Map<String, String> renamed) {
        if (element instanceof Journey j) {
            return j.withActor(renamed.getOrDefault(j.actor(), j.actor()));
        }
        return element instanceof Encounter e ? e.withActor(renamed.getOrDefault(e.actor(), e.actor())) : element;
    }
}
