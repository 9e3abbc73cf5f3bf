package troupe.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import troupe.geometry.Polygon;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.JourneyEngine;

/**
 * Measures what the search spaces of one search take: a suite of rooms on 256 x 256 cells with a crate in
 * each doorway, searched until there are a hundred spaces. Prints the heap that is in use after collection,
 * with the engine and without it.
 */
public final class SpacesMemory {
    private static final int SPACES = 100;
    private static final int ROOMS = 6;

    private SpacesMemory() {}

    private static Scene rooms() {
        double size = 25.6;
        double room = size / ROOMS;
        List<Obstacle> obstacles = new ArrayList<>();
        for (int i = 1; i < ROOMS; i++) {
            double x = i * room;
            obstacles.add(block("low-" + i, x - 0.1, 0, x + 0.1, 12, false));
            obstacles.add(block("high-" + i, x - 0.1, 13, x + 0.1, size, false));
            obstacles.add(block("crate-" + i, x - 0.45, 12.06, x + 0.45, 12.94, true));
        }
        Actor bare = Actor.walker("a", 0.25, 0.1);
        Actor actor = new Actor(
                "a",
                "",
                "",
                bare.bodyHeight(),
                bare.footRadius(),
                bare.stepHeight(),
                bare.maxBorder(),
                bare.walk(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.of(Actor.Move.DEFAULT));
        Journey journey = Journey.of("j", "a", Place.of(1.05, 12.45), Place.of(24.45, 12.45));
        return new Scene("", new World(size, size, 0.1), obstacles, List.of(), List.of(actor), List.of(journey));
    }

    private static Obstacle block(String id, double x0, double y0, double x1, double y1, boolean movable) {
        return new Obstacle(id, "", Polygon.rectangle(x0, y0, x1, y1), 0, 2, movable, 30, "");
    }

    /** Searches, and prints what it takes. */
    public static void main(String[] arguments) {
        Scene scene = rooms();
        JourneyEngine engine = JourneyEngine.of(scene, (Journey) scene.tasks().get(0));
        long spaces = 0;
        while (engine.outcome().isRunning() && spaces < SPACES) {
            engine.step(2_000);
            spaces = spaces(engine.run());
        }
        double with = used();
        Run run = engine.run();
        engine = null;
        double without = used();
        System.out.printf(
                Locale.ROOT,
                "%s, %d search spaces of %d x %d cells, %s labels: %.1f MB (%.1f MB with, %.1f MB without)%n",
                run.outcome().word(),
                spaces,
                scene.world().cols(),
                scene.world().rows(),
                run.report().values().get("generated"),
                with - without,
                with,
                without);
    }

    private static long spaces(Run run) {
        return ((List<?>) run.report().values().get("spaces"))
                .stream().filter(Report.class::isInstance).count();
    }

    private static double used() {
        for (int i = 0; i < 4; i++) {
            System.gc();
        }
        Runtime runtime = Runtime.getRuntime();
        return (runtime.totalMemory() - runtime.freeMemory()) / 1e6;
    }
}
