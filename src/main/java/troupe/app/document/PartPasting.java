package troupe.app.document;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import troupe.geometry.Polygon;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Element;
import troupe.scene.Encounter;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.Task;

/**
 * Takes avatars and groups out of their tasks and puts them into others. On their way they are the parts of a task
 * whose id begins with {@value #CARRIER}, so that the scene format can hold them; such a task is no task itself. Pure.
 */
final class PartPasting {
    private static final String CARRIER = "_parts";

    private PartPasting() {}

    /** Returns the tasks that carry the chosen parts of the tasks that are not chosen themselves. */
    static List<Task> carriers(Scene scene, List<String> ids) {
        List<Task> all = new ArrayList<>();
        for (Task task : scene.tasks()) {
            String id = CARRIER + (all.isEmpty() ? "" : "-" + all.size());
            if (!ids.contains(task.id()) && task instanceof Encounter encounter) {
                List<Avatar> chosen = encounter.avatars().stream()
                        .filter(a -> ids.contains(Parts.id(task.id(), a.id())))
                        .toList();
                if (!chosen.isEmpty()) {
                    all.add(Encounter.of(id, encounter.actor(), encounter.start(), encounter.goal(), chosen));
                }
            } else if (!ids.contains(task.id()) && task instanceof Crowd crowd) {
                List<CrowdGroup> chosen = chosen(crowd.groups(), crowd.id(), ids, Optional.empty());
                if (!chosen.isEmpty()) {
                    all.add(Crowd.of(id, chosen));
                }
            }
        }
        return all;
    }

    /** Returns the chosen groups, each with all its parts and with the goal that it has or is given from above. */
    private static List<CrowdGroup> chosen(
            List<CrowdGroup> groups, String crowd, List<String> ids, Optional<Place> above) {
        List<CrowdGroup> all = new ArrayList<>();
        for (CrowdGroup group : groups) {
            Optional<Place> goal = group.goal().or(() -> above);
            if (ids.contains(Parts.id(crowd, group.id()))) {
                all.add(CrowdEdits.going(group, goal));
            } else {
                all.addAll(chosen(group.parts(), crowd, ids, goal));
            }
        }
        return all;
    }

    /** Tells whether a task carries parts. */
    static boolean isCarrier(Element element) {
        return element instanceof Task && element.id().startsWith(CARRIER);
    }

    /**
     * Puts what a task carries into the task that is looked at, or else the first of its kind; groups make a crowd where
     * there is none. Where there is no encounter avatars are left out.
     *
     * @param looked the id of the task that is looked at
     */
    static Pasting.Pasted into(Scene scene, Task carrier, String looked) {
        Stream<Task> tasks = Stream.concat(scene.task(looked).stream(), scene.tasks().stream());
        Optional<Task> target =
                tasks.filter(task -> task.getClass() == carrier.getClass()).findFirst();
        if (carrier instanceof Crowd crowd) {
            Task into = target.orElseGet(() -> Crowd.of(NewElements.freeId(scene, "crowd"), List.of()));
            return groups(scene, (Crowd) into, crowd.groups());
        }
        return target.isEmpty()
                ? new Pasting.Pasted(scene, List.of())
                : avatars(scene, (Encounter) target.get(), ((Encounter) carrier).avatars());
    }

    private static Pasting.Pasted avatars(Scene scene, Encounter target, List<Avatar> coming) {
        Set<Place> there = new HashSet<>();
        target.avatars().forEach(a -> Mark.start(a).ifPresent(there::add));
        double aside = 0;
        while (covered(there, coming, aside)) {
            aside += Pasting.ASIDE;
        }
        Names names = new Names(scene);
        target.avatars().forEach(a -> names.take(a.id(), a.label()));
        List<Avatar> all = new ArrayList<>(target.avatars());
        List<String> ids = new ArrayList<>();
        for (Avatar avatar : coming) {
            Avatar moved = shifted(avatar, aside);
            String id = names.id(avatar.id());
            all.add(new Avatar(
                    id,
                    names.label(avatar.label()),
                    moved.colour(),
                    moved.radius(),
                    moved.speed(),
                    moved.mobility(),
                    moved.kind(),
                    moved.motion()));
            ids.add(Parts.id(target.id(), id));
        }
        return new Pasting.Pasted(scene.with(target.among(all)), ids);
    }

    private static boolean covered(Set<Place> there, List<Avatar> coming, double aside) {
        return coming.stream()
                .anyMatch(a ->
                        Mark.start(shifted(a, aside)).filter(there::contains).isPresent());
    }

    /** Returns an avatar with its whole way shifted; a recorded one as it is. */
    private static Avatar shifted(Avatar avatar, double aside) {
        if (aside == 0 || Mark.start(avatar).isEmpty()) {
            return avatar;
        }
        Avatar moved = Mark.starting(avatar, shifted(Mark.start(avatar).get(), aside));
        if (!(moved.motion() instanceof Avatar.Script script)) {
            return moved;
        }
        List<Avatar.Head> heads = script.heads().stream()
                .map(head -> new Avatar.Head(shifted(head.to(), aside), head.at()))
                .toList();
        return Mark.moving(moved, new Avatar.Script(script.start(), script.pace(), heads));
    }

    private static Place shifted(Place place, double aside) {
        return new Place(SceneEdits.rounded(place.x() + aside), SceneEdits.rounded(place.y() - aside), place.z());
    }

    private static Pasting.Pasted groups(Scene scene, Crowd target, List<CrowdGroup> coming) {
        Set<Polygon> there = new HashSet<>();
        target.allGroups().flatMap(g -> g.members().stream()).forEach(m -> there.add(m.spawn()));
        List<Polygon> spawns = coming.stream()
                .flatMap(CrowdGroup::withParts)
                .flatMap(g -> g.members().stream())
                .map(CrowdGroup.Members::spawn)
                .toList();
        double aside = Pasting.aside(there, spawns);
        Names names = new Names(scene);
        target.allGroups().forEach(g -> names.take(g.id(), g.label()));
        List<CrowdGroup> all = new ArrayList<>(target.groups());
        List<String> ids = new ArrayList<>();
        for (CrowdGroup group : coming) {
            CrowdGroup renamed = renamed(group, names, aside);
            all.add(renamed);
            ids.add(Parts.id(target.id(), renamed.id()));
        }
        Crowd grown = target.with(all);
        boolean known = scene.task(target.id()).isPresent();
        return new Pasting.Pasted(known ? scene.with(grown) : NewElements.with(scene, grown), ids);
    }

    private static CrowdGroup renamed(CrowdGroup group, Names names, double aside) {
        return new CrowdGroup(
                names.id(group.id()),
                names.label(group.label()),
                group.colour(),
                group.goal(),
                group.members()
                        .map(m -> new CrowdGroup.Members(
                                m.count(), Pasting.shifted(m.spawn(), aside), m.floor(), m.radius(), m.speed())),
                group.parts().stream().map(part -> renamed(part, names, aside)).toList());
    }

    /** Finds ids and labels that neither the scene nor a task has. */
    private static final class Names {
        private final Set<String> ids = new HashSet<>();
        private final Set<String> labels = new HashSet<>();

        Names(Scene scene) {
            scene.elements().forEach(e -> take(e.id(), e.label()));
        }

        void take(String id, String label) {
            ids.add(id);
            labels.add(label);
        }

        String id(String wanted) {
            String stem = wanted.replaceAll("-\\d+$", "");
            String free = wanted;
            for (int number = 1; !ids.add(free); number++) {
                free = stem + "-" + number;
            }
            return free;
        }

        String label(String wanted) {
            String free = wanted;
            for (int number = 2; !wanted.isEmpty() && !labels.add(free); number++) {
                free = wanted.replaceAll(" \\d+$", "") + " " + number;
            }
            return free;
        }
    }
}
