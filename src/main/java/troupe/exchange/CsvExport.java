package troupe.exchange;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import troupe.paint.Track;
import troupe.run.Frames;
import troupe.run.Run;

/**
 * Writes the frames as text, {@code frame,time,id,x,y,z,heading,ability}: a row for each moving thing in
 * each frame; seconds, metres, degrees counter-clockwise from +x in (-180, 180]; six decimals, a point in
 * any locale, lines end in LF. An id or word that holds a comma, a quote or a line end is quoted.
 */
public final class CsvExport implements StreamExporter {
    private static final String HEADER = "frame,time,id,x,y,z,heading,ability\n";

    /** Makes the exporter. */
    public CsvExport() {}

    @Override
    public String name() {
        return "csv";
    }

    @Override
    public String extension() {
        return "csv";
    }

    @Override
    public String about() {
        return "positions, headings and abilities of all frames, for anything";
    }

    @Override
    public void write(Run run, ExportSettings settings, OutputStream out) throws IOException, ExchangeException {
        Frames frames = run.frames();
        List<Track> tracks = Track.of(run);
        check(run, tracks);
        out.write(HEADER.getBytes(StandardCharsets.UTF_8));
        for (int frame = 0; frame < frames.count(); frame++) {
            settings.proceed();
            StringBuilder rows = new StringBuilder();
            for (Track track : tracks) {
                if (!track.isThere(frame)) {
                    continue;
                }
                double degrees = Math.toDegrees(Math.IEEEremainder(track.headingRad(frame), 2 * Math.PI));
                rows.append(frame).append(',').append(number(frame / frames.rate()));
                rows.append(',').append(quoted(track.id()));
                rows.append(',').append(number(track.x(frame)));
                rows.append(',').append(number(track.y(frame)));
                rows.append(',').append(number(track.z(frame)));
                rows.append(',').append(number(degrees));
                rows.append(',').append(quoted(track.ability(frame))).append('\n');
            }
            out.write(rows.toString().getBytes(StandardCharsets.UTF_8));
        }
    }

    private static void check(Run run, List<Track> tracks) throws ExchangeException {
        for (Track track : tracks) {
            for (int frame = 0; frame < run.frames().count(); frame++) {
                double sum = track.x(frame) + track.y(frame) + track.z(frame) + track.headingRad(frame);
                if (track.isThere(frame) && !Double.isFinite(sum)) {
                    throw new ExchangeException(
                            "frame " + frame,
                            0,
                            0,
                            "'" + track.id() + "' has a place that is not a number",
                            "plan the task again; a run like this cannot be exported");
                }
            }
        }
    }

    private static String number(double value) {
        String text = String.format(Locale.ROOT, "%.6f", value);
        return text.equals("-0.000000") ? "0.000000" : text;
    }

    private static String quoted(String text) {
        return text.matches("[^,\"\\r\\n]*") ? text : '"' + text.replace("\"", "\"\"") + '"';
    }
}
