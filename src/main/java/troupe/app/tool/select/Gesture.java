package troupe.app.tool.select;

import java.util.Optional;
import troupe.app.tool.Guide;
import troupe.app.tool.Pointer;
import troupe.geometry.Point;
import troupe.scene.Scene;

/** Changes a scene for as long as the button is down. Made by {@link SelectTool} when it goes down. */
public interface Gesture {

    /**
     * What comes of a gesture when the pointer is at a place.
     *
     * @param scene the changed scene
     * @param at where to show what it was snapped to
     * @param guide what it was snapped to
     * @param text how far it went, in the words of the person; may be empty
     * @param wrong what is wrong with the outcome, empty if nothing is
     */
    record Outcome(Scene scene, Point at, Optional<Guide> guide, String text, Optional<String> wrong) {}

    /** Returns what the gesture makes of the scene it began with. */
    Outcome at(Pointer pointer);

    /** Returns the name of the edit. */
    String name();

    /** Tells whether a press without a move is an edit, too. */
    default boolean needsNoMove() {
        return false;
    }
}
