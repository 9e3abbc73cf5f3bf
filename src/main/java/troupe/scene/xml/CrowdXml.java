package troupe.scene.xml;

import static troupe.scene.Numbers.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.xml.sax.Attributes;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Numbers;

/** Reads the elements of a crowd as they come, and writes them. Used for one crowd. */
final class CrowdXml {
    private Crowd crowd;
    private final List<CrowdGroup> groups = new ArrayList<>();
    private final Deque<CrowdGroup> open = new ArrayDeque<>();

    /** Begins with the element {@code crowd}. */
    CrowdXml(String id, Attributes a) {
        Crowd.Manner d = Crowd.Manner.DEFAULT;
        Crowd.Manner manner = new Crowd.Manner(
                word(a, "motion", d.motion()),
                word(a, "split", d.split()),
                number(a, "view", d.view()),
                number(a, "bodyHeight", d.bodyHeight()),
                number(a, "stepHeight", d.stepHeight()));
        String seed = a.getValue("seed");
        crowd = new Crowd(
                id,
                plain(a, "label"),
                manner,
                Crowd.Weights.DEFAULT,
                List.of(),
                List.of(),
                number(a, "seconds", Crowd.DEFAULT_SECONDS),
                seed == null ? 1 : Numbers.whole(seed));
    }

    /** Takes the element {@code weights}. */
    void weights(Attributes a) {
        Crowd.Weights d = Crowd.Weights.DEFAULT;
        crowd = crowd.with(new Crowd.Weights(
                number(a, "separation", d.separation()),
                number(a, "cohesion", d.cohesion()),
                number(a, "alignment", d.alignment()),
                number(a, "path", d.path()),
                number(a, "anticipation", d.anticipation())));
    }

    /** Takes the element {@code relation}. */
    void relation(Attributes a) {
        int depth = Math.toIntExact(Numbers.whole(required(a, "depth")));
        crowd = crowd.with(new Crowd.Relation(
                depth, number(a, "cohesion", 1), number(a, "alignment", 1), number(a, "separation", 1)));
    }

    /** Takes the start of the element {@code group}; returns the corners that it holds. */
    int startGroup(String id, Attributes a) {
        String goal = a.getValue("goal");
        String count = a.getValue("count");
        Optional<CrowdGroup.Members> members = Optional.empty();
        if (count != null) {
            String floor = a.getValue("floor");
            members = Optional.of(new CrowdGroup.Members(
                    Math.toIntExact(Numbers.whole(count)),
                    Numbers.polygon(required(a, "spawn")),
                    floor == null ? OptionalDouble.empty() : OptionalDouble.of(Numbers.number(floor)),
                    number(a, "radius", CrowdGroup.Members.DEFAULT_RADIUS),
                    number(a, "speed", CrowdGroup.Members.DEFAULT_SPEED)));
        }
        open.push(new CrowdGroup(
                id,
                plain(a, "label"),
                plain(a, "colour"),
                Optional.ofNullable(goal).map(Numbers::place),
                members,
                List.of()));
        return members.map(m -> m.spawn().size()).orElse(0);
    }

    /** Takes the end of the element {@code group}. */
    void endGroup() {
        if (open.isEmpty()) {
            return;
        }
        CrowdGroup done = open.pop();
        if (open.isEmpty()) {
            groups.add(done);
            return;
        }
        CrowdGroup above = open.pop();
        List<CrowdGroup> parts = new ArrayList<>(above.parts());
        parts.add(done);
        open.push(new CrowdGroup(above.id(), above.label(), above.colour(), above.goal(), above.members(), parts));
    }

    /** Returns what was read. */
    Crowd crowd() {
        return crowd.with(groups);
    }

    private static <E extends Enum<E>> E word(Attributes a, String name, E absent) {
        String value = a.getValue(name);
        for (E constant : absent.getDeclaringClass().getEnumConstants()) {
            if (constant.name().toLowerCase(Locale.ROOT).equals(value)) {
                return constant;
            }
        }
        return absent;
    }

    private static String plain(Attributes a, String name) {
        String value = a.getValue(name);
        return value == null ? "" : value;
    }

    private static String required(Attributes a, String name) {
        String value = a.getValue(name);
        if (value == null) {
            throw new IllegalArgumentException("needs the attribute " + name);
        }
        return value;
    }

    private static double number(Attributes a, String name, double absent) {
        String value = a.getValue(name);
        try {
            return value == null ? absent : Numbers.number(value);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(name + ": " + e.getMessage(), e);
        }
    }

    /** Writes the content of a crowd's element: attributes, children and the end. */
    static void write(Crowd crowd, SceneWriter to) {
        Crowd.Manner m = crowd.manner();
        Crowd.Manner d = Crowd.Manner.DEFAULT;
        to.attribute("motion", m.motion().name().toLowerCase(Locale.ROOT), "anticipate");
        to.attribute("split", m.split().name().toLowerCase(Locale.ROOT), "static");
        to.attribute("view", text(m.view()), text(d.view()));
        to.attribute("bodyHeight", text(m.bodyHeight()), text(d.bodyHeight()));
        to.attribute("stepHeight", text(m.stepHeight()), text(d.stepHeight()));
        to.attribute("seconds", text(crowd.seconds()), text(Crowd.DEFAULT_SECONDS));
        to.attribute("seed", Long.toString(crowd.seed()), "1");
        to.raw(">\n");
        if (!crowd.weights().equals(Crowd.Weights.DEFAULT)) {
            weights(crowd.weights(), to);
        }
        for (Crowd.Relation r : crowd.relations()) {
            to.raw("    <relation");
            to.attribute("depth", Integer.toString(r.depth()), "");
            to.attribute("cohesion", text(r.cohesion()), "1");
            to.attribute("alignment", text(r.alignment()), "1");
            to.attribute("separation", text(r.separation()), "1");
            to.raw("/>\n");
        }
        crowd.groups().forEach(g -> group(g, "    ", to));
        to.raw("  </crowd>\n");
    }

    private static void weights(Crowd.Weights w, SceneWriter to) {
        Crowd.Weights d = Crowd.Weights.DEFAULT;
        to.raw("    <weights");
        to.attribute("separation", text(w.separation()), text(d.separation()));
        to.attribute("cohesion", text(w.cohesion()), text(d.cohesion()));
        to.attribute("alignment", text(w.alignment()), text(d.alignment()));
        to.attribute("path", text(w.path()), text(d.path()));
        to.attribute("anticipation", text(w.anticipation()), text(d.anticipation()));
        to.raw("/>\n");
    }

    private static void group(CrowdGroup g, String indent, SceneWriter to) {
        to.raw(indent + "<group");
        to.attribute("id", g.id(), null);
        to.attribute("label", g.label(), "");
        to.attribute("colour", g.colour(), "");
        g.goal().ifPresent(goal -> to.attribute("goal", text(goal), ""));
        g.members().ifPresent(m -> {
            to.attribute("count", Integer.toString(m.count()), "");
            to.attribute("radius", text(m.radius()), text(CrowdGroup.Members.DEFAULT_RADIUS));
            to.attribute("speed", text(m.speed()), text(CrowdGroup.Members.DEFAULT_SPEED));
            m.floor().ifPresent(z -> to.attribute("floor", text(z), ""));
            to.attribute("spawn", text(m.spawn()), "");
        });
        if (g.parts().isEmpty()) {
            to.raw("/>\n");
            return;
        }
        to.raw(">\n");
        g.parts().forEach(part -> group(part, indent + "  ", to));
        to.raw(indent + "</group>\n");
    }
}
