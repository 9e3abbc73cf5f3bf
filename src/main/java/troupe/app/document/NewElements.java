package troupe.app.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.app.look.Texts;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.World;

/** Makes elements for a scene, with ids and names that are free in it. Pure but for {@link #add}. */
public final class NewElements {
    /** The height in metres of an obstacle that was just drawn: too high to vault from the ground. */
    public static final double HEIGHT = 2;

    private static final double DEPTH = 1;

    private NewElements() {}

    /** Returns the first of {@code stem-1}, {@code stem-2}, … that no element has as its id. */
    public static String freeId(Scene scene, String stem) {
        int number = 1;
        while (scene.element(stem + "-" + number).isPresent()) {
            number++;
        }
        return stem + "-" + number;
    }

    private static String label(Texts texts, String key, String id) {
        return texts.format(key, id.substring(id.lastIndexOf('-') + 1));
    }

    /** Makes an obstacle that cannot be moved. */
    public static Obstacle obstacle(Scene scene, Polygon outline, Texts texts) {
        String id = freeId(scene, "obstacle");
        return new Obstacle(id, label(texts, "new.obstacle", id), outline, 0, HEIGHT, false, Obstacle.DEFAULT_MASS, "");
    }

    /** Makes a ditch of one metre. */
    public static Ditch ditch(Scene scene, Polygon outline, Texts texts) {
        String id = freeId(scene, "ditch");
        return new Ditch(id, label(texts, "new.ditch", id), outline, DEPTH);
    }

    /** Makes an actor with all abilities. */
    public static Actor actor(Scene scene, Texts texts) {
        String id = freeId(scene, "actor");
        return Actor.standard(id).named(id, label(texts, "new.actor", id));
    }

    /** Makes a journey of an actor. */
    public static Journey journey(Scene scene, Actor actor, Place start, Place goal, Texts texts) {
        String id = freeId(scene, "journey");
        return Journey.of(id, actor.id(), start, goal).named(id, label(texts, "new.journey", id));
    }

    /** Makes an encounter of an actor, with nobody to meet yet. */
    public static Encounter encounter(Scene scene, Actor actor, Place start, Place goal, Texts texts) {
        String id = freeId(scene, "encounter");
        return Encounter.of(id, actor.id(), start, goal, List.of()).named(id, label(texts, "new.encounter", id));
    }

    /** Makes a crowd of nobody yet. */
    public static Crowd crowd(Scene scene, Texts texts) {
        String id = freeId(scene, "crowd");
        return Crowd.of(id, List.of()).named(id, label(texts, "new.crowd", id));
    }

    /** Makes an uncertain avatar with an id that neither the scene nor the encounter has. */
    public static Avatar avatar(Scene scene, Encounter encounter, Avatar.Motion motion, Texts texts) {
        int number = 1;
        while (scene.element("avatar-" + number).isPresent()
                || encounter.avatar("avatar-" + number).isPresent()) {
            number++;
        }
        Avatar made = Avatar.of("avatar-" + number, motion);
        return new Avatar(
                made.id(),
                texts.format("new.avatar", number),
                made.colour(),
                made.radius(),
                made.speed(),
                made.mobility(),
                made.kind(),
                motion);
    }

    /** Returns members of the default body, as fast as the cells of a world let them be. */
    public static CrowdGroup.Members members(World world, int count, Polygon spawn) {
        double most = Math.floor(world.cell() / Crowd.STEP_SECONDS * 100 + 1e-9) / 100;
        CrowdGroup.Members usual = CrowdGroup.Members.of(count, spawn);
        return new CrowdGroup.Members(count, spawn, usual.floor(), usual.radius(), Math.min(usual.speed(), most));
    }

    /** Makes a group of these members, with an id that neither the scene nor the crowd has. */
    public static CrowdGroup group(
            Scene scene, Crowd crowd, Optional<Place> goal, CrowdGroup.Members members, Texts texts) {
        String id = CrowdEdits.freeId(scene, crowd);
        return new CrowdGroup(id, label(texts, "new.group", id), "", goal, Optional.of(members), List.of());
    }

    /** Returns the scene with one more element, the last of its kind. */
    public static Scene with(Scene scene, Element added) {
        List<Obstacle> obstacles = new ArrayList<>(scene.obstacles());
        List<Ditch> ditches = new ArrayList<>(scene.ditches());
        List<Actor> actors = new ArrayList<>(scene.actors());
        List<Task> tasks = new ArrayList<>(scene.tasks());
        if (added instanceof Obstacle obstacle) {
            obstacles.add(obstacle);
        } else if (added instanceof Ditch ditch) {
            ditches.add(ditch);
        } else if (added instanceof Actor actor) {
            actors.add(actor);
        } else if (added instanceof Task task) {
            tasks.add(task);
        }
        return new Scene(scene.title(), scene.world(), obstacles, ditches, actors, tasks);
    }

    /** Adds an element to a document as one step, and selects it. */
    public static void add(SceneDocument document, Selection selection, Element added, Texts texts) {
        document.commit(texts.format("edit.draw", added.name()), with(document.scene(), added));
        selection.set(List.of(added.id()));
    }
}
