/**
 * Holds the views of a run: overlays with unit and legend, their kinds, and those that every grid offers.
 *
 * <p>May use {@code grid}, {@code scene} and {@code geometry}.
 */
package troupe.run.view;
