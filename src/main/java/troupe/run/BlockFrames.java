package troupe.run;

import java.util.List;

/** Holds frames in memory, in blocks of one second. Bytes of frames from {@code count} on are never looked at. */
final class BlockFrames implements Frames {
    private final double rate;
    private final FrameLayout layout;
    private final int count;
    private final int block;
    private final byte[][] blocks;

    BlockFrames(double rate, FrameLayout layout, int count, byte[][] blocks) {
        this.rate = rate;
        this.layout = layout;
        this.count = count;
        this.block = FrameRecorder.framesPerBlock(rate);
        this.blocks = blocks;
    }

    @Override
    public List<Channel> channels() {
        return layout.channels();
    }

    @Override
    public double rate() {
        return rate;
    }

    @Override
    public int count() {
        return count;
    }

    @Override
    public double value(int frame, int channel, int k) {
        if (frame < 0 || frame >= count) {
            throw new IndexOutOfBoundsException("frame " + frame + "; needs 0 to " + (count - 1));
        }
        return layout.get(blocks[frame / block], frame % block * layout.bytes(), channel, k);
    }
}
