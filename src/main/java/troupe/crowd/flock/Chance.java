package troupe.crowd.flock;

/**
 * Draws random numbers without state: the same seed, role, agent and step always give the same bits, on any thread
 * and in any order. Source of the mixing: Steele, Lea and Flood 2014 (SplitMix64).
 */
public final class Chance {
    private Chance() {}

    /** Returns 64 bits for a role, an agent and a step. */
    public static long bits(long seed, int role, long agent, long step) {
        long z = mixed(seed + 0x9E3779B97F4A7C15L * (role + 1));
        z = mixed(z + 0x9E3779B97F4A7C15L * (agent + 1));
        return mixed(z + 0x9E3779B97F4A7C15L * (step + 1));
    }

    /** Returns a number in [0, 1) of 53 bits. */
    public static double unit(long bits) {
        return (bits >>> 11) * 0x1.0p-53;
    }

    /** Returns other bits that depend on the given ones only. */
    public static long mixed(long bits) {
        long z = (bits ^ bits >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }
}
