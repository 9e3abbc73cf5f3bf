package troupe.app.tool;

import java.awt.Cursor;
import java.awt.Graphics2D;
import troupe.paint.Viewport;

/**
 * Works on the scene with the pointer. A gesture runs from press to release, or to {@link #cancel()}, which
 * leaves no trace. What is drawn in several gestures, such as a polygon by its corners, is under way until it
 * is {@linkplain #finish() finished}, and can be {@linkplain #stepBack() taken back} part by part.
 */
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

    /** Follows the pointer while no button is down. */
    default void move(Pointer pointer) {}

    /** Tells whether something is under way that {@link #stepBack()} can take a part of back. */
    default boolean isDrawing() {
        return false;
    }

    /** Takes the last part of what is under way back. */
    default void stepBack() {}

    /** Finishes what is under way, if it is right as it stands; says otherwise in {@link #message()} why not. */
    default void finish() {}

    /** Deletes the part that was touched last, such as a corner, and tells whether there was one. */
    default boolean delete() {
        return false;
    }

    /** Returns what to tell about what is under way: what is wrong with it or how large it is; may be empty. */
    default String message() {
        return "";
    }

    /** Paints what the gesture shows besides the scene. */
    default void paint(Graphics2D g, Viewport view) {}

    /** Returns a stamp of what {@link #paint} depends on. */
    default Object stamp() {
        return "";
    }
}
