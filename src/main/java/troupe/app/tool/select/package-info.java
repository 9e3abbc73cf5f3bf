/**
 * Holds the tool that selects, and the gestures by which it moves, bends, turns and scales what is selected.
 *
 * <p>May use {@code app.tool} and what it uses.
 */
package troupe.app.tool.select;
