package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import troupe.app.document.Arranging;
import troupe.app.document.CrowdEdits;
import troupe.app.document.Mark;
import troupe.app.document.Parts;
import troupe.app.document.Pasting;
import troupe.app.document.SceneDocument;
import troupe.app.document.SceneEdits;
import troupe.app.document.Selection;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.property.Properties;
import troupe.app.property.Property;
import troupe.app.tool.Editing;
import troupe.app.tool.Hits;
import troupe.app.tool.Pointer;
import troupe.app.tool.Tool;
import troupe.app.tool.draw.DrawAvatarTool;
import troupe.app.tool.draw.DrawBoxTool;
import troupe.app.tool.draw.DrawGroupTool;
import troupe.app.tool.draw.DrawJourneyTool;
import troupe.app.tool.draw.DrawPolygonTool;
import troupe.app.tool.draw.PlaceTool;
import troupe.app.tool.select.SelectTool;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.paint.Viewport;
import troupe.scene.Ability;
import troupe.scene.Crowd;
import troupe.scene.Element;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

/**
 * Edits a small room at random with tools and commands, and takes everything back. The seed is that of the system
 * property {@code troupe.seed}, or a fixed one.
 */
class RandomEditsTest {
    private static final int EDITS = 500;
    private static final long SEED = Long.getLong("troupe.seed", 20_261_122L);

    private final Random random = new Random(SEED);
    private final Viewport view = new Viewport(0, 0, 100).panned(0, 800);
    private final Selection selection = new Selection();
    private final Set<String> kinds = new TreeSet<>();
    private SceneDocument document;
    private List<Tool> tools;

    private void begin() {
        document = new SceneDocument(Scenes.room(), Optional.empty());
        Look look = new Look(Theme.LIGHT, new Texts(Locale.ENGLISH));
        Editing editing = new Editing(document, selection, look, () -> view, () -> {});
        document.listeners().add(change -> selection.retain(document.shown()));
        tools = List.of(
                new SelectTool(editing),
                new DrawPolygonTool(editing, false),
                new DrawPolygonTool(editing, true),
                new DrawBoxTool(editing, false),
                new DrawBoxTool(editing, true),
                new DrawJourneyTool(editing, false),
                new DrawJourneyTool(editing, true),
                new DrawAvatarTool(editing),
                new DrawGroupTool(editing),
                new PlaceTool(editing, Hits.End.START),
                new PlaceTool(editing, Hits.End.GOAL));
    }

    private Pointer anywhere(int clicks) {
        return at(new Point(random.nextDouble() * 10, random.nextDouble() * 8), clicks);
    }

    private Pointer at(Point place, int clicks) {
        return new Pointer(
                place, view.px(place.x()), view.py(place.y()), random.nextInt(4) == 0, random.nextInt(4) == 0, clicks);
    }

    /** Picks a thing and one of its corners, the middle of an edge, or any place in it. */
    private Pointer onSomething() {
        List<Element> things = document.scene()
                .elements()
                .filter(e -> Hits.outline(e).isPresent())
                .toList();
        if (things.isEmpty()) {
            return anywhere(1);
        }
        Element thing = things.get(random.nextInt(things.size()));
        Polygon outline = Hits.outline(thing).orElseThrow();
        if (random.nextBoolean()) {
            selection.set(List.of(thing.id()));
        }
        int i = random.nextInt(outline.size());
        int j = (i + 1) % outline.size();
        return switch (random.nextInt(5)) {
            case 0, 1 -> at(new Point(outline.x(i), outline.y(i)), 1);
            case 2 -> at(new Point((outline.x(i) + outline.x(j)) / 2, (outline.y(i) + outline.y(j)) / 2), 2);
            case 3 -> knob(outline);
            default -> at(outline.centroid(), 1);
        };
    }

    /** Picks the knob above a thing, or the upper right corner of the frame. */
    private Pointer knob(Polygon outline) {
        double right = random.nextBoolean()
                ? outline.bounds().maxX() + 0.15
                : outline.centroid().x();
        boolean turn = right < outline.bounds().maxX();
        double x = turn ? (outline.bounds().minX() + outline.bounds().maxX()) / 2 : right;
        return at(new Point(x, outline.bounds().maxY() + (turn ? 0.35 : 0.15)), 1);
    }

    private void drag(Tool tool, Pointer from) {
        tool.move(from);
        tool.press(from);
        tool.drag(anywhere(1));
        Pointer to = anywhere(1);
        tool.drag(to);
        if (random.nextInt(8) == 0) {
            tool.cancel();
        }
        tool.release(to);
    }

    private void useTool() {
        Tool tool = tools.get(random.nextInt(tools.size()));
        if (tool instanceof SelectTool) {
            Pointer from = onSomething();
            if (from.clicks() == 1 && random.nextInt(3) == 0) {
                tool.press(from);
                tool.release(from);
                tool.delete();
            } else {
                drag(tool, from);
            }
        } else if (tool instanceof DrawPolygonTool || tool instanceof DrawAvatarTool) {
            for (int i = random.nextInt(4) + 2; i >= 0; i--) {
                Pointer corner = anywhere(1);
                tool.press(corner);
                tool.release(corner);
                if (random.nextInt(5) == 0) {
                    tool.stepBack();
                }
            }
            tool.finish();
        } else {
            drag(tool, anywhere(1));
            if (tool instanceof DrawGroupTool && random.nextBoolean()) {
                drag(tool, anywhere(1));
            }
            tool.finish();
        }
        tool.cancel();
        kinds.add(tool.key());
    }

    private List<String> parts() {
        return document.scene().tasks().stream().flatMap(Parts::of).toList();
    }

    /** Joins two groups of a crowd, or parts one, or takes a part away. */
    private Scene regrouped(Scene scene) {
        List<String> parts = parts();
        if (parts.isEmpty()) {
            return scene;
        }
        String id = parts.get(random.nextInt(parts.size()));
        List<String> two = List.of(id, parts.get(random.nextInt(parts.size())));
        if (!two.get(1).equals(id) && CrowdEdits.canJoin(scene, two)) {
            Crowd crowd = (Crowd) Parts.task(scene, id).orElseThrow();
            return CrowdEdits.joined(scene, two, CrowdEdits.freeId(scene, crowd), "");
        }
        boolean family =
                Parts.group(scene, id).filter(g -> !g.parts().isEmpty()).isPresent();
        return family ? CrowdEdits.parted(scene, id) : SceneEdits.removed(scene, List.of(id));
    }

    private void changeProperty() {
        List<String> all = new ArrayList<>(parts());
        document.scene().elements().map(Element::id).forEach(all::add);
        List<String> ids = new ArrayList<>();
        if (random.nextInt(6) > 0 && !all.isEmpty()) {
            ids.add(all.get(random.nextInt(all.size())));
        }
        List<Property> properties = Properties.of(document.scene(), ids).stream()
                .flatMap(g -> g.properties().stream())
                .toList();
        Property property = properties.get(random.nextInt(properties.size()));
        String text = property.choices().isEmpty()
                ? String.valueOf(Math.rint(random.nextDouble() * 40) / 10)
                : property.choices().get(random.nextInt(property.choices().size()));
        if (property.wrong(document.scene(), ids, text).isEmpty()) {
            document.commit(property.key(), property.with(document.scene(), ids, text));
            kinds.add("property." + property.row());
        }
    }

    private void command() {
        Scene scene = document.scene();
        Stream<String> places =
                scene.tasks().stream().flatMap(task -> Mark.of(task).stream()).map(Mark::id);
        List<String> ids = Stream.of(scene.elements().map(Element::id), parts().stream(), places)
                .flatMap(all -> all)
                .distinct()
                .filter(id -> random.nextInt(4) == 0)
                .toList();
        Arranging.Side side = Arranging.Side.values()[random.nextInt(6)];
        Arranging.Order order = Arranging.Order.values()[random.nextInt(4)];
        int kind = random.nextInt(8);
        Scene changed =
                switch (kind) {
                    case 0 -> Arranging.aligned(scene, ids, side);
                    case 1 -> Arranging.spread(scene, ids, random.nextBoolean());
                    case 2 -> Arranging.ordered(scene, ids, order);
                    case 3 ->
                        Pasting.into(
                                        scene,
                                        Pasting.extract(
                                                scene, ids.stream().limit(2).toList()),
                                        document.task())
                                .scene();
                    case 4 -> SceneEdits.removed(scene, ids.stream().limit(3).toList());
                    case 5 -> SceneEdits.shifted(scene, ids, 0.05, -0.5);
                    case 6 -> regrouped(scene);
                    default -> preferred(scene);
                };
        document.commit("command " + kind, changed);
        kinds.add("command " + kind);
    }

    private Scene preferred(Scene scene) {
        return scene.task(document.task())
                .filter(t -> t instanceof Journey)
                .map(t -> (Journey) t)
                .map(j -> scene.with(j.preferring(j.preferences().with(Ability.VAULT, 1 + random.nextInt(9)))))
                .orElse(scene);
    }

    private void edit() {
        int before = document.history().names().size();
        for (int tries = 0; document.history().names().size() == before; tries++) {
            assertTrue(tries < 1_000, "nothing can be edited any more");
            switch (random.nextInt(3)) {
                case 0 -> changeProperty();
                case 1 -> command();
                default -> useTool();
            }
        }
    }

    @Test
    void undoingEverythingGivesTheFirstFileAndRedoingTheLastByteForByte() {
        OnEventThread.run(() -> {
            begin();
            String first = SceneXml.write(document.scene());
            List<String> files = new ArrayList<>(List.of(first));
            for (int i = 1; i <= EDITS; i++) {
                edit();
                assertEquals(i, document.history().names().size(), "seed " + SEED);
                files.add(SceneXml.write(document.scene()));
            }
            for (int i = EDITS; i >= 1; i--) {
                assertEquals(files.get(i), SceneXml.write(document.scene()), "seed " + SEED + ", step " + i);
                document.history().stepBack();
            }
            assertEquals(first, SceneXml.write(document.scene()), "seed " + SEED);
            assertTrue(!document.isUnsaved());
            document.history().jump(EDITS);
            assertEquals(files.get(EDITS), SceneXml.write(document.scene()), "seed " + SEED);
            document.history().jump(EDITS / 2);
            assertEquals(files.get(EDITS / 2), SceneXml.write(document.scene()), "seed " + SEED);
            for (String kind : List.of(
                    "select",
                    "polygon",
                    "ditch",
                    "rectangle",
                    "circle",
                    "journey",
                    "actor",
                    "avatar",
                    "group",
                    "start")) {
                assertTrue(kinds.contains(kind), kind + " not among " + kinds);
            }
            assertTrue(kinds.size() > 30, "edits of all kinds: " + kinds);
        });
    }

    @Test
    void aThousandAndMoreStepsAreKept() {
        OnEventThread.run(() -> {
            begin();
            Scene first = document.scene();
            for (int i = 0; i < 1_500; i++) {
                document.commit("Move " + i, SceneEdits.shifted(document.scene(), List.of("crate"), 0.5, 0));
            }
            int[] shown = {0};
            document.listeners().add(change -> shown[0] += change == SceneDocument.Change.SCENE ? 1 : 0);
            document.history().jump(0);
            assertEquals(first, document.scene());
            assertEquals(1, shown[0], "a jump shows where it ends, not the steps between");
        });
    }
}
