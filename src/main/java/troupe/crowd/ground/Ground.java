package troupe.crowd.ground;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import troupe.grid.field.Nf2;
import troupe.scene.Crowd;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Builds terrains and ways when they are first asked for: one terrain for each radius, one way for each goal and radius. */
public final class Ground {
    private final Scene scene;
    private final Crowd crowd;
    private final List<Laid> laid = new ArrayList<>();

    /** A terrain and the ways over it. */
    private record Laid(Terrain terrain, Nf2 nf2, List<Way> ways) {}

    /** Makes the ground of a crowd; nothing is computed yet. */
    public Ground(Scene scene, Crowd crowd) {
        this.scene = scene;
        this.crowd = crowd;
    }

    /** Returns the terrain of agents of a radius in metres. */
    public Terrain terrain(double radius) {
        return laid(radius).terrain();
    }

    private Laid laid(double radius) {
        for (Laid known : laid) {
            if (known.terrain().radius() == radius) {
                return known;
            }
        }
        Terrain terrain = new Terrain(scene, crowd, radius);
        Laid made = new Laid(terrain, new Nf2(terrain.region()), new ArrayList<>());
        laid.add(made);
        return made;
    }

    /** Returns all ways so far, in the order in which they were asked for. */
    public List<Way> ways() {
        return laid.stream().flatMap(l -> l.ways().stream()).toList();
    }

    /** Returns the way of agents of a radius to a goal; empty if they cannot stand there. */
    public Optional<Way> way(Place goal, double radius) {
        Laid on = laid(radius);
        int span = on.terrain().region().locate(goal);
        if (span < 0 || !on.terrain().open(span)) {
            return Optional.empty();
        }
        for (Way known : on.ways()) {
            if (known.goal() == span) {
                return Optional.of(known);
            }
        }
        Way made = new Way(on.terrain(), on.nf2(), span);
        on.ways().add(made);
        return Optional.of(made);
    }

    /** Returns why there is no way to a goal, in words that a person can act on. */
    public static String unreachable(String group, Place goal, double radius) {
        return String.format(
                Locale.ROOT,
                "an agent of '%s' with radius %.2f m cannot stand at its goal %.2f,%.2f; move the goal into the open",
                group,
                radius,
                goal.x(),
                goal.y());
    }
}
