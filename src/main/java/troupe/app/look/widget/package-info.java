/**
 * Holds the few components that Swing has not, or not as the studio shows them: buttons, switches, fields, thin bars
 * and dividers, questions.
 *
 * <p>Guarantees: each is reached by keyboard and screen reader. May use {@code app.look}.
 */
package troupe.app.look.widget;
