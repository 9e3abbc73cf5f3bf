/**
 * Holds the help in the window: the user guide, the list of shortcuts, and what the program is.
 *
 * <p>Guarantees: the shortcuts are those of the commands, and the guide is the text of {@code docs/}, each written once.
 * The guide is read off the event thread; everything else belongs to it. May use {@code app.command}, {@code app.look},
 * {@code paint} and {@code run}.
 */
package troupe.app.help;
