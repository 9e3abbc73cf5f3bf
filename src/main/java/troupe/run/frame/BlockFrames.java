package troupe.run.frame;

/** Holds frames in memory, in blocks of one second. Bytes of frames from {@code count} on are never looked at. */
public final class BlockFrames extends PartedFrames {
    private final byte[][] blocks;

    /** Takes over blocks of whole frames, {@code count} in all, {@code rate} a second. */
    public BlockFrames(double rate, FrameLayout layout, int count, byte[][] blocks) {
        super(layout, rate, count);
        this.blocks = blocks;
    }

    @Override
    public byte[] part(int number) {
        return blocks[number];
    }
}
