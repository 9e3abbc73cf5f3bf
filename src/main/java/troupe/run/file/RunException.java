package troupe.run.file;

/** Reports a run file that cannot be read; the message is one line that says what is wrong. */
public final class RunException extends Exception {

    /** Makes a report of the given line. */
    public RunException(String message) {
        super(message);
    }

    /** Makes a report of the given line, caused by another exception. */
    public RunException(String message, Throwable cause) {
        super(message, cause);
    }
}
