/**
 * Holds the tour: a quiet card over the plan that names one thing at a time, marks where it is, and waits until the
 * person has really done it.
 *
 * <p>Guarantees: the tour changes nothing of the scene by itself, and takes no mouse event from what it marks. Belongs
 * to the event thread. May use the other parts of {@code app}, {@code paint} and {@code scene}.
 */
package troupe.app.tour;
