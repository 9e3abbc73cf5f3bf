package troupe.cli.terminal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import troupe.run.Engine.Progress;

class ProgressBarTest {
    private long now;

    @Test
    void tellsShareAndTimeLeft() {
        assertEquals(
                "[######------------------]  25 %, 1,000 steps, 6 s left",
                ProgressBar.line(new Progress(1_000, 0.25), 2));
        assertEquals("1,000 steps, 2 s", ProgressBar.line(new Progress(1_000, Double.NaN), 2));
        assertEquals("0 steps, 0 s", ProgressBar.line(new Progress(0, 0), 0));
    }

    @Test
    void writesOverItselfAndIsGoneAtTheEnd() {
        String text = shown(true);
        assertTrue(text.startsWith("\r1 steps, 1 s"), text);
        assertTrue(text.endsWith("\r"), text);
    }

    @Test
    void writesNothingWhereNobodyWatches() {
        assertEquals("", shown(false));
    }

    private String shown(boolean watched) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        now = 0;
        try (ProgressBar bar =
                new ProgressBar(new PrintStream(bytes, true, StandardCharsets.UTF_8), watched, () -> now)) {
            bar.show(new Progress(0, Double.NaN));
            now = 1_000_000_000;
            bar.show(new Progress(1, Double.NaN));
            bar.show(new Progress(2, Double.NaN));
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }
}
