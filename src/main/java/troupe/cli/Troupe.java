package troupe.cli;

/** Starts the program. */
public final class Troupe {
    private Troupe() {}

    /** Runs a command; see {@code --help}. */
    public static void main(String[] arguments) {
        System.out.println("Troupe");
    }
}
