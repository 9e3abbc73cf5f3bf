package troupe.scene;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import troupe.scene.check.SceneChecks;

/**
 * Holds a whole scene document: the world, what stands in it, who acts and what is to be planned.
 * Immutable; the lists keep the order of the document and are copied. A scene may hold mistakes (a
 * twisted polygon, a goal in a wall): {@link SceneChecks} names them all at once.
 */
public record Scene(
        String title,
        World world,
        List<Obstacle> obstacles,
        List<Ditch> ditches,
        List<Actor> actors,
        List<Task> tasks) {

    /** Copies the lists. */
    public Scene {
        obstacles = List.copyOf(obstacles);
        ditches = List.copyOf(ditches);
        actors = List.copyOf(actors);
        tasks = List.copyOf(tasks);
    }

    /** Finds an element of any kind by its id. Cost O(n). */
    public Optional<Element> element(String id) {
        return elements().filter(e -> e.id().equals(id)).findFirst();
    }

    /** Finds the actor with the given id. Cost O(n). */
    public Optional<Actor> actor(String id) {
        return actors.stream().filter(a -> a.id().equals(id)).findFirst();
    }

    /** Finds the obstacle with the given id. Cost O(n). */
    public Optional<Obstacle> obstacle(String id) {
        return obstacles.stream().filter(o -> o.id().equals(id)).findFirst();
    }

    /** Finds the task with the given id. Cost O(n). */
    public Optional<Task> task(String id) {
        return tasks.stream().filter(t -> t.id().equals(id)).findFirst();
    }

    /** Returns all elements in document order: obstacles, ditches, actors, tasks. */
    public Stream<Element> elements() {
        return Stream.of(obstacles, ditches, actors, tasks).flatMap(List::stream);
    }

    /** Returns this scene with the element of the same id replaced; the scene itself if it holds none. */
    public Scene with(Element changed) {
        return new Scene(
                title,
                world,
                replaced(obstacles, changed),
                replaced(ditches, changed),
                replaced(actors, changed),
                replaced(tasks, changed));
    }

    /** Returns this scene with another world. */
    public Scene with(World changed) {
        return new Scene(title, changed, obstacles, ditches, actors, tasks);
    }

    @SuppressWarnings("unchecked")
    private static <T extends Element> List<T> replaced(List<T> list, Element changed) {
        return list.stream()
                .map(e -> e.id().equals(changed.id()) && e.getClass() == changed.getClass() ? (T) changed : e)
                .toList();
    }
}
