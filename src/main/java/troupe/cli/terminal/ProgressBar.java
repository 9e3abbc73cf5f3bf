package troupe.cli.terminal;

import java.io.PrintStream;
import java.util.Locale;
import java.util.function.LongSupplier;
import troupe.run.Engine;

/** Shows how far a task has come, on a terminal only: one line that is written over, gone at the end. */
public final class ProgressBar implements AutoCloseable {
    private static final int WIDTH = 24;
    private static final long INTERVAL = 100_000_000;

    private final PrintStream out;
    private final boolean shown;
    private final LongSupplier clock;
    private final long begin;
    private long next;
    private int length;

    /** Makes a bar; {@code clock} gives nanoseconds. */
    public ProgressBar(PrintStream out, boolean shown, LongSupplier clock) {
        this.out = out;
        this.shown = shown;
        this.clock = clock;
        this.begin = clock.getAsLong();
        this.next = begin + 2 * INTERVAL;
    }

    /** Shows the progress, unless it has been shown a moment ago. */
    public void show(Engine.Progress progress) {
        long now = clock.getAsLong();
        if (!shown || now - next < 0) {
            return;
        }
        next = now + INTERVAL;
        write(line(progress, (now - begin) * 1e-9));
    }

    /** Returns the line for a progress after some seconds. */
    public static String line(Engine.Progress progress, double seconds) {
        String work = String.format(Locale.ROOT, "%,d", progress.work());
        double share = progress.share();
        if (!(share > 0 && share <= 1)) {
            return String.format(Locale.ROOT, "%s steps, %.0f s", work, seconds);
        }
        int full = (int) (share * WIDTH);
        return String.format(
                Locale.ROOT,
                "[%s%s] %3.0f %%, %s steps, %.0f s left",
                "#".repeat(full),
                "-".repeat(WIDTH - full),
                100 * share,
                work,
                Math.ceil(seconds / share * (1 - share)));
    }

    private void write(String line) {
        out.print("\r" + line + " ".repeat(Math.max(0, length - line.length())));
        out.flush();
        length = line.length();
    }

    /** Takes the line away. */
    @Override
    public void close() {
        if (length > 0) {
            out.print("\r" + " ".repeat(length) + "\r");
            out.flush();
        }
    }
}
