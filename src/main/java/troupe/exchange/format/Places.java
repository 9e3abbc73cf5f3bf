package troupe.exchange.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.paint.motion.Track;
import troupe.run.Run;
import troupe.run.frame.Frames;

/**
 * Holds where one moving thing is in every frame. A run that stays in its file is costly to read thing by thing, so
 * things are taken many at a time: as many as fit in 64 MiB.
 *
 * @param track the thing
 * @param x metres by frame, NaN where it is not there
 * @param headingRad radians, counter-clockwise from +x
 * @param words the ability or action by frame, empty if the run does not tell
 */
public record Places(Track track, double[] x, double[] y, double[] z, double[] headingRad, String[] words) {
    private static final int MOST_VALUES = 1 << 23;

    /** Takes one thing after another, in order. */
    @FunctionalInterface
    public interface Visitor {
        void visit(Places places) throws IOException, ExchangeException;
    }

    /** Tells whether it is there in a frame. */
    public boolean isThere(int frame) {
        return !Double.isNaN(x[frame]);
    }

    /**
     * Shows all given things to a visitor.
     *
     * @throws ExchangeException at a place that is not finite, unless the thing is not there at all
     */
    public static void each(Run run, List<Track> tracks, ExportSettings settings, Visitor visitor)
            throws IOException, ExchangeException {
        int count = run.frames().count();
        int most = Math.max(1, MOST_VALUES / 5 / Math.max(1, count));
        for (int first = 0; first < tracks.size(); first += most) {
            List<Track> some = tracks.subList(first, Math.min(tracks.size(), first + most));
            for (Places places : read(run.frames(), some, settings)) {
                settings.proceed();
                visitor.visit(places);
            }
        }
    }

    private static List<Places> read(Frames frames, List<Track> tracks, ExportSettings settings)
            throws IOException, ExchangeException {
        int count = frames.count();
        List<Places> all = new ArrayList<>();
        List<Words> words = new ArrayList<>();
        for (Track track : tracks) {
            words.add(new Words(frames, track));
            all.add(new Places(
                    track,
                    new double[count],
                    new double[count],
                    new double[count],
                    new double[count],
                    new String[count]));
        }
        for (int frame = 0; frame < count; frame++) {
            settings.proceed();
            for (int k = 0; k < all.size(); k++) {
                all.get(k).take(frame);
                all.get(k).words[frame] = words.get(k).at(frame);
            }
        }
        return all;
    }

    private void take(int frame) throws ExchangeException {
        boolean there = track.isThere(frame);
        x[frame] = there ? track.x(frame) : Double.NaN;
        y[frame] = there ? track.y(frame) : Double.NaN;
        z[frame] = track.z(frame);
        headingRad[frame] = there ? track.headingRad(frame) : frame > 0 ? headingRad[frame - 1] : 0;
        if (there) {
            check(track, frame);
        }
    }

    /**
     * Checks that a thing which is there has a place.
     *
     * @throws ExchangeException at what is not finite
     */
    public static void check(Track track, int frame) throws ExchangeException {
        if (!Double.isFinite(track.x(frame) + track.y(frame) + track.z(frame) + track.headingRad(frame))) {
            throw new ExchangeException(
                    "frame " + frame,
                    0,
                    0,
                    "'" + track.id() + "' has a place that is not a number",
                    "plan the task again; a run like this cannot be exported");
        }
    }

    /** Returns the tracks of what acts: all but moved obstacles. */
    public static List<Track> acting(Run run) {
        return Track.of(run).stream()
                .filter(t -> run.scene().obstacle(t.owner()).isEmpty())
                .toList();
    }

    /** Returns the headings in degrees, turning on without a jump of more than half a turn. */
    public double[] steadyDegrees() {
        double[] degrees = Arrays.stream(headingRad).map(Math::toDegrees).toArray();
        for (int k = 1; k < degrees.length; k++) {
            degrees[k] = degrees[k - 1] + Math.IEEEremainder(degrees[k] - degrees[k - 1], 360);
        }
        return degrees;
    }
}
