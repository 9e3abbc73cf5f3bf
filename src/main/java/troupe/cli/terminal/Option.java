package troupe.cli.terminal;

/**
 * Declares an option of a command.
 *
 * @param name as typed: {@code --task}, {@code -o}
 * @param value what its value is called in the help, empty for a switch
 * @param repeated whether it may be given more than once
 * @param text what it does, one line
 */
public record Option(String name, String value, boolean repeated, String text) {

    /** Declares a switch. */
    public static Option flag(String name, String text) {
        return new Option(name, "", false, text);
    }

    /** Declares an option with a value. */
    public static Option of(String name, String value, String text) {
        return new Option(name, value, false, text);
    }

    /** Declares an option with a value that may be given more than once. */
    public static Option many(String name, String value, String text) {
        return new Option(name, value, true, text);
    }

    /** Tells whether a value follows it. */
    public boolean takesValue() {
        return !value.isEmpty();
    }
}
