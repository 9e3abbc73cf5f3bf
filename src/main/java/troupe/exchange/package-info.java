/**
 * Names every format: what can be read from other programs and what can be written for them. One line here for
 * each; the formats themselves lie below.
 *
 * <p>May use what lies below it.
 */
package troupe.exchange;
