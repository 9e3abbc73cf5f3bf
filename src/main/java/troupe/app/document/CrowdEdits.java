package troupe.app.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Changes the tree of the groups of a crowd. Pure. */
public final class CrowdEdits {
    private CrowdEdits() {}

    /** Returns the crowd without relation vectors of depths that it does not have. */
    static Crowd fitting(Crowd crowd) {
        List<Crowd.Relation> fitting = crowd.relations().stream()
                .filter(r -> r.depth() <= crowd.deepest())
                .toList();
        return fitting.size() == crowd.relations().size()
                ? crowd
                : new Crowd(
                        crowd.id(),
                        crowd.label(),
                        crowd.manner(),
                        crowd.weights(),
                        fitting,
                        crowd.groups(),
                        crowd.seconds(),
                        crowd.seed());
    }

    /** Returns the crowd with a group more: the last part of the family of an id, or of the crowd where that has none. */
    public static Crowd with(Crowd crowd, String family, CrowdGroup added) {
        boolean there = crowd.group(family).filter(g -> g.members().isEmpty()).isPresent();
        if (!there) {
            List<CrowdGroup> all = new ArrayList<>(crowd.groups());
            all.add(added);
            return crowd.with(all);
        }
        return crowd.with(Parts.changed(crowd.groups(), family, g -> {
            List<CrowdGroup> parts = new ArrayList<>(g.parts());
            parts.add(added);
            return List.of(Parts.holding(g, parts));
        }));
    }

    /** Returns the first of {@code group-1}, {@code group-2}, … that neither the scene nor the crowd has as an id. */
    public static String freeId(Scene scene, Crowd crowd) {
        int number = 1;
        while (scene.element("group-" + number).isPresent()
                || crowd.group("group-" + number).isPresent()) {
            number++;
        }
        return "group-" + number;
    }

    /** Tells whether these groups can become parts of one: two or more of one crowd, side by side in its tree. */
    public static boolean canJoin(Scene scene, List<String> ids) {
        return ids.size() > 1 && siblings(scene, ids).isPresent();
    }

    /** Returns the list of groups that holds all of these, if there is one. */
    private static Optional<List<CrowdGroup>> siblings(Scene scene, List<String> ids) {
        if (ids.isEmpty() || !(Parts.task(scene, ids.get(0)).orElse(null) instanceof Crowd crowd)) {
            return Optional.empty();
        }
        List<List<CrowdGroup>> lists = new ArrayList<>(List.of(crowd.groups()));
        crowd.allGroups().map(CrowdGroup::parts).forEach(lists::add);
        return lists.stream()
                .filter(list -> ids.stream().allMatch(id -> list.stream()
                        .anyMatch(g -> Parts.id(crowd.id(), g.id()).equals(id))))
                .findFirst();
    }

    /**
     * Returns the scene with these groups as the parts of a new one of that id and label, in the place of the first. A
     * goal that all of them have becomes that of the new one.
     *
     * @throws IllegalArgumentException unless {@link #canJoin}
     */
    public static Scene joined(Scene scene, List<String> ids, String id, String label) {
        if (!canJoin(scene, ids)) {
            throw new IllegalArgumentException(ids + ": two or more groups side by side in one crowd are needed");
        }
        Crowd crowd = (Crowd) Parts.task(scene, ids.get(0)).orElseThrow();
        List<CrowdGroup> parts = siblings(scene, ids).orElseThrow().stream()
                .filter(g -> ids.contains(Parts.id(crowd.id(), g.id())))
                .toList();
        Optional<Place> goal = parts.get(0).goal();
        boolean shared = parts.stream().allMatch(g -> g.goal().equals(goal));
        List<CrowdGroup> inside =
                shared ? parts.stream().map(g -> going(g, Optional.empty())).toList() : parts;
        CrowdGroup family = new CrowdGroup(id, label, "", shared ? goal : Optional.empty(), Optional.empty(), inside);
        List<CrowdGroup> groups = Parts.changed(crowd.groups(), parts.get(0).id(), g -> List.of(family, g));
        for (CrowdGroup part : parts) {
            groups = withoutOutside(groups, part.id(), id);
        }
        return scene.with(crowd.with(groups));
    }

    /** Takes a group away where it does not stand in the family. */
    private static List<CrowdGroup> withoutOutside(List<CrowdGroup> groups, String id, String family) {
        List<CrowdGroup> all = new ArrayList<>();
        for (CrowdGroup group : groups) {
            if (group.id().equals(family)) {
                all.add(group);
            } else if (!group.id().equals(id)) {
                all.add(
                        group.parts().isEmpty()
                                ? group
                                : Parts.holding(group, withoutOutside(group.parts(), id, family)));
            }
        }
        return all;
    }

    /** Returns the scene with the parts of a group in its place; they go where it went. */
    public static Scene parted(Scene scene, String id) {
        CrowdGroup family = Parts.group(scene, id)
                .filter(g -> !g.parts().isEmpty())
                .orElseThrow(() -> new IllegalArgumentException(id + ": a group of groups is needed"));
        Crowd crowd = (Crowd) Parts.task(scene, id).orElseThrow();
        List<CrowdGroup> parts = family.parts().stream()
                .map(g -> g.goal().isPresent() ? g : going(g, family.goal()))
                .toList();
        return scene.with(fitting(crowd.with(Parts.changed(crowd.groups(), family.id(), g -> parts))));
    }

    /** Returns a group that goes elsewhere, or where the group above it goes. */
    public static CrowdGroup going(CrowdGroup g, Optional<Place> goal) {
        return new CrowdGroup(g.id(), g.label(), g.colour(), goal, g.members(), g.parts());
    }
}
