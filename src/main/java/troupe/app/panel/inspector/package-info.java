/**
 * Holds the inspector: one section for each matter of what is selected and of its plan.
 *
 * <p>May use {@code app.panel} and what it uses. Belongs to the event thread.
 */
package troupe.app.panel.inspector;
