package troupe.grid.region.ground;

/**
 * Names the classes of configurations as bytes, the kinds of configurations of a region. Source: Unified
 * section 7, which splits unstable places into border, gap and jumpable.
 */
public final class Kind {
    /** There is nothing to stand on, or no room above it. */
    public static final byte ABSENT = 0;

    /** The whole foot rests on one floor. */
    public static final byte STABLE = 1;

    /** The foot disc holds a step edge. */
    public static final byte BORDER = 2;

    /** A crossing over a drop that can be strode. */
    public static final byte GAP = 3;

    /** A crossing over an obstacle that can be vaulted. */
    public static final byte JUMPABLE = 4;

    /** There is a floor, but no ability has room or support there. */
    public static final byte FORBIDDEN = 5;

    private static final String[] WORDS = {"absent", "stable", "border", "gap", "jumpable", "forbidden"};

    private Kind() {}

    /**
     * Returns the word for a kind in legends and reports.
     *
     * @throws IllegalArgumentException if it is none of the constants
     */
    public static String word(byte kind) {
        if (kind < 0 || kind >= WORDS.length) {
            throw new IllegalArgumentException("kind " + kind + "; needs one of 0 to " + (WORDS.length - 1));
        }
        return WORDS[kind];
    }
}
