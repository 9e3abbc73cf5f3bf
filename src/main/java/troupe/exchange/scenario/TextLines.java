package troupe.exchange.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import troupe.exchange.format.ExchangeException;

/**
 * Reads a small text file line by line, with bounds on its size, and names the line in what it reports.
 * Lines end in LF or CR LF; bytes are taken as Latin-1, so that no byte is refused before its line is
 * looked at.
 */
final class TextLines {
    private final String name;
    private final String text;
    private int next;
    private int number;

    private TextLines(String name, String text) {
        this.name = name;
        this.text = text;
    }

    /** Reads at most {@code limit} bytes; a longer stream is refused. */
    static TextLines read(InputStream in, String name, int limit) throws IOException, ExchangeException {
        byte[] bytes = in.readNBytes(limit + 1);
        if (bytes.length > limit) {
            throw new ExchangeException(name, 0, 0, "more than " + limit + " bytes", "give a smaller file");
        }
        return new TextLines(name, new String(bytes, StandardCharsets.ISO_8859_1));
    }

    /** Returns the next line without its end, or null after the last. */
    String next() {
        if (next >= text.length()) {
            return null;
        }
        number++;
        int end = text.indexOf('\n', next);
        int stop = end < 0 ? text.length() : end;
        String line = text.substring(next, stop > next && text.charAt(stop - 1) == '\r' ? stop - 1 : stop);
        next = stop + 1;
        return line;
    }

    /** Returns the next line; its absence is reported as missing {@code what}. */
    String require(String what) throws ExchangeException {
        String line = next();
        if (line == null) {
            throw new ExchangeException(name, number, 0, "ends before " + what, "give the whole file");
        }
        return line;
    }

    /** Makes a report about the line read last. */
    ExchangeException wrong(int column, String wrong, String cure) {
        return new ExchangeException(name, number, column, wrong, cure);
    }

    /** Returns the whole number in {@code [least, most]} that {@code text} holds. */
    int whole(String text, String what, int least, int most) throws ExchangeException {
        if (text.matches("\\d{1,9}")) {
            int value = Integer.parseInt(text);
            if (value >= least && value <= most) {
                return value;
            }
        }
        throw wrong(
                0, what + " is " + ExchangeException.quoted(text), "give a whole number from " + least + " to " + most);
    }
}
