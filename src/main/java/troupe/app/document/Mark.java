package troupe.app.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.Task;

/**
 * A place of a task that can be put elsewhere: where its actor starts and where it goes, where an avatar starts and
 * the goals of its way, where a group goes. Immutable.
 *
 * @param owner the id of the task, or of its part ({@link Parts})
 * @param number of the goals of an avatar which one, from 0; else 0
 */
public record Mark(Kind kind, String owner, int number, Place place) {
    private static final char HASH = '#';

    /** What a place is. */
    public enum Kind {
        START,
        GOAL,
        AVATAR,
        HEAD,
        GROUP
    }

    /** Lists the places of a task, those of its actor last, since they lie above the others. */
    public static List<Mark> of(Task task) {
        List<Mark> all = new ArrayList<>();
        if (task instanceof Crowd crowd) {
            crowd.allGroups().forEach(g -> g.goal()
                    .ifPresent(p -> all.add(new Mark(Kind.GROUP, Parts.id(crowd.id(), g.id()), 0, p))));
        } else if (task instanceof Encounter encounter) {
            encounter.avatars().forEach(a -> add(all, Parts.id(encounter.id(), a.id()), a));
            all.add(new Mark(Kind.START, task.id(), 0, encounter.start()));
            all.add(new Mark(Kind.GOAL, task.id(), 0, encounter.goal()));
        } else if (task instanceof Journey journey) {
            all.add(new Mark(Kind.START, task.id(), 0, journey.start()));
            all.add(new Mark(Kind.GOAL, task.id(), 0, journey.goal()));
        }
        return all;
    }

    private static void add(List<Mark> all, String id, Avatar avatar) {
        start(avatar).ifPresent(p -> all.add(new Mark(Kind.AVATAR, id, 0, p)));
        List<Avatar.Head> heads = heads(avatar);
        for (int i = 0; i < heads.size(); i++) {
            all.add(new Mark(Kind.HEAD, id, i, heads.get(i).to()));
        }
    }

    /**
     * Returns the id by which this place is selected: its owner's for an avatar, which is dragged by its start; for
     * any other that of its owner, a hash and what it is. No element has a hash in its id.
     */
    public String id() {
        return switch (kind) {
            case AVATAR -> owner;
            case START -> owner + HASH + "start";
            case GOAL, GROUP -> owner + HASH + "goal";
            case HEAD -> owner + HASH + number;
        };
    }

    /** Finds the place of an id with a hash. */
    public static Optional<Mark> find(Scene scene, String id) {
        return id.indexOf(HASH) < 0
                ? Optional.empty()
                : scene.task(id.replaceAll("[/#].*", "")).stream()
                        .flatMap(task -> of(task).stream())
                        .filter(mark -> mark.id().equals(id))
                        .findFirst();
    }

    /** Returns the scene without this place: a goal of an avatar can be done without, any other stays. */
    Scene removed(Scene scene) {
        return kind != Kind.HEAD
                ? scene
                : Parts.withAvatar(scene, owner, avatar -> {
                    List<Avatar.Head> heads = new ArrayList<>(heads(avatar));
                    heads.remove(number);
                    Avatar.Script script = (Avatar.Script) avatar.motion();
                    return moving(avatar, new Avatar.Script(script.start(), script.pace(), heads));
                });
    }

    /** Returns where an avatar starts, empty for one that was recorded. */
    public static Optional<Place> start(Avatar avatar) {
        if (avatar.motion() instanceof Avatar.Pointer pointer) {
            return Optional.of(pointer.start());
        }
        return avatar.motion() instanceof Avatar.Script script ? Optional.of(script.start()) : Optional.empty();
    }

    /** Returns the goals of an avatar that follows a script; none of any other. */
    public static List<Avatar.Head> heads(Avatar avatar) {
        return avatar.motion() instanceof Avatar.Script script ? script.heads() : List.of();
    }

    /** Returns the scene with this place elsewhere. */
    public Scene moved(Scene scene, Place to) {
        return switch (kind) {
            case START -> SceneEdits.startingAt(scene, owner, to);
            case GOAL -> SceneEdits.endingAt(scene, owner, to);
            case AVATAR -> Parts.withAvatar(scene, owner, a -> starting(a, to));
            case HEAD -> Parts.withAvatar(scene, owner, a -> heading(a, number, to));
            case GROUP -> Parts.withGroup(scene, owner, g -> CrowdEdits.going(g, Optional.of(to)));
        };
    }

    /** Returns an avatar that starts elsewhere; a recorded one as it is. */
    public static Avatar starting(Avatar avatar, Place to) {
        if (avatar.motion() instanceof Avatar.Script script) {
            return moving(avatar, new Avatar.Script(to, script.pace(), script.heads()));
        }
        return avatar.motion() instanceof Avatar.Pointer ? moving(avatar, new Avatar.Pointer(to)) : avatar;
    }

    private static Avatar heading(Avatar avatar, int number, Place to) {
        if (!(avatar.motion() instanceof Avatar.Script script)) {
            return avatar;
        }
        List<Avatar.Head> heads = new ArrayList<>(script.heads());
        heads.set(number, new Avatar.Head(to, heads.get(number).at()));
        return moving(avatar, new Avatar.Script(script.start(), script.pace(), heads));
    }

    /** Returns an avatar that moves in another way. */
    public static Avatar moving(Avatar a, Avatar.Motion motion) {
        return new Avatar(a.id(), a.label(), a.colour(), a.radius(), a.speed(), a.mobility(), a.kind(), motion);
    }
}
