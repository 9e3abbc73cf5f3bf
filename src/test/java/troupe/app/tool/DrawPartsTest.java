package troupe.app.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import org.junit.jupiter.api.Test;
import troupe.app.OnEventThread;
import troupe.app.Scenes;
import troupe.app.document.SceneDocument;
import troupe.app.document.Selection;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.tool.draw.DrawAvatarTool;
import troupe.app.tool.draw.DrawGroupTool;
import troupe.app.tool.select.SelectTool;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.paint.Viewport;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Encounter;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.check.SceneChecks;

/** One metre is a hundred pixels. */
class DrawPartsTest {
    private final Viewport view = new Viewport(0, 8, 100);
    private final Selection selection = new Selection();

    private void with(Scene scene, BiConsumer<SceneDocument, Editing> check) {
        OnEventThread.run(() -> {
            SceneDocument document = new SceneDocument(scene, Optional.empty());
            document.listeners().add(change -> selection.retain(document.shown()));
            check.accept(
                    document,
                    new Editing(
                            document,
                            selection,
                            new Look(Theme.LIGHT, new Texts(Locale.ENGLISH)),
                            () -> view,
                            () -> {}));
        });
    }

    private Pointer at(double x, double y, int clicks) {
        return new Pointer(new Point(x, y), view.px(x), view.py(y), false, false, clicks);
    }

    private void click(Tool tool, double x, double y) {
        tool.move(at(x, y, 1));
        tool.press(at(x, y, 1));
        tool.release(at(x, y, 1));
    }

    private void drag(Tool tool, double x, double y, double toX, double toY) {
        tool.press(at(x, y, 1));
        tool.drag(at((x + toX) / 2, (y + toY) / 2, 1));
        tool.drag(at(toX, toY, 1));
        tool.release(at(toX, toY, 1));
    }

    private static Encounter encounter(SceneDocument document) {
        return (Encounter) document.scene().task("encounter-1").orElseThrow();
    }

    private static Crowd crowd(SceneDocument document) {
        return (Crowd) document.scene().task("crowd-1").orElseThrow();
    }

    private static Avatar.Head head(double x, double y) {
        return new Avatar.Head(Place.of(x, y), OptionalDouble.empty());
    }

    @Test
    void anAvatarIsDrawnPlaceByPlaceAndIsOneStep() {
        with(Scenes.room(), (document, editing) -> {
            Scene before = document.scene();
            DrawAvatarTool tool = new DrawAvatarTool(editing);
            click(tool, 2, 5);
            click(tool, 4, 5);
            click(tool, 5, 6);
            tool.stepBack();
            click(tool, 6, 5);
            assertSame(before, document.shown());
            tool.finish();
            Encounter made = encounter(document);
            assertEquals(Place.of(1, 1), made.start());
            assertEquals("ann", made.actor());
            assertEquals(
                    new Avatar.Script(Place.of(2, 5), Avatar.DEFAULT_PACE, List.of(head(4, 5), head(6, 5))),
                    made.avatars().get(0).motion());
            assertEquals("encounter-1", document.task());
            assertEquals(List.of("encounter-1/avatar-1"), selection.ids());
            assertEquals(List.of("Draw Avatar 1"), document.history().names());
            click(tool, 7, 5);
            tool.press(at(7, 5, 2));
            tool.release(at(7, 5, 2));
            assertEquals(
                    new Avatar.Pointer(Place.of(7, 5)),
                    encounter(document).avatars().get(1).motion());
            assertEquals(List.of(), SceneChecks.check(document.scene()));
            document.history().stepBack();
            document.history().stepBack();
            assertEquals(before, document.scene());
            assertEquals(List.of(), selection.ids());
        });
    }

    @Test
    void escapeWhileAnAvatarOrAGroupIsDrawnLeavesNoTrace() {
        with(Scenes.room(), (document, editing) -> {
            Scene before = document.scene();
            DrawAvatarTool avatar = new DrawAvatarTool(editing);
            click(avatar, 2, 5);
            click(avatar, 4, 5);
            avatar.cancel();
            avatar.finish();
            DrawGroupTool group = new DrawGroupTool(editing);
            drag(group, 2, 4, 4, 6);
            assertTrue(group.isDrawing());
            group.cancel();
            group.finish();
            assertFalse(group.isDrawing());
            assertSame(before, document.shown());
            assertEquals(List.of(), document.history().names());
        });
    }

    @Test
    void aSceneWithoutActorsGetsOneForTheEncounter() {
        Scene empty = new Scene("", new World(12, 8, 0.1), List.of(), List.of(), List.of(), List.of());
        with(empty, (document, editing) -> {
            DrawAvatarTool tool = new DrawAvatarTool(editing);
            click(tool, 6, 6);
            tool.finish();
            assertEquals("actor-1", encounter(document).actor());
            assertEquals(Place.of(2, 4), encounter(document).start());
            assertEquals(Place.of(10, 4), encounter(document).goal());
            assertEquals(List.of(), SceneChecks.check(document.scene()));
        });
    }

    @Test
    void placesOfAvatarsAreDraggedWithEitherTool() {
        with(Scenes.room(), (document, editing) -> {
            DrawAvatarTool tool = new DrawAvatarTool(editing);
            click(tool, 2, 5);
            click(tool, 4, 5);
            tool.finish();
            drag(tool, 2, 5, 2.5, 5.5);
            SelectTool select = new SelectTool(editing);
            drag(select, 4, 5, 6, 5);
            drag(select, 1, 1, 1.5, 1);
            Avatar.Script script =
                    (Avatar.Script) encounter(document).avatars().get(0).motion();
            assertEquals(Place.of(2.5, 5.5), script.start());
            assertEquals(List.of(head(6, 5)), script.heads());
            assertEquals(Place.of(1.5, 1), encounter(document).start());
            assertEquals(
                    List.of("Draw Avatar 1", "Move Avatar 1", "Move the way of Avatar 1", "Move the start"),
                    document.history().names());
        });
    }

    @Test
    void aGroupIsAnAreaAndAGoalAndTheNextOneCanShareIt() {
        with(Scenes.room(), (document, editing) -> {
            DrawGroupTool tool = new DrawGroupTool(editing);
            click(tool, 5, 5);
            assertEquals("Drag from corner to corner of the area where they stand", tool.message());
            drag(tool, 1, 2, 3, 5);
            tool.finish();
            assertEquals("Nobody has a goal yet: click where they go", tool.message());
            assertEquals(List.of(), document.history().names());
            click(tool, 9, 7);
            CrowdGroup first = crowd(document).groups().get(0);
            assertEquals(Optional.of(Place.of(9, 7)), first.goal());
            assertEquals(
                    Polygon.rectangle(1, 2, 3, 5), first.members().orElseThrow().spawn());
            assertEquals(5, first.members().orElseThrow().count());
            assertEquals("crowd-1", document.task());
            drag(tool, 1, 5.2, 3, 6);
            tool.finish();
            assertEquals(first.goal(), crowd(document).groups().get(1).goal());
            assertEquals(
                    List.of("Draw Group 1", "Draw Group 2"), document.history().names());
            assertEquals(List.of(), SceneChecks.check(document.scene()));
        });
    }

    @Test
    void membersAreNoFasterThanTheCellsLetThemBe() {
        Scene fine = Scenes.room().with(new World(10, 8, 0.05));
        with(fine, (document, editing) -> {
            DrawGroupTool tool = new DrawGroupTool(editing);
            drag(tool, 1, 2, 3, 5);
            click(tool, 9, 7);
            assertEquals(
                    1.25,
                    crowd(document).groups().get(0).members().orElseThrow().speed());
            assertEquals(List.of(), SceneChecks.check(document.scene()));
        });
    }

    @Test
    void theAreaOfAGroupIsMovedBentAndItsGoalDragged() {
        with(Scenes.room(), (document, editing) -> {
            DrawGroupTool tool = new DrawGroupTool(editing);
            drag(tool, 1, 2, 3, 5);
            click(tool, 9, 7);
            SelectTool select = new SelectTool(editing);
            drag(select, 2, 3, 2.5, 3);
            drag(select, 3.5, 5, 3.5, 6);
            drag(select, 9, 7, 8.5, 7.5);
            CrowdGroup group = crowd(document).groups().get(0);
            assertEquals(
                    Polygon.of(1.5, 2, 3.5, 2, 3.5, 6, 1.5, 5),
                    group.members().orElseThrow().spawn());
            assertEquals(Optional.of(Place.of(8.5, 7.5)), group.goal());
            assertEquals(
                    List.of("Draw Group 1", "Move Group 1", "Bend Group 1", "Goal of Group 1"),
                    document.history().names());
        });
    }
}
