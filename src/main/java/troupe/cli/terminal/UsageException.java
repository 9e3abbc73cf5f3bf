package troupe.cli.terminal;

/** Reports bad use of the command line; the message is one line that says what is wanted. */
public final class UsageException extends Exception {

    /** Says what was typed wrongly, and what is right. */
    public UsageException(String message) {
        super(message);
    }

    /** Says what was typed wrongly, what is right, and how that came to light. */
    public UsageException(String message, Throwable cause) {
        super(message, cause);
    }
}
