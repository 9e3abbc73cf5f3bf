package troupe.exchange.script;

import java.awt.Color;
import troupe.geometry.Polygon;

/**
 * Writes the commands of one language that build a scene of solids and move them. Metres, seconds, degrees
 * counter-clockwise, z up. Call {@link #begin}, solids, keys solid by solid in the order of time, {@link #end}. Used
 * once.
 */
public interface SceneScript {

    /**
     * Begins.
     *
     * @param title what the script rebuilds; may hold any text
     * @param rate samples a second
     * @param frames their number
     */
    void begin(String title, double rate, int frames);

    /**
     * Adds a solid that can be moved by keys: an outline raised from its bottom.
     *
     * @param id its name, which the script may have to change to make it a name of its language
     * @param outline counter-clockwise, about the origin if the solid is to be moved
     * @param bottom elevation in metres of the lower face
     */
    void solid(String id, Polygon outline, double bottom, double height, Color colour);

    /** Begins the keys of a solid. */
    void beginKeys(String id);

    /** Places the solid at a sample. */
    void key(int frame, double x, double y, double z, double degrees);

    /** Shows or hides the solid from a sample on. */
    void shown(int frame, boolean shown);

    /** Ends the keys of a solid. */
    void endKeys();

    /** Ends the script. */
    void end();

    /** Takes what has been written since the last call. */
    String take();

    /** Returns text fit for a comment: one line of printable ASCII without marks that end comments or texts. */
    static String plain(String text) {
        return text.replaceAll("[^ -~]+", "?").replaceAll("[\"\\\\*]", "'");
    }
}
