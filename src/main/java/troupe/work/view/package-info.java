/**
 * Makes the views of a scene and of a moment of its run: the fields that planners work on, density, risk.
 *
 * <p>May use {@code work} and everything below it.
 */
package troupe.work.view;
