package troupe.exchange.track;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import troupe.exchange.format.Decimals;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.Places;
import troupe.exchange.format.StreamExporter;
import troupe.exchange.format.Words;
import troupe.paint.motion.Track;
import troupe.run.Run;
import troupe.run.frame.Frames;

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
        List<Words> words = tracks.stream().map(t -> new Words(frames, t)).toList();
        check(run, tracks, settings);
        out.write(HEADER.getBytes(StandardCharsets.UTF_8));
        for (int frame = 0; frame < frames.count(); frame++) {
            settings.proceed();
            StringBuilder rows = new StringBuilder();
            for (int k = 0; k < tracks.size(); k++) {
                Track track = tracks.get(k);
                if (!track.isThere(frame)) {
                    continue;
                }
                double degrees = Math.toDegrees(Math.IEEEremainder(track.headingRad(frame), 2 * Math.PI));
                Decimals.six(rows.append(frame).append(','), frame / frames.rate());
                rows.append(',').append(quoted(track.id()));
                Decimals.six(rows.append(','), track.x(frame));
                Decimals.six(rows.append(','), track.y(frame));
                Decimals.six(rows.append(','), track.z(frame));
                Decimals.six(rows.append(','), degrees);
                rows.append(',').append(quoted(words.get(k).at(frame))).append('\n');
            }
            out.write(rows.toString().getBytes(StandardCharsets.UTF_8));
        }
    }

    private static void check(Run run, List<Track> tracks, ExportSettings settings)
            throws IOException, ExchangeException {
        for (int frame = 0; frame < run.frames().count(); frame++) {
            settings.proceed();
            for (Track track : tracks) {
                if (track.isThere(frame)) {
                    Places.check(track, frame);
                }
            }
        }
    }

    private static String quoted(String text) {
        return text.matches("[^,\"\\r\\n]*") ? text : '"' + text.replace("\"", "\"\"") + '"';
    }
}
