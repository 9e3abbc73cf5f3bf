package troupe.paint.solid;

import java.util.function.BiConsumer;

/** Cuts a line into dashes; the pattern goes on round its corners. Serves one line. */
final class Dashes {
    private final double[] lengths;
    private int index;
    private double left;

    /** Makes a pattern of lengths in pixels, on and off in turn, {@code scale} samples each; none for no gaps. */
    Dashes(float[] pattern, double scale) {
        lengths = new double[pattern.length];
        for (int i = 0; i < pattern.length; i++) {
            lengths[i] = Math.max(0.1, pattern[i] * scale);
        }
        left = lengths.length == 0 ? Double.POSITIVE_INFINITY : lengths[0];
    }

    /** Hands over the dashes of the stretch from one sample to another. */
    void cut(Stage.Spot from, Stage.Spot to, BiConsumer<Stage.Spot, Stage.Spot> taker) {
        double length = Math.hypot(to.x() - from.x(), to.y() - from.y());
        if (lengths.length == 0 || length > 20_000) {
            taker.accept(from, to);
            return;
        }
        double done = 0;
        while (done < length) {
            double step = Math.min(left, length - done);
            if (index % 2 == 0) {
                taker.accept(from.towards(to, done / length), from.towards(to, (done + step) / length));
            }
            done += step;
            left -= step;
            if (left <= 1e-9) {
                index = (index + 1) % lengths.length;
                left = lengths[index];
            }
        }
    }
}
