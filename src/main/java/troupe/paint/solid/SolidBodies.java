package troupe.paint.solid;

import java.awt.Color;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.motion.CrowdPainter;
import troupe.paint.motion.Track;
import troupe.run.Run;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Task;

/** Knows how large everybody in a run is and in what colour, and where its task begins and ends. Immutable. */
final class SolidBodies {
    private static final double HEIGHT = 1.7;
    private static final double RADIUS = 0.25;
    /** Colours that differ for any colour vision: Okabe and Ito 2008, without black and yellow. */
    private static final int[] COLOURS = {0xd55e00, 0x009e73, 0xcc79a7, 0x56b4e9, 0xe69f00, 0x0072b2};

    private final Run run;
    private final Theme theme;
    private final Map<String, Body> bodies = new HashMap<>();

    /** The radius and height of a body in metres, and its colour. */
    record Body(double radius, double height, Color colour) {}

    /** The places in metres where a task begins and ends. */
    record Ends(double[] start, double[] goal, double radius, Color colour) {}

    /** Looks up everybody who has a track in a run. */
    SolidBodies(Run run, Theme theme) {
        this.run = run;
        this.theme = theme;
        int unknown = 0;
        for (Track track : Track.of(run)) {
            if (!bodies.containsKey(track.owner())) {
                Optional<Body> known =
                        actor(track.owner()).or(() -> avatar(track.owner())).or(() -> member(track.owner()));
                bodies.put(
                        track.owner(),
                        known.isPresent()
                                ? known.get()
                                : new Body(RADIUS, HEIGHT, new Color(COLOURS[unknown++ % COLOURS.length])));
            }
        }
    }

    private Optional<Body> actor(String id) {
        return run.scene()
                .actor(id)
                .map(a ->
                        new Body(a.walk().radius(), a.bodyHeight(), Shapes.colour(a.colour(), theme.color(Tone.WALK))));
    }

    private Optional<Body> avatar(String id) {
        List<Avatar> avatars = run.scene().task(run.task()).orElse(null) instanceof Encounter encounter
                ? encounter.avatars()
                : List.of();
        return avatars.stream()
                .filter(a -> a.id().equals(id))
                .findFirst()
                .map(a -> new Body(
                        a.radius(),
                        HEIGHT,
                        Shapes.colour(
                                a.colour(), theme.color(a.kind() == Avatar.Kind.CERTAIN ? Tone.SIDESTEP : Tone.MOVE))));
    }

    /** Finds the body of the members of a group of a crowd, in the colour that they have in the plan. */
    private Optional<Body> member(String id) {
        if (!(run.scene().task(run.task()).orElse(null) instanceof Crowd crowd)) {
            return Optional.empty();
        }
        return crowd.allGroups()
                .filter(g -> g.id().equals(id) && g.members().isPresent())
                .findFirst()
                .map(g -> new Body(
                        g.members().get().radius(),
                        crowd.manner().bodyHeight(),
                        theme.readable(CrowdPainter.colours(crowd).get(id))));
    }

    /** Returns the body of the owner of a track. */
    Body of(String owner) {
        return bodies.getOrDefault(owner, new Body(RADIUS, HEIGHT, theme.color(Tone.WALK)));
    }

    /** Finds the ends of the task. */
    Optional<Ends> ends() {
        Task task = run.scene().task(run.task()).orElse(null);
        if (task instanceof Journey journey) {
            return Optional.of(ends(journey.actor(), journey.start(), journey.goal()));
        }
        if (task instanceof Encounter encounter) {
            return Optional.of(ends(encounter.actor(), encounter.start(), encounter.goal()));
        }
        return Optional.empty();
    }

    private Ends ends(String id, Place start, Place goal) {
        Optional<Actor> actor = run.scene().actor(id);
        List<Run.Leg> legs = run.legs();
        double first = legs.isEmpty() ? 0 : legs.get(0).points().get(0)[2];
        List<double[]> last =
                legs.isEmpty() ? List.of() : legs.get(legs.size() - 1).points();
        double end = last.isEmpty() ? 0 : last.get(last.size() - 1)[2];
        return new Ends(
                new double[] {start.x(), start.y(), start.z().orElse(first)},
                new double[] {goal.x(), goal.y(), goal.z().orElse(end)},
                actor.map(a -> a.walk().radius()).orElse(RADIUS),
                actor.map(a -> Shapes.colour(a.colour(), theme.color(Tone.WALK)))
                        .orElse(theme.color(Tone.WALK)));
    }
}
