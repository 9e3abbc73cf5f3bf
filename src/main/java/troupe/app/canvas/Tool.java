package troupe.app.canvas;

import java.awt.Cursor;
import java.awt.Graphics2D;
import troupe.paint.Viewport;

/** Works on the scene with the pointer. A gesture runs from press to release, or to {@link #cancel()}, which leaves no trace. */
public interface Tool {

    /** Returns the word for it in texts and icons: {@code select}, … */
    String key();

    /** Begins a gesture. */
    void press(Pointer pointer);

    /** Goes on with a gesture. */
    void drag(Pointer pointer);

    /** Ends a gesture: commits one edit, or none. */
    void release(Pointer pointer);

    /** Ends a gesture without a trace; does nothing when none is under way. */
    void cancel();

    /** Returns the cursor to show over a place. */
    Cursor cursor(Pointer pointer);

    /** Paints what the gesture shows besides the scene. */
    default void paint(Graphics2D g, Viewport view) {}

    /** Returns a stamp of what {@link #paint} depends on. */
    default Object stamp() {
        return "";
    }
}
