package troupe.app.tool;

import java.util.function.Supplier;
import troupe.app.document.SceneDocument;
import troupe.app.document.Selection;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.paint.Viewport;

/**
 * Holds what tools work with.
 *
 * @param view the present view
 * @param drawn what to do when something new was drawn: by custom, to take the selecting tool in hand
 */
public record Editing(SceneDocument document, Selection selection, Look look, Supplier<Viewport> view, Runnable drawn) {

    /** Returns the texts, for the names of edits. */
    public Texts texts() {
        return look.texts();
    }

    /** Returns the size of a pixel in metres. */
    public double pixel() {
        return 1 / view.get().scale();
    }
}
