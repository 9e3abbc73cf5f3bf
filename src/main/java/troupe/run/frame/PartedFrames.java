package troupe.run.frame;

import java.util.List;

/** Gives frames whose bytes lie in parts of one second each; where a part comes from is left to the subclass. */
public abstract class PartedFrames implements Frames {
    private final FrameLayout layout;
    private final double rate;
    private final int count;
    private final int block;

    /** Prepares frames that lie in parts; the frames are {@code rate} a second. */
    public PartedFrames(FrameLayout layout, double rate, int count) {
        this.layout = layout;
        this.rate = rate;
        this.count = count;
        this.block = FrameRecorder.framesPerBlock(rate);
    }

    @Override
    public final List<Channel> channels() {
        return layout.channels();
    }

    @Override
    public final double rate() {
        return rate;
    }

    @Override
    public final int count() {
        return count;
    }

    @Override
    public final double value(int frame, int channel, int k) {
        if (frame < 0 || frame >= count) {
            throw new IndexOutOfBoundsException("frame " + frame + "; needs 0 to " + (count - 1));
        }
        return layout.get(part(frame / block), frame % block * layout.bytes(), channel, k);
    }

    /** Returns the bytes of a part, from 0; at least those of its frames before {@code count}. */
    public abstract byte[] part(int number);

    /** Returns the number of bytes that the frames of a part take. */
    public final int partBytes(int number) {
        return Math.min(block, count - number * block) * layout.bytes();
    }
}
