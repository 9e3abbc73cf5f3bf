package troupe.app.play;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.Frames;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Encounter;
import troupe.scene.Task;

/**
 * Tells what happened in the run of a simulation, for the timeline: what was done when, and curves over time.
 * Immutable. Curves have at most {@value #SAMPLES} values, so that a run of any length can be drawn at once.
 *
 * @param seconds the time that it tells of; a run that still grows may be longer by now
 */
public record Chronicle(List<Mark> marks, List<Curve> curves, double seconds) {
    /** The most values of a curve. */
    public static final int SAMPLES = 400;

    /** Seconds over which the speed of a crowd is measured. */
    private static final double SPEED_SECONDS = 0.2;

    /** What was done from {@code begin} to {@code end}, in seconds; a word of the planner's. */
    public record Mark(String word, double begin, double end) {}

    /**
     * A quantity over time.
     *
     * @param key what it is: {@code risk}, {@code speed}, {@code step-time}
     * @param values its values, evenly from the beginning of the run to its end; NaN where there is none
     */
    public record Curve(String key, double[] values) {

        /** Returns the greatest value, 0 if there is none above. */
        public double most() {
            return Arrays.stream(values).filter(v -> !Double.isNaN(v)).max().orElse(0);
        }
    }

    /** Copies the lists. */
    public Chronicle {
        marks = List.copyOf(marks);
        curves = List.copyOf(curves);
    }

    /**
     * Makes the chronicle of a run; none of a run of another kind than encounters and crowds, or without frames.
     * Cost O(frames of an encounter, {@value #SAMPLES} times the people of a crowd).
     *
     * @param stepMillis how long the steps took, in milliseconds; may be empty
     */
    public static Optional<Chronicle> of(Run run, double[] stepMillis) {
        Frames frames = run.frames();
        if (frames.count() == 0) {
            return Optional.empty();
        }
        List<Curve> curves = new ArrayList<>();
        List<Mark> marks = new ArrayList<>();
        Task task = run.scene().task(run.task()).orElse(null);
        if (task instanceof Encounter encounter) {
            marks.addAll(marks(frames, frames.channel(encounter.actor(), "action")));
            curves.add(risk(frames, frames.channel(encounter.actor(), "risk")));
        } else if (task instanceof Crowd crowd) {
            curves.add(speed(frames, crowd));
        } else {
            return Optional.empty();
        }
        if (stepMillis.length > 0) {
            curves.add(stepTimes(stepMillis));
        }
        return Optional.of(new Chronicle(marks, curves, frames.duration()));
    }

    private static List<Mark> marks(Frames frames, int channel) {
        List<Mark> marks = new ArrayList<>();
        if (channel < 0) {
            return marks;
        }
        String[] words = frames.channels().get(channel).unit().split(",");
        int begin = 0;
        for (int frame = 1; frame <= frames.count(); frame++) {
            boolean last = frame == frames.count();
            if (last || frames.value(frame, channel, 0) != frames.value(begin, channel, 0)) {
                int code = (int) frames.value(begin, channel, 0);
                marks.add(new Mark(words[code], begin / frames.rate(), (last ? frame - 1 : frame) / frames.rate()));
                begin = frame;
            }
        }
        return marks;
    }

    /** Returns the frames at which a curve has its values. */
    private static int[] samples(int count) {
        int samples = Math.min(SAMPLES, count);
        int[] frames = new int[samples];
        for (int k = 0; k < samples; k++) {
            frames[k] = samples == 1 ? 0 : (int) ((long) k * (count - 1) / (samples - 1));
        }
        return frames;
    }

    private static Curve risk(Frames frames, int channel) {
        return new Curve(
                "risk",
                Arrays.stream(samples(frames.count()))
                        .mapToDouble(f -> channel < 0 ? Double.NaN : frames.value(f, channel, 0))
                        .toArray());
    }

    /** Returns the mean speed in m/s of everybody. */
    private static Curve speed(Frames frames, Crowd crowd) {
        List<int[]> places = crowd.allGroups()
                .map(CrowdGroup::id)
                .map(id -> new int[] {frames.channel(id, "x"), frames.channel(id, "y")})
                .filter(pair -> pair[0] >= 0 && pair[1] >= 0)
                .toList();
        int apart = (int) Math.max(1, Math.round(SPEED_SECONDS * frames.rate()));
        return new Curve(
                "speed",
                Arrays.stream(samples(frames.count()))
                        .mapToDouble(f -> speed(frames, places, Math.max(0, f - apart), f))
                        .toArray());
    }

    private static double speed(Frames frames, List<int[]> places, int from, int to) {
        double way = 0;
        int people = 0;
        for (int[] pair : places) {
            Channel channel = frames.channels().get(pair[0]);
            people += channel.width();
            for (int m = 0; m < channel.width(); m++) {
                way += Math.hypot(
                        frames.value(to, pair[0], m) - frames.value(from, pair[0], m),
                        frames.value(to, pair[1], m) - frames.value(from, pair[1], m));
            }
        }
        return to == from || people == 0 ? 0 : way / people * frames.rate() / (to - from);
    }

    /** Returns the longest step among those of each sample. */
    private static Curve stepTimes(double[] stepMillis) {
        int samples = Math.min(SAMPLES, stepMillis.length);
        double[] longest = new double[samples];
        for (int i = 0; i < stepMillis.length; i++) {
            int k = (int) ((long) i * samples / stepMillis.length);
            longest[k] = Math.max(longest[k], stepMillis[i]);
        }
        return new Curve("step-time", longest);
    }
}
