package troupe.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.run.frame.Channel;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;

class RunComparisonTest {
    private static final List<Channel> CHANNELS = List.of(
            new Channel("x", "m", Channel.Type.F64, "anna", 1), new Channel("y", "m", Channel.Type.F64, "all", 2));

    @Test
    void namesTheFirstValueThatDiffers() {
        assertEquals(Optional.empty(), compare(frames(1, 2, 3, 4, 5, 6), frames(1, 2, 3, 4, 5, 6)));
        assertEquals(
                Optional.of("frame 1, channel all.y[1]: expected 6.0, found 6.000000000000001"),
                compare(frames(1, 2, 3, 4, 5, 6), frames(1, 2, 3, 4, 5, Math.nextUp(6.0))));
        assertEquals(
                Optional.of("frame 0, channel anna.x: expected 0.0, found -0.0"),
                compare(frames(0.0, 2, 3), frames(-0.0, 2, 3)));
    }

    @Test
    void namesAnotherNumberOfFramesOnlyWhenTheCommonOnesAreEqual() {
        assertEquals(Optional.of("frames: expected 2, found 1"), compare(frames(1, 2, 3, 4, 5, 6), frames(1, 2, 3)));
        assertEquals(
                Optional.of("frame 0, channel anna.x: expected 1.0, found 7.0"),
                compare(frames(1, 2, 3, 4, 5, 6), frames(7, 2, 3)));
    }

    @Test
    void namesOtherChannelsAndRates() {
        FrameRecorder other = new FrameRecorder(4, CHANNELS.subList(0, 1));
        assertEquals(
                Optional.of("channels: expected [anna.x m F64 x 1, all.y m F64 x 2], found [anna.x m F64 x 1]"),
                compare(frames(), other.frames()));
        assertEquals(
                Optional.of("rate: expected 4.0 frames/s, found 5.0"),
                compare(frames(), new FrameRecorder(5, CHANNELS).frames()));
    }

    @Test
    void comparesReportsButNotTheirTimes() {
        Report old = Report.builder()
                .put("energy", 1.0)
                .put("gone", 1)
                .put("times_ms", Report.builder().put("search", 3.0).build())
                .put("by", Report.builder().put("walk", 1.0).build())
                .build();
        Report now = Report.builder()
                .put("energy", 2.0)
                .put("times_ms", Report.builder().put("search", 4.0).build())
                .put("by", Report.builder().put("walk", 1.5).build())
                .put("fresh", true)
                .build();
        assertEquals(
                List.of(
                        "energy: was 1.0, is 2.0",
                        "gone: was 1, is gone",
                        "by.walk: was 1.0, is 1.5",
                        "fresh: is new, true"),
                RunComparison.differences(old, now));
        assertEquals(List.of(), RunComparison.differences(old, old));
    }

    private static Optional<String> compare(Frames a, Frames b) {
        return RunComparison.firstDifference(a, b);
    }

    private static Frames frames(double... values) {
        FrameRecorder recorder = new FrameRecorder(4, CHANNELS);
        for (int i = 0; i < values.length; i += 3) {
            recorder.append(values[i], values[i + 1], values[i + 2]);
        }
        return recorder.frames();
    }
}
