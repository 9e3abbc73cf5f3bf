package troupe.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import troupe.app.OnEventThread;

class PlaybackTest {

    private static Playback tenSeconds() {
        Playback playback = new Playback();
        playback.load(10, 25);
        return playback;
    }

    @Test
    void passesTimeAtItsSpeedAndStopsAtTheEnd() {
        OnEventThread.run(() -> {
            Playback playback = tenSeconds();
            playback.advance(1);
            assertEquals(0, playback.time());
            playback.play();
            playback.advance(1.5);
            assertEquals(1.5, playback.time());
            playback.setSpeed(4);
            playback.advance(2);
            assertEquals(9.5, playback.time());
            playback.advance(2);
            assertEquals(10, playback.time());
            assertFalse(playback.isPlaying());
            playback.play();
            assertEquals(0, playback.time());
        });
    }

    @Test
    void loopsByWhatIsLeftOver() {
        OnEventThread.run(() -> {
            Playback playback = tenSeconds();
            playback.setLooping(true);
            playback.seek(9);
            playback.play();
            playback.advance(3);
            assertEquals(2, playback.time(), 1e-12);
            assertTrue(playback.isPlaying());
        });
    }

    @Test
    void stepsOnFramesAndStops() {
        OnEventThread.run(() -> {
            Playback playback = tenSeconds();
            playback.play();
            playback.advance(0.05);
            playback.step(1);
            assertEquals(0.08, playback.time(), 1e-12);
            assertFalse(playback.isPlaying());
            playback.step(-5);
            assertEquals(0, playback.time());
        });
    }

    @Test
    void keepsTheMomentWhenARunIsReplaced() {
        OnEventThread.run(() -> {
            Playback playback = tenSeconds();
            playback.seek(8);
            playback.load(9, 25);
            assertEquals(8, playback.time());
            playback.load(3, 25);
            assertEquals(3, playback.time());
            playback.load(0, 25);
            playback.play();
            assertFalse(playback.isPlaying());
        });
    }

    @Test
    void refusesSpeedsItCannotPlay() {
        OnEventThread.run(() -> {
            assertThrows(IllegalArgumentException.class, () -> tenSeconds().setSpeed(0.05));
            assertThrows(IllegalArgumentException.class, () -> tenSeconds().setSpeed(Double.NaN));
            assertThrows(IllegalArgumentException.class, () -> tenSeconds().setSpeed(101));
        });
    }
}
