/**
 * Holds the commands: one action each, from one list, out of which menus, buttons, shortcuts and the
 * search are built.
 *
 * <p>Guarantees: text, shortcut and icon come from the texts. Belongs to the event thread.
 */
package troupe.app.command;
