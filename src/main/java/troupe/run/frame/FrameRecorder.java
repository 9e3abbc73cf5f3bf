package troupe.run.frame;

import java.util.ArrayList;
import java.util.List;

/**
 * Collects frames one after another. What {@link #frames} hands out is immutable and stays as it is while
 * the recorder goes on. Memory: the bytes of the channels, in blocks of one second. Used by one thread at
 * a time.
 */
public final class FrameRecorder {
    private static final int MAX_BLOCK_BYTES = 1 << 26;

    private final double rate;
    private final FrameLayout layout;
    private final int block;
    private final List<byte[]> blocks = new ArrayList<>();
    private int count;

    /**
     * Makes an empty recorder.
     *
     * @param rate frames per second, above 0, at most 1,000
     * @throws IllegalArgumentException if the rate is outside its range or a second of frames takes more than 64 MiB
     */
    public FrameRecorder(double rate, List<Channel> channels) {
        this.rate = rate;
        this.layout = new FrameLayout(channels);
        this.block = checkedBlock(rate, layout);
    }

    /** Returns the frames of a block, after checking that a block stays within 64 MiB. */
    public static int checkedBlock(double rate, FrameLayout layout) {
        int block = framesPerBlock(checkedRate(rate));
        if ((long) block * layout.bytes() > MAX_BLOCK_BYTES) {
            throw new IllegalArgumentException("a second of frames takes " + (long) block * layout.bytes()
                    + " bytes; needs at most " + MAX_BLOCK_BYTES);
        }
        return block;
    }

    private static double checkedRate(double rate) {
        if (!(rate > 0 && rate <= 1_000)) {
            throw new IllegalArgumentException("rate " + rate + " frames/s; needs a number above 0, at most 1000");
        }
        return rate;
    }

    /** Returns the frames of one block: those of a second, rounded up to a whole number. */
    public static int framesPerBlock(double rate) {
        return (int) Math.ceil(rate);
    }

    /** Returns the number of values that a frame takes: the widths of all channels together. */
    public int slots() {
        return layout.slots();
    }

    /** Returns the number of frames so far. */
    public int count() {
        return count;
    }

    /**
     * Adds a frame: the values of the first channel in order, then those of the second, and so on.
     *
     * @throws IllegalArgumentException if their number is not {@link #slots}, or a channel of whole numbers
     *     cannot hold its value exactly; the recorder is then unchanged
     */
    public void append(double... values) {
        if (values.length != layout.slots()) {
            throw new IllegalArgumentException("frame of " + values.length + " values; needs " + layout.slots());
        }
        int place = count % block;
        byte[] target = place == 0 && blocks.size() == count / block
                ? new byte[block * layout.bytes()]
                : blocks.get(count / block);
        int slot = 0;
        for (int c = 0; c < layout.channels().size(); c++) {
            int width = layout.channels().get(c).width();
            for (int k = 0; k < width; k++) {
                layout.put(target, place * layout.bytes(), c, k, values[slot++]);
            }
        }
        if (place == 0) {
            blocks.add(target);
        }
        count++;
    }

    /** Returns the frames so far. Cost O(seconds). */
    public Frames frames() {
        return new BlockFrames(rate, layout, count, blocks.toArray(new byte[0][]));
    }
}
