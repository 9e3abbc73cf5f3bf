package troupe.app.document;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import troupe.geometry.Polygon;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Encounter;
import troupe.scene.Scene;
import troupe.scene.Task;

/**
 * Finds and changes what belongs to a task and is no element of the scene: the avatars of encounters and the groups of
 * crowds. Here the id of such a part is that of its task, a slash, and its own; no element has a slash in its id. Pure.
 */
public final class Parts {
    private static final char SLASH = '/';

    private Parts() {}

    /** Returns the id of a part of a task. */
    public static String id(String task, String part) {
        return task + SLASH + part;
    }

    /** Returns the ids of the parts of a task, groups before their own parts; none for a journey. */
    public static Stream<String> of(Task task) {
        if (task instanceof Encounter encounter) {
            return encounter.avatars().stream().map(a -> id(task.id(), a.id()));
        }
        return task instanceof Crowd crowd ? crowd.allGroups().map(g -> id(task.id(), g.id())) : Stream.empty();
    }

    /** Tells whether the scene has an element, a part or a place ({@link Mark}) of this id. */
    public static boolean isThere(Scene scene, String id) {
        return scene.element(id).isPresent()
                || avatar(scene, id).isPresent()
                || group(scene, id).isPresent()
                || Mark.find(scene, id).isPresent();
    }

    /** Returns the task to which a part belongs. */
    public static Optional<Task> task(Scene scene, String id) {
        int slash = id.indexOf(SLASH);
        return slash < 0 ? Optional.empty() : scene.task(id.substring(0, slash));
    }

    private static String own(String id) {
        return id.substring(id.indexOf(SLASH) + 1);
    }

    /** Finds an avatar. */
    public static Optional<Avatar> avatar(Scene scene, String id) {
        return task(scene, id).flatMap(t -> t instanceof Encounter e ? e.avatar(own(id)) : Optional.empty());
    }

    /** Finds a group. */
    public static Optional<CrowdGroup> group(Scene scene, String id) {
        return task(scene, id).flatMap(t -> t instanceof Crowd c ? c.group(own(id)) : Optional.empty());
    }

    /** Returns the name to show of a part, empty where there is no such part. */
    public static Optional<String> name(Scene scene, String id) {
        return avatar(scene, id).map(Avatar::name).or(() -> group(scene, id).map(Parts::name));
    }

    /** Returns the name to show of a group. */
    public static String name(CrowdGroup group) {
        return group.label().isEmpty() ? group.id() : group.label();
    }

    /** Returns where the members of a group stand at first; empty for a group of groups, and for anything else. */
    public static Optional<Polygon> spawn(Scene scene, String id) {
        return group(scene, id).flatMap(CrowdGroup::members).map(CrowdGroup.Members::spawn);
    }

    /** Returns the scene with an avatar changed; itself if it has none of that id. */
    public static Scene withAvatar(Scene scene, String id, UnaryOperator<Avatar> change) {
        Optional<Avatar> avatar = avatar(scene, id);
        return avatar.isEmpty()
                ? scene
                : scene.with(((Encounter) task(scene, id).orElseThrow()).with(change.apply(avatar.get())));
    }

    /** Returns the scene with a group changed; itself if it has none of that id. */
    public static Scene withGroup(Scene scene, String id, UnaryOperator<CrowdGroup> change) {
        if (group(scene, id).isEmpty()) {
            return scene;
        }
        Crowd crowd = (Crowd) task(scene, id).orElseThrow();
        return scene.with(crowd.with(changed(crowd.groups(), own(id), g -> List.of(change.apply(g)))));
    }

    /** Returns the scene with the members of a group changed; itself if it has no such members. */
    public static Scene withMembers(Scene scene, String id, UnaryOperator<CrowdGroup.Members> change) {
        return withGroup(
                scene,
                id,
                g -> new CrowdGroup(
                        g.id(), g.label(), g.colour(), g.goal(), g.members().map(change), g.parts()));
    }

    /** A change of a group into others. */
    interface Replacing {
        /** Returns what stands in the place of a group. */
        List<CrowdGroup> with(CrowdGroup group);
    }

    /** Returns groups with the one of an id replaced, at any depth; groups that are left without parts are taken away. */
    static List<CrowdGroup> changed(List<CrowdGroup> groups, String id, Replacing change) {
        List<CrowdGroup> all = new ArrayList<>();
        for (CrowdGroup group : groups) {
            if (group.id().equals(id)) {
                all.addAll(change.with(group));
            } else if (group.parts().isEmpty()) {
                all.add(group);
            } else {
                List<CrowdGroup> parts = changed(group.parts(), id, change);
                if (!parts.isEmpty()) {
                    all.add(holding(group, parts));
                }
            }
        }
        return all;
    }

    /** Returns a group with other parts. */
    static CrowdGroup holding(CrowdGroup group, List<CrowdGroup> parts) {
        return new CrowdGroup(group.id(), group.label(), group.colour(), group.goal(), group.members(), parts);
    }

    /** Returns the scene without these parts; a crowd that is left without groups is taken away. */
    public static Scene removed(Scene scene, Collection<String> ids) {
        Scene changed = scene;
        for (String id : ids) {
            if (task(changed, id).orElse(null) instanceof Encounter encounter) {
                changed = changed.with(encounter.among(encounter.avatars().stream()
                        .filter(a -> !a.id().equals(own(id)))
                        .toList()));
            } else if (task(changed, id).orElse(null) instanceof Crowd crowd) {
                List<CrowdGroup> left = changed(crowd.groups(), own(id), g -> List.of());
                changed = left.isEmpty()
                        ? SceneEdits.removed(changed, List.of(crowd.id()))
                        : changed.with(CrowdEdits.fitting(crowd.with(left)));
            }
        }
        return changed;
    }
}
