package troupe.exchange.format;

/**
 * Reports a file of another program that cannot be read, or a subject that a format cannot hold. The
 * message is one line: where, what was expected and found, and what to do.
 */
public final class ExchangeException extends Exception {
    private static final int LONGEST = 60;

    private final String file;
    private final int line;
    private final int column;

    /**
     * Makes the report of a mistake in a file.
     *
     * @param line 1 for the first line, 0 if the mistake belongs to no line
     * @param column 1 for the first column, 0 if it belongs to no column
     * @param wrong what was expected and what was found
     * @param cure what to do
     */
    public ExchangeException(String file, int line, int column, String wrong, String cure) {
        super(place(file, line, column) + wrong + "; " + cure);
        this.file = file;
        this.line = line;
        this.column = column;
    }

    private static String place(String file, int line, int column) {
        return file + (line > 0 ? ":" + line : "") + (line > 0 && column > 0 ? ":" + column : "") + ": ";
    }

    /** Returns the name of the file. */
    public String file() {
        return file;
    }

    /** Returns the line, from 1; 0 if there is none. */
    public int line() {
        return line;
    }

    /** Returns the column, from 1; 0 if there is none. */
    public int column() {
        return column;
    }

    /** Returns foreign text fit for a message: in quotes, printable, at most 60 characters. */
    public static String quoted(String text) {
        String cut = text.length() > LONGEST ? text.substring(0, LONGEST) + "…" : text;
        return "'" + cut.replaceAll("\\p{Cntrl}", "?") + "'";
    }
}
