package troupe.crowd.flock;

/**
 * Holds what each agent proposes for a step, by its place in {@link Cells}: where to, in which direction, how fast,
 * and which others are so near that they might meet.
 */
final class Proposals {
    /** The most others that are kept for an agent; one with more stays where it is. */
    static final int CONTACTS = 32;

    final double[] x;
    final double[] y;
    final double[] z;
    final int[] span;
    final double[] headingX;
    final double[] headingY;
    final double[] speed;
    /** The steps for which the agent then still gives way. */
    final int[] yielding;

    final int[] contacts;
    /** The number of contacts; more than {@link #CONTACTS} if some are missing. */
    final int[] contactCount;

    Proposals(int count) {
        x = new double[count];
        y = new double[count];
        z = new double[count];
        span = new int[count];
        headingX = new double[count];
        headingY = new double[count];
        speed = new double[count];
        yielding = new int[count];
        contacts = new int[count * CONTACTS];
        contactCount = new int[count];
    }
}
