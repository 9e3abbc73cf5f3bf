package troupe.app.canvas;

import java.util.function.Supplier;
import troupe.app.document.SceneDocument;
import troupe.app.document.Selection;
import troupe.app.look.Texts;
import troupe.paint.Viewport;

/** Holds what tools work with: the document, the selection, the texts for names of edits, and the present view. */
public record Editing(SceneDocument document, Selection selection, Texts texts, Supplier<Viewport> view) {}
