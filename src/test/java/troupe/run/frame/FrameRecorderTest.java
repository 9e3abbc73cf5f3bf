package troupe.run.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import troupe.run.Digest;

class FrameRecorderTest {
    private static final List<Channel> CHANNELS = List.of(
            new Channel("x", "m", Channel.Type.F64, "anna", 1),
            new Channel("ability", "walk,vault", Channel.Type.U8, "anna", 1),
            new Channel("phase", "", Channel.Type.F32, "anna", 2),
            new Channel("member", "", Channel.Type.I32, "group", 3));

    @Test
    void givesBackWhatWasAppended() {
        FrameRecorder recorder = new FrameRecorder(25, CHANNELS);
        SplittableRandom random = new SplittableRandom(1);
        double[][] expected = new double[60][];
        for (int f = 0; f < expected.length; f++) {
            expected[f] = new double[] {
                random.nextDouble(), random.nextInt(256), 0.25f, (float) random.nextDouble(), -1, random.nextInt(), 7
            };
            recorder.append(expected[f]);
        }
        Frames frames = recorder.frames();
        assertEquals(60, frames.count());
        assertEquals(59 / 25.0, frames.duration());
        for (int f = 0; f < expected.length; f++) {
            int slot = 0;
            for (int c = 0; c < CHANNELS.size(); c++) {
                for (int k = 0; k < CHANNELS.get(c).width(); k++) {
                    assertEquals(expected[f][slot++], frames.value(f, c, k));
                }
            }
        }
        assertEquals(2, frames.channel("anna", "phase"));
        assertEquals(-1, frames.channel("group", "phase"));
    }

    @Test
    void framesHandedOutStayAsTheyAre() {
        FrameRecorder recorder = new FrameRecorder(2, CHANNELS.subList(0, 1));
        recorder.append(1);
        Frames first = recorder.frames();
        recorder.append(2);
        recorder.append(3);
        assertEquals(1, first.count());
        assertEquals(1, first.value(0, 0, 0));
        assertThrows(IndexOutOfBoundsException.class, () -> first.value(1, 0, 0));
        assertThrows(IndexOutOfBoundsException.class, () -> first.value(0, 0, 1));
        assertEquals(3, recorder.frames().value(2, 0, 0));
    }

    @Test
    void refusesWhatAChannelCannotHoldAndStaysUnchanged() {
        FrameRecorder recorder = new FrameRecorder(1, CHANNELS.subList(1, 2));
        assertThrows(IllegalArgumentException.class, () -> recorder.append(256));
        assertThrows(IllegalArgumentException.class, () -> recorder.append(0.5));
        assertThrows(IllegalArgumentException.class, () -> recorder.append(Double.NaN));
        assertThrows(IllegalArgumentException.class, () -> recorder.append(1, 2));
        assertEquals(0, recorder.count());
        recorder.append(255);
        assertThrows(IllegalArgumentException.class, () -> recorder.append(-1));
        recorder.append(3);
        assertEquals(255, recorder.frames().value(0, 0, 0));
        assertEquals(3, recorder.frames().value(1, 0, 0));
    }

    @Test
    void refusesRatesOutsideTheirRange() {
        for (double rate : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY, 1_001}) {
            assertThrows(IllegalArgumentException.class, () -> new FrameRecorder(rate, CHANNELS));
        }
    }

    @Test
    void digestSeesEveryValueAndEveryNameOfAChannel() {
        Channel channel = new Channel("x", "m", Channel.Type.F64, "a", 1);
        String digest = Digest.of(recorded(25, channel, 1, 2));
        assertEquals(digest, Digest.of(recorded(25, channel, 1, 2)));
        assertEquals(64, digest.length());
        assertNotEquals(digest, Digest.of(recorded(25, channel, 1, Math.nextUp(2.0))));
        assertNotEquals(digest, Digest.of(recorded(25, channel, 1)));
        assertNotEquals(digest, Digest.of(recorded(50, channel, 1, 2)));
        assertNotEquals(digest, Digest.of(recorded(25, new Channel("y", "m", Channel.Type.F64, "a", 1), 1, 2)));
        assertNotEquals(digest, Digest.of(recorded(25, new Channel("x", "m", Channel.Type.F64, "b", 1), 1, 2)));
    }

    private static Frames recorded(double rate, Channel channel, double... values) {
        FrameRecorder recorder = new FrameRecorder(rate, List.of(channel));
        for (double value : values) {
            recorder.append(value);
        }
        return recorder.frames();
    }
}
