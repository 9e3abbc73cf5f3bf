package troupe.app.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.app.document.Parts;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.CrowdGroup;
import troupe.scene.Element;
import troupe.scene.Scene;
import troupe.scene.Task;

/** Finds the properties that things of a scene have in common. Pure. */
public final class Properties {
    private Properties() {}

    /** Returns the properties that all of these elements have, in groups without empty ones; of none, those of the scene. */
    public static List<Group> of(Scene scene, List<String> ids) {
        if (ids.isEmpty()) {
            return List.of(new Group("", SceneProperties.all()));
        }
        Optional<Element> first = scene.element(ids.get(0));
        Optional<Avatar> avatar = Parts.avatar(scene, ids.get(0));
        if (!Parts.isThere(scene, ids.get(0))) {
            return List.of();
        }
        List<Group> offered = new ArrayList<>();
        if (ids.size() == 1) {
            offered.add(new Group("", List.of(label())));
        }
        if (avatar.isPresent()) {
            offered.add(new Group("", PartProperties.avatar(avatar.get())));
        } else if (first.isEmpty()) {
            offered.add(new Group("", PartProperties.group()));
        } else if (first.get() instanceof Actor actor) {
            offered.addAll(ActorProperties.of(scene, actor));
        } else if (first.get() instanceof Task task) {
            offered.addAll(TaskProperties.groups(scene, task));
        } else {
            offered.add(new Group("", ShapeProperties.all()));
        }
        return offered.stream()
                .map(group -> new Group(
                        group.key(),
                        group.properties().stream()
                                .filter(p -> p.common(scene, ids).isPresent())
                                .toList()))
                .filter(group -> !group.properties().isEmpty())
                .toList();
    }

    private static Scene labelled(Scene scene, String id, String label) {
        if (scene.element(id).isPresent()) {
            return scene.with(scene.element(id).get().named(id, label));
        }
        Scene changed = Parts.withAvatar(
                scene,
                id,
                a -> new Avatar(a.id(), label, a.colour(), a.radius(), a.speed(), a.mobility(), a.kind(), a.motion()));
        return Parts.withGroup(
                changed, id, g -> new CrowdGroup(g.id(), label, g.colour(), g.goal(), g.members(), g.parts()));
    }

    private static Property label() {
        return Property.typed(
                "label",
                "",
                (scene, id) -> scene.element(id)
                        .map(Element::label)
                        .or(() -> Parts.avatar(scene, id).map(Avatar::label))
                        .or(() -> Parts.group(scene, id).map(CrowdGroup::label)),
                (scene, id, text) -> labelled(scene, id, text.strip()));
    }
}
