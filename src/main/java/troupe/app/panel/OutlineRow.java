package troupe.app.panel;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import troupe.app.document.Mark;
import troupe.app.document.Parts;
import troupe.app.document.SceneEdits;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.plan.Plan;
import troupe.app.plan.Views;
import troupe.app.session.OverlayChoice;
import troupe.app.session.Session;
import troupe.geometry.Box;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.motion.CrowdPainter;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Ditch;
import troupe.scene.Encounter;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;

/**
 * One row of the outline. Things of one size whose ids differ in a number at the end only, three or more, share a row.
 *
 * @param ids what it stands for, empty for a heading or a layer
 * @param hint what to do about a problem
 * @param depth how far it stands in: 0, more for the parts of a task
 */
record OutlineRow(
        Kind kind,
        List<String> ids,
        String name,
        String note,
        Color color,
        boolean round,
        int layer,
        String hint,
        int depth) {
    private static final int GROUP = 3;
    private static final int LAYERS = 6;
    private static final int PARTS = 40;

    /** What a row stands for. */
    enum Kind {
        HEADING,
        LAYER,
        THING,
        TASK,
        PROBLEM
    }

    /** Returns the rows for a session. */
    static List<OutlineRow> of(Session session, Look look) {
        Scene scene = session.document().shown();
        List<OutlineRow> rows = new ArrayList<>();
        addLayers(rows, session, look);
        rows.add(heading(look, "outline.actors"));
        for (Actor actor : scene.actors()) {
            String note = actor.abilities().size() == 1
                    ? look.text("outline.ability")
                    : look.texts().format("outline.abilities", actor.abilities().size());
            rows.add(thing(List.of(actor.id()), actor.name(), note, look.color(Tone.WALK), true));
        }
        rows.add(heading(look, "outline.obstacles"));
        addObstacles(rows, scene, look);
        for (Ditch ditch : scene.ditches()) {
            rows.add(thing(
                    List.of(ditch.id()), ditch.name(), look.text("outline.ditch"), look.color(Tone.DITCH), false));
        }
        rows.add(heading(look, "outline.tasks"));
        for (Task task : scene.tasks()) {
            boolean shown = task.id().equals(session.document().task());
            Color color = look.color(shown ? Tone.ACCENT : Tone.DIM);
            String kind = look.texts().get("outline." + task.kind(), task.kind());
            rows.add(new OutlineRow(Kind.TASK, List.of(task.id()), task.name(), kind, color, false, 0, "", 0));
            if (shown) {
                addParts(rows, task, look);
            }
        }
        addProblems(rows, session, look);
        return rows;
    }

    /** Adds the avatars of an encounter, or the groups of a crowd, each below the one it belongs to. */
    private static void addParts(List<OutlineRow> rows, Task task, Look look) {
        if (task instanceof Encounter encounter) {
            encounter.avatars().stream().limit(PARTS).forEach(avatar -> {
                String note = avatar.motion() instanceof Avatar.Pointer
                        ? look.text("outline.steered")
                        : avatar.motion() instanceof Avatar.Recording
                                ? look.text("outline.recorded")
                                : look.texts()
                                        .format(
                                                "outline.way",
                                                Mark.heads(avatar).size());
                Color own = look.color(avatar.kind() == Avatar.Kind.CERTAIN ? Tone.SIDESTEP : Tone.MOVE);
                rows.add(part(Parts.id(task.id(), avatar.id()), avatar.name(), note, own, 1));
            });
        } else if (task instanceof Crowd crowd) {
            Map<String, Color> colours = CrowdPainter.colours(crowd);
            crowd.groups().forEach(group -> addGroup(rows, task, group, colours, 1, look));
        }
    }

    private static void addGroup(
            List<OutlineRow> rows, Task task, CrowdGroup group, Map<String, Color> colours, int depth, Look look) {
        String note = group.members().isPresent()
                ? look.texts().format("outline.people", group.members().get().count())
                : look.texts().format("outline.groups", group.parts().size());
        Color own = readable(colours.get(group.id()), look);
        rows.add(part(Parts.id(task.id(), group.id()), Parts.name(group), note, own, depth));
        group.parts().forEach(p -> addGroup(rows, task, p, colours, depth + 1, look));
    }

    private static OutlineRow part(String id, String name, String note, Color color, int depth) {
        return new OutlineRow(Kind.THING, List.of(id), name, note, color, true, 0, "", depth);
    }

    private static void addLayers(List<OutlineRow> rows, Session session, Look look) {
        List<Views.Layer> layers = session.plan().map(p -> p.views().layers()).orElse(List.of());
        rows.add(heading(look, "outline.layers"));
        if (layers.size() != 1) {
            rows.add(layer(look.text("outline.layers.all"), "", look.color(Tone.STEP), OverlayChoice.ALL_LAYERS));
        }
        IntStream.range(0, layers.size())
                .filter(i -> layers.size() == 1 || layers.get(i).cells() > 0)
                .boxed()
                .sorted(Comparator.comparingInt(i -> -layers.get(i).cells()))
                .limit(LAYERS)
                .forEach(i -> {
                    Views.Layer layer = layers.get(i);
                    boolean ground = layer.on().isEmpty();
                    String name = ground ? look.text("outline.ground") : name(session, layer.on());
                    long same = rows.stream()
                            .filter(row ->
                                    row.kind() == Kind.LAYER && row.name().matches("\\Q" + name + "\\E( \\d+)?"))
                            .count();
                    int stands = layers.size() == 1 ? OverlayChoice.ALL_LAYERS : i;
                    rows.add(layer(
                            same == 0 ? name : name + " " + (same + 1),
                            range(layer),
                            look.color(ground ? Tone.FLOOR : Tone.DECK),
                            stands));
                });
    }

    private static String name(Session session, String id) {
        return SceneEdits.name(session.document().shown(), id);
    }

    private static String range(Views.Layer layer) {
        if (Double.isNaN(layer.lowest())) {
            return "";
        }
        String lowest = Texts.number(layer.lowest(), 1);
        String highest = Texts.number(layer.highest(), 1);
        return (lowest.equals(highest) ? lowest : lowest + " \u2026 " + highest) + " m";
    }

    private static void addObstacles(List<OutlineRow> rows, Scene scene, Look look) {
        Map<String, List<Obstacle>> groups = new LinkedHashMap<>();
        for (Obstacle obstacle : scene.obstacles()) {
            groups.computeIfAbsent(stem(obstacle), key -> new ArrayList<>()).add(obstacle);
        }
        for (Map.Entry<String, List<Obstacle>> group : groups.entrySet()) {
            List<Obstacle> members = group.getValue();
            if (members.size() >= GROUP) {
                List<String> ids = members.stream().map(Obstacle::id).toList();
                rows.add(thing(
                        ids,
                        groupName(members.get(0)),
                        String.valueOf(ids.size()),
                        color(members.get(0), look),
                        false));
            } else {
                for (Obstacle o : members) {
                    String note = o.movable() ? look.text("outline.movable") : Texts.number(o.top(), 1) + " m";
                    rows.add(thing(List.of(o.id()), o.name(), note, color(o, look), false));
                }
            }
        }
    }

    /** Returns what is the same of things that share a row: the id but for its number, mobility, and label or size. */
    private static String stem(Obstacle obstacle) {
        String stem = obstacle.id().replaceAll("-?\\d+$", "");
        if (stem.equals(obstacle.id())) {
            return "=" + stem;
        }
        Box box = obstacle.outline().bounds();
        boolean named = !obstacle.label().isEmpty() && !obstacle.label().matches(".*\\d");
        String alike = named ? obstacle.label() : Math.round(box.width() * 100) + " " + Math.round(box.depth() * 100);
        return stem + " " + obstacle.movable() + " " + alike;
    }

    private static String groupName(Obstacle first) {
        String name = first.name().replaceAll("[\\s-]*\\d+$", "");
        return name.isEmpty() ? first.name() : name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1);
    }

    private static Color color(Obstacle obstacle, Look look) {
        if (obstacle.colour().matches("#[0-9a-fA-F]{6}")) {
            return readable(Color.decode(obstacle.colour()), look);
        }
        if (obstacle.movable()) {
            return look.color(Tone.WOOD);
        }
        return look.color(obstacle.offset() > 0 ? Tone.DECK : obstacle.top() <= 1.3 ? Tone.LOW : Tone.WALL);
    }

    /** Returns the colour, lightened where it would not stand out from a dark panel. */
    private static Color readable(Color color, Look look) {
        boolean dim = look.theme() == Theme.DARK && color.getRed() + color.getGreen() + color.getBlue() < 300;
        return dim ? Look.mix(color, look.color(Tone.TEXT), 0.65) : color;
    }

    private static void addProblems(List<OutlineRow> rows, Session session, Look look) {
        rows.add(heading(look, "outline.problems"));
        List<Problem> problems = session.plan().map(Plan::problems).orElse(List.of());
        if (problems.isEmpty()) {
            rows.add(new OutlineRow(
                    Kind.PROBLEM,
                    List.of(),
                    look.text("outline.problems.none"),
                    "",
                    look.color(Tone.SKELETON),
                    true,
                    0,
                    "",
                    0));
        }
        for (Problem problem : problems) {
            Tone tone = problem.severity() == Severity.ERROR ? Tone.MOVE : Tone.VAULT;
            List<String> ids = problem.element().isEmpty() ? List.of() : List.of(problem.element());
            String hint = PlanWords.problem(problem, look.texts());
            String message = look.texts().tell(problem.message());
            String name = ids.isEmpty() ? message : problem.element() + ": " + message;
            rows.add(new OutlineRow(Kind.PROBLEM, ids, name, "", look.color(tone), true, 0, hint, 0));
        }
    }

    private static OutlineRow heading(Look look, String key) {
        return new OutlineRow(Kind.HEADING, List.of(), look.text(key), "", look.color(Tone.DIM), false, 0, "", 0);
    }

    private static OutlineRow layer(String name, String note, Color color, int layer) {
        return new OutlineRow(Kind.LAYER, List.of(), name, note, color, false, layer, "", 0);
    }

    private static OutlineRow thing(List<String> ids, String name, String note, Color color, boolean round) {
        return new OutlineRow(Kind.THING, ids, name, note, color, round, 0, "", 0);
    }
}
