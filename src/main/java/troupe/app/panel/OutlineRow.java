package troupe.app.panel;

import java.awt.Color;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.plan.Plan;
import troupe.app.session.OverlayChoice;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.run.Overlay;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Problem;
import troupe.scene.Scene;
import troupe.scene.Severity;
import troupe.scene.Task;

/**
 * One row of the outline. Things whose ids differ in a number at the end only, three or more, share a row.
 *
 * @param ids what it stands for, empty for a heading or a layer
 * @param hint what to do about a problem
 */
record OutlineRow(
        Kind kind, List<String> ids, String name, String note, Color color, boolean round, int layer, String hint) {
    private static final int GROUP = 3;

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
            String note =
                    look.texts().format("outline.abilities", actor.abilities().size());
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
            rows.add(new OutlineRow(Kind.TASK, List.of(task.id()), task.name(), kind, color, false, 0, ""));
        }
        addProblems(rows, session, look);
        return rows;
    }

    private static void addLayers(List<OutlineRow> rows, Session session, Look look) {
        List<Overlay> overlays = session.plan().map(Plan::overlays).orElse(List.of());
        int layers = 1 + overlays.stream().mapToInt(Overlay::layer).max().orElse(0);
        rows.add(heading(look, "outline.layers"));
        if (layers > 1) {
            rows.add(layer(look.text("outline.layers.all"), look.color(Tone.STEP), OverlayChoice.ALL_LAYERS));
        }
        for (int i = 0; i < layers; i++) {
            String name = i == 0 ? look.text("outline.ground") : look.texts().format("outline.layer", i);
            int stands = layers == 1 ? OverlayChoice.ALL_LAYERS : i;
            rows.add(layer(name, look.color(i == 0 ? Tone.FLOOR : Tone.DECK), stands));
        }
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

    private static String stem(Obstacle obstacle) {
        String stem = obstacle.id().replaceAll("-?\\d+$", "");
        return stem.equals(obstacle.id()) ? "=" + stem : stem;
    }

    private static String groupName(Obstacle first) {
        String name = first.name().replaceAll("[\\s-]*\\d+$", "");
        return name.isEmpty() ? first.name() : name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1);
    }

    private static Color color(Obstacle obstacle, Look look) {
        if (obstacle.colour().matches("#[0-9a-fA-F]{6}")) {
            return Color.decode(obstacle.colour());
        }
        if (obstacle.movable()) {
            return look.color(Tone.WOOD);
        }
        return look.color(obstacle.offset() > 0 ? Tone.DECK : obstacle.top() <= 1.3 ? Tone.LOW : Tone.WALL);
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
                    ""));
        }
        for (Problem problem : problems) {
            Tone tone = problem.severity() == Severity.ERROR ? Tone.MOVE : Tone.VAULT;
            List<String> ids = problem.element().isEmpty() ? List.of() : List.of(problem.element());
            String hint = problem.message() + " " + problem.cure();
            rows.add(new OutlineRow(Kind.PROBLEM, ids, problem.message(), "", look.color(tone), true, 0, hint));
        }
    }

    private static OutlineRow heading(Look look, String key) {
        return new OutlineRow(Kind.HEADING, List.of(), look.text(key), "", look.color(Tone.DIM), false, 0, "");
    }

    private static OutlineRow layer(String name, Color color, int layer) {
        return new OutlineRow(Kind.LAYER, List.of(), name, "", color, false, layer, "");
    }

    private static OutlineRow thing(List<String> ids, String name, String note, Color color, boolean round) {
        return new OutlineRow(Kind.THING, ids, name, note, color, round, 0, "");
    }
}
