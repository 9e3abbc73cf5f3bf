package troupe.cli.terminal;

/** Names the exit codes of the program. */
public final class ExitCode {
    /** All went well. */
    public static final int OK = 0;

    /** A planner found nothing, or what was compared differs. */
    public static final int FAILED = 1;

    /** The command line was not understood. */
    public static final int BAD_USE = 2;

    /** A file, or what it holds, is wrong. */
    public static final int BAD_INPUT = 3;

    /** The program itself failed. */
    public static final int FAULT = 4;

    /** What a shell gives a process that Ctrl-C ended. */
    public static final int INTERRUPTED = 130;

    private ExitCode() {}
}
