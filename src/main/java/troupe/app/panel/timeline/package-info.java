/**
 * Holds the timeline: when which ability is used, plots over time, and the moment that is shown.
 *
 * <p>May use {@code app.panel} and what it uses. Belongs to the event thread.
 */
package troupe.app.panel.timeline;
