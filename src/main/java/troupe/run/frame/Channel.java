package troupe.run.frame;

/**
 * Declares one named stream of values that every frame of a run holds.
 *
 * @param name what it is, for example {@code x}, {@code heading}, {@code ability}
 * @param unit the unit, for example {@code m}, {@code rad}; for codes their words, comma-separated in order
 * @param type how a value is stored
 * @param owner the id of the element it belongs to
 * @param width values per frame, at least 1: one for an actor, one per member for a group
 */
public record Channel(String name, String unit, Type type, String owner, int width) {

    /** How a value is stored, little-endian. */
    public enum Type {
        F64(8),
        F32(4),
        I32(4),
        U8(1);

        private final int bytes;

        Type(int bytes) {
            this.bytes = bytes;
        }

        /** Returns the number of bytes of a value. */
        public int bytes() {
            return bytes;
        }
    }

    /** Checks the width. */
    public Channel {
        if (width < 1) {
            throw new IllegalArgumentException("channel " + name + " of width " + width + "; needs at least 1");
        }
    }

    /** Returns the number of bytes that this channel takes in a frame. */
    public int bytes() {
        return width * type.bytes();
    }
}
