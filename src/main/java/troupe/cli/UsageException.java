package troupe.cli;

/** Reports bad use of the command line; the message is one line that says what is wanted. */
final class UsageException extends Exception {

    UsageException(String message) {
        super(message);
    }

    UsageException(String message, Throwable cause) {
        super(message, cause);
    }
}
