package troupe.exchange.format;

import java.awt.Color;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import troupe.geometry.Polygon;
import troupe.run.Run;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Encounter;
import troupe.scene.Task;

/**
 * Says how large those are who act, and of what colour.
 *
 * @param radius of the disc while walking, in metres
 * @param height in metres
 */
public record Body(double radius, double height, Color colour) {
    private static final double PERSON = 1.7;
    private static final int CORNERS = 16;
    /** Colours that differ for any colour vision: Okabe and Ito 2008, without black and yellow. */
    private static final int[] COLOURS = {0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0x56b4e9, 0xe69f00};

    /** Returns the bodies of all who may act in a run, by the id that owns their channels. */
    public static Map<String, Body> of(Run run) {
        Map<String, Body> bodies = new TreeMap<>();
        for (Actor actor : run.scene().actors()) {
            bodies.put(actor.id(), new Body(actor.walk().radius(), actor.bodyHeight(), own(actor.colour(), bodies)));
        }
        Task task = run.scene().task(run.task()).orElseThrow();
        if (task instanceof Encounter encounter) {
            for (Avatar avatar : encounter.avatars()) {
                bodies.put(avatar.id(), new Body(avatar.radius(), PERSON, own(avatar.colour(), bodies)));
            }
        } else if (task instanceof Crowd crowd) {
            crowd.groups().forEach(group -> put(group, "", crowd.manner().bodyHeight(), bodies));
        }
        return bodies;
    }

    private static void put(CrowdGroup group, String above, double height, Map<String, Body> bodies) {
        String colour = group.colour().isEmpty() ? above : group.colour();
        Optional<CrowdGroup.Members> members = group.members();
        members.ifPresent(m -> bodies.put(group.id(), new Body(m.radius(), height, own(colour, bodies))));
        group.parts().forEach(part -> put(part, colour, height, bodies));
    }

    private static Color own(String colour, Map<String, Body> before) {
        return colour.isEmpty() ? new Color(COLOURS[before.size() % COLOURS.length]) : Color.decode(colour);
    }

    /** Returns the outline about the origin: a disc with a beak towards +x, counter-clockwise. */
    public Polygon outline() {
        double[] xs = new double[CORNERS];
        double[] ys = new double[CORNERS];
        for (int k = 0; k < CORNERS; k++) {
            double angle = 2 * Math.PI * k / CORNERS;
            double reach = k == 0 ? 1.4 * radius : radius;
            xs[k] = reach * StrictMath.cos(angle);
            ys[k] = reach * StrictMath.sin(angle);
        }
        return new Polygon(xs, ys);
    }
}
