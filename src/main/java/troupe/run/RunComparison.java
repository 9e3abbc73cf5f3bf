package troupe.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import troupe.run.frame.Channel;
import troupe.run.frame.Frames;

/** Compares two runs bit by bit and names the first difference. */
public final class RunComparison {
    private RunComparison() {}

    /**
     * Names the first difference between the frames: a channel, the first frame and value that differ, or
     * their number; nothing if every bit is equal. Cost O(values).
     */
    public static Optional<String> firstDifference(Frames expected, Frames actual) {
        int common = Math.min(expected.count(), actual.count());
        return firstDifference(expected, actual, common)
                .or(() -> expected.count() == actual.count()
                        ? Optional.empty()
                        : Optional.of("frames: expected " + expected.count() + ", found " + actual.count()));
    }

    /** Names the first difference within the first {@code count} frames, which both must have. */
    public static Optional<String> firstDifference(Frames expected, Frames actual, int count) {
        if (!expected.channels().equals(actual.channels())) {
            return Optional.of("channels: expected " + names(expected) + ", found " + names(actual));
        }
        if (expected.rate() != actual.rate()) {
            return Optional.of("rate: expected " + expected.rate() + " frames/s, found " + actual.rate());
        }
        for (int frame = 0; frame < count; frame++) {
            Optional<String> difference = inFrame(expected, actual, frame);
            if (difference.isPresent()) {
                return difference;
            }
        }
        return Optional.empty();
    }

    private static Optional<String> inFrame(Frames expected, Frames actual, int frame) {
        List<Channel> channels = expected.channels();
        for (int c = 0; c < channels.size(); c++) {
            Channel channel = channels.get(c);
            for (int k = 0; k < channel.width(); k++) {
                double a = expected.value(frame, c, k);
                double b = actual.value(frame, c, k);
                if (Double.doubleToLongBits(a) != Double.doubleToLongBits(b)) {
                    return Optional.of("frame " + frame + ", channel " + channel.owner() + "." + channel.name()
                            + (channel.width() > 1 ? "[" + k + "]" : "") + ": expected " + a + ", found " + b);
                }
            }
        }
        return Optional.empty();
    }

    private static String names(Frames frames) {
        return frames.channels().stream()
                .map(c -> c.owner() + "." + c.name() + " " + c.unit() + " " + c.type() + " x " + c.width())
                .toList()
                .toString();
    }

    /** Returns a line for every value that differs between two reports; names that end in {@code _ms} are left out. */
    public static List<String> differences(Report expected, Report actual) {
        List<String> lines = new ArrayList<>();
        compare("", expected, actual, lines);
        return lines;
    }

    private static void compare(String prefix, Report expected, Report actual, List<String> lines) {
        for (Map.Entry<String, Object> entry : expected.values().entrySet()) {
            String name = entry.getKey();
            Object a = entry.getValue();
            Object b = actual.values().get(name);
            if (name.endsWith("_ms")) {
                continue;
            }
            if (a instanceof Report x && b instanceof Report y) {
                compare(prefix + name + ".", x, y, lines);
            } else if (!Objects.equals(a, b)) {
                lines.add(prefix + name + ": was " + a + ", is " + (b == null ? "gone" : b));
            }
        }
        for (Map.Entry<String, Object> entry : actual.values().entrySet()) {
            if (!expected.values().containsKey(entry.getKey())
                    && !entry.getKey().endsWith("_ms")) {
                lines.add(prefix + entry.getKey() + ": is new, " + entry.getValue());
            }
        }
    }
}
