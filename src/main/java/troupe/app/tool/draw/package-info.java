/**
 * Holds the tools that draw something new: polygons, boxes, journeys, avatars, groups.
 *
 * <p>May use {@code app.tool}, {@code app.tool.select} and what they use.
 */
package troupe.app.tool.draw;
