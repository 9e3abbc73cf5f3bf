package troupe.app.tool.select;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.app.OnEventThread;
import troupe.app.Scenes;
import troupe.app.document.SceneDocument;
import troupe.app.document.Selection;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.tool.Editing;
import troupe.app.tool.Pointer;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.paint.Viewport;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;

/** One metre is a hundred pixels; the upper left corner of the view is the upper left corner of the room. */
class SelectToolTest {
    private final Viewport view = new Viewport(0, 8, 100);
    private final Selection selection = new Selection();

    private interface Check {
        void check(SceneDocument document, SelectTool tool);
    }

    private void with(Check check) {
        OnEventThread.run(() -> {
            SceneDocument document = new SceneDocument(Scenes.room(), Optional.empty());
            Editing editing = new Editing(
                    document, selection, new Look(Theme.LIGHT, new Texts(Locale.ENGLISH)), () -> view, () -> {});
            check.check(document, new SelectTool(editing));
        });
    }

    private Pointer at(double x, double y) {
        return at(x, y, false);
    }

    private Pointer at(double x, double y, boolean shift) {
        return new Pointer(new troupe.geometry.Point(x, y), view.px(x), view.py(y), shift, false);
    }

    private static Polygon crate(Scene scene) {
        return scene.obstacle("crate").orElseThrow().outline();
    }

    @Test
    void draggingPreviewsAndCommitsOneEdit() {
        with((document, tool) -> {
            Scene before = document.scene();
            tool.press(at(4.5, 3.5));
            assertEquals(List.of("crate"), selection.ids());
            tool.drag(at(5, 3.5));
            tool.drag(at(5.504, 4.5));
            assertEquals(
                    Polygon.rectangle(5, 4, 6, 5).bounds().minX(),
                    crate(document.shown()).bounds().minX(),
                    1e-9);
            assertSame(before, document.scene());
            tool.release(at(5.504, 4.5));
            assertEquals(Polygon.rectangle(5, 4, 6, 5), crate(document.scene()));
            assertEquals(List.of("Move crate"), document.history().names());
            document.history().stepBack();
            assertSame(before, document.scene());
        });
    }

    @Test
    void escapeLeavesNoTrace() {
        with((document, tool) -> {
            Scene before = document.scene();
            tool.press(at(4.5, 3.5));
            tool.drag(at(6, 6));
            tool.cancel();
            assertSame(before, document.shown());
            tool.release(at(6, 6));
            assertSame(before, document.scene());
            assertFalse(document.history().canUndo());
        });
    }

    @Test
    void aClickSelectsAndDoesNotMove() {
        with((document, tool) -> {
            tool.press(at(4.5, 3.5));
            tool.drag(at(4.52, 3.5));
            tool.release(at(4.52, 3.5));
            assertFalse(document.history().canUndo());
            tool.press(at(2, 2));
            tool.release(at(2, 2));
            assertEquals(List.of(), selection.ids());
        });
    }

    @Test
    void shiftKeepsMultiplesOf45Degrees() {
        with((document, tool) -> {
            tool.press(at(4.5, 3.5));
            tool.drag(at(6.5, 3.6));
            tool.drag(at(6.5, 3.6, true));
            tool.release(at(6.5, 3.6, true));
            assertEquals(Polygon.rectangle(6, 3, 7, 4), crate(document.scene()));
        });
    }

    @Test
    void shiftSelectsSeveralWhichMoveTogether() {
        with((document, tool) -> {
            tool.press(at(4.5, 3.5));
            tool.release(at(4.5, 3.5));
            tool.press(at(7.2, 6.2, true));
            tool.drag(at(8.2, 6.2));
            tool.release(at(8.2, 6.2));
            assertEquals(Polygon.rectangle(5, 3, 6, 4), crate(document.scene()));
            assertEquals(
                    8,
                    document.scene()
                            .obstacle("post")
                            .orElseThrow()
                            .outline()
                            .bounds()
                            .minX());
            assertEquals(List.of("Move 2 things"), document.history().names());
        });
    }

    @Test
    void aBoxSelectsWhatItHolds() {
        with((document, tool) -> {
            tool.press(at(3, 2));
            tool.drag(at(5.5, 5));
            tool.release(at(5.5, 5));
            assertEquals(List.of("crate"), selection.ids());
            tool.press(at(4.5, 1));
            tool.drag(at(9.5, 7.5));
            tool.release(at(9.5, 7.5));
            assertEquals(List.of("post", "there#goal"), selection.ids());
        });
    }

    @Test
    void startAndGoalAreDragged() {
        with((document, tool) -> {
            tool.press(at(1.05, 1));
            tool.drag(at(2.05, 1.5));
            tool.release(at(2.05, 1.5));
            Journey journey = (Journey) document.scene().task("there").orElseThrow();
            assertEquals(Place.of(2, 1.5), journey.start());
            tool.press(at(9, 1));
            tool.drag(at(8, 1));
            tool.release(at(8, 1));
            journey = (Journey) document.scene().task("there").orElseThrow();
            assertEquals(Place.of(8, 1), journey.goal());
            assertEquals(
                    List.of("Move the start", "Move the goal"),
                    document.history().names());
            assertTrue(document.isUnsaved());
        });
    }
}
