package troupe.run;

/** Holds frames in memory, in blocks of one second. Bytes of frames from {@code count} on are never looked at. */
final class BlockFrames extends PartedFrames {
    private final byte[][] blocks;

    BlockFrames(double rate, FrameLayout layout, int count, byte[][] blocks) {
        super(layout, rate, count);
        this.blocks = blocks;
    }

    @Override
    byte[] part(int number) {
        return blocks[number];
    }
}
