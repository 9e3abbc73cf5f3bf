package troupe.risk.forecast;

/**
 * Spreads samples evenly over the disc of {@link #K} standard deviations: rings of equal area, the same number on
 * each, every second ring turned by half a sector. They are the same always, so that an influence is no matter of
 * chance. Lengths are in standard deviations.
 */
final class Strata {
    /** The radius of the disc, in standard deviations. */
    static final double K = 2.5;

    private static final int RINGS = 6;
    private static final int SECTORS = 6;
    /** The number of samples. */
    static final int COUNT = RINGS * SECTORS;

    private final double[] x = new double[COUNT];
    private final double[] y = new double[COUNT];
    private final double[] bell = new double[COUNT];

    Strata() {
        for (int ring = 0; ring < RINGS; ring++) {
            double radius = K * Math.sqrt((ring + 0.5) / RINGS);
            for (int sector = 0; sector < SECTORS; sector++) {
                double angle = 2 * Math.PI * (sector + 0.5 * (ring % 2)) / SECTORS;
                int j = ring * SECTORS + sector;
                x[j] = radius * StrictMath.cos(angle);
                y[j] = radius * StrictMath.sin(angle);
                bell[j] = StrictMath.exp(-radius * radius / 2);
            }
        }
    }

    double x(int j) {
        return x[j];
    }

    double y(int j) {
        return y[j];
    }

    /** Returns {@code exp(-r^2 / 2)} of a sample. */
    double bell(int j) {
        return bell[j];
    }
}
