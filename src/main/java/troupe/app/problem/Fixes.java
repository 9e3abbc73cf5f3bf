package troupe.app.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import troupe.app.document.NewElements;
import troupe.app.document.Outlines;
import troupe.app.document.SceneEdits;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.SelfIntersection;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.work.inspect.BlockageSearch;

/** Finds simple changes that mend what is wrong with an element, by looking at the element. Pure; any thread. */
final class Fixes {
    private static final int MOST_TURNS = 64;

    private Fixes() {}

    static List<Fix> of(Scene scene, Problem problem) {
        Optional<Element> element = scene.element(problem.element());
        if (element.isEmpty()) {
            return List.of();
        }
        if (element.get() instanceof Journey journey) {
            Errand errand =
                    new Errand(journey.actor(), journey.start(), journey.goal(), journey::withActor, journey::between);
            return errand(scene, errand, problem);
        }
        if (element.get() instanceof Encounter met) {
            Errand errand = new Errand(met.actor(), met.start(), met.goal(), met::withActor, met::between);
            return errand(scene, errand, problem);
        }
        if (element.get() instanceof Obstacle || element.get() instanceof Ditch) {
            return shape(scene, element.get(), problem);
        }
        return List.of();
    }

    /** A task that leads one actor from a start to a goal, and how to give it another actor, or other ends. */
    private record Errand(
            String actor,
            Place start,
            Place goal,
            Function<String, Task> with,
            BiFunction<Place, Place, Task> between) {}

    private static List<Fix> errand(Scene scene, Errand errand, Problem problem) {
        List<Fix> fixes = new ArrayList<>();
        Optional<Actor> actor = scene.actor(errand.actor());
        if (actor.isEmpty()) {
            for (Actor other : scene.actors()) {
                fixes.add(new Fix(
                        "fix.actor", other.name(), scene.with(errand.with().apply(other.id()))));
            }
            if (fixes.isEmpty() && !errand.actor().isEmpty()) {
                fixes.add(new Fix(
                        "fix.newactor", errand.actor(), NewElements.with(scene, Actor.standard(errand.actor()))));
            }
            return fixes;
        }
        // avatars that are in the way, and walls between both ends, are no fault of the ends
        String message = problem.severity() == Severity.ERROR
                        && !problem.message().startsWith("avatar ")
                        && !problem.message().endsWith(" apart")
                ? problem.message()
                : "";
        if (message.contains("start ")) {
            free(scene, actor.get(), errand.start())
                    .ifPresent(place -> fixes.add(
                            new Fix("fix.start", "", scene.with(errand.between().apply(place, errand.goal())))));
        }
        if (message.contains("goal ")) {
            free(scene, actor.get(), errand.goal())
                    .ifPresent(place -> fixes.add(
                            new Fix("fix.goal", "", scene.with(errand.between().apply(errand.start(), place)))));
        }
        return fixes;
    }

    private static Optional<Place> free(Scene scene, Actor actor, Place place) {
        boolean known = Double.isFinite(place.x()) && Double.isFinite(place.y());
        return known
                ? BlockageSearch.nearestFree(scene, actor, place).filter(found -> !found.equals(place))
                : Optional.empty();
    }

    private static List<Fix> shape(Scene scene, Element element, Problem problem) {
        List<Fix> fixes = new ArrayList<>();
        Polygon outline = element instanceof Obstacle o ? o.outline() : ((Ditch) element).outline();
        if (outline.size() >= 3) {
            untangled(outline)
                    .ifPresent(simple -> fixes.add(
                            new Fix("fix.untangle", element.name(), scene.with(SceneEdits.reshaped(element, simple)))));
        }
        Polygon inside = inside(outline, scene);
        if (!inside.equals(outline)) {
            fixes.add(new Fix("fix.inside", element.name(), scene.with(SceneEdits.reshaped(element, inside))));
        }
        if (element instanceof Obstacle o && o.offset() > 0 && problem.message().contains("rests on nothing")) {
            fixes.add(new Fix(
                    "fix.ground",
                    o.name(),
                    scene.with(new Obstacle(
                            o.id(), o.label(), o.outline(), 0, o.height(), o.movable(), o.mass(), o.colour()))));
        }
        if (fixes.isEmpty() && problem.severity() == Severity.ERROR) {
            fixes.add(new Fix("fix.remove", element.name(), SceneEdits.removed(scene, List.of(element.id()))));
        }
        return fixes;
    }

    /** Moves an outline into the world as far as it fits. */
    private static Polygon inside(Polygon outline, Scene scene) {
        Box box = outline.bounds();
        double dx = Math.max(0, -box.minX())
                - Math.max(0, box.maxX() - scene.world().width());
        double dy = Math.max(0, -box.minY())
                - Math.max(0, box.maxY() - scene.world().depth());
        return dx == 0 && dy == 0 ? outline : SceneEdits.rounded(outline.shifted(dx, dy));
    }

    /**
     * Returns the outline without doubled corners and crossings, empty if it has none or they stay: of two edges
     * that cross, the corners between them are taken the other way round, which makes the outline shorter.
     */
    static Optional<Polygon> untangled(Polygon outline) {
        Polygon simple = outline;
        for (int i = 0; i < MOST_TURNS; i++) {
            Optional<SelfIntersection.Edges> meeting = SelfIntersection.find(simple);
            if (meeting.isEmpty()) {
                return i == 0 || simple.signedArea() == 0 ? Optional.empty() : Optional.of(simple);
            }
            int first = meeting.get().first();
            int second = meeting.get().second();
            boolean neighbours = first == second || second == first + 1;
            if (neighbours && simple.size() <= 3) {
                return Optional.empty();
            }
            simple = neighbours
                    ? Outlines.withoutCorner(simple, second)
                    : reversed(simple, Math.min(first, second) + 1, Math.max(first, second));
        }
        return Optional.empty();
    }

    private static Polygon reversed(Polygon outline, int from, int to) {
        Polygon turned = outline;
        for (int i = from; i <= to; i++) {
            int other = from + to - i;
            turned = Outlines.withCorner(turned, i, new Point(outline.x(other), outline.y(other)));
        }
        return turned;
    }
}
