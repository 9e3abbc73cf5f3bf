package troupe.risk.forecast;

import java.util.List;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Quantity;

/**
 * Forecasts all uncertain avatars at once, in steps of {@link #STEP} seconds up to the horizon, and tells the risk
 * of a move of the actor among them: Avatars, equations 2 to 5. Lengths are in metres, speeds in m/s, times in
 * seconds from now. Used by one thread at a time; nothing is allocated after its making.
 *
 * <p>Deviations: the normaliser is the two-dimensional one; mass that walls keep an avatar from is clipped and the
 * rest scaled up, and if nothing is left the avatar is expected at the nearest place it can reach; the risk of
 * equation 5 has a constant term and is cut below zero; an influence is the expected risk, where the paper takes
 * the bare mean over the samples, which depends on how far out they lie. With {@link Encounter.Influence#PAPER} the
 * normaliser and the mean are those of the paper.
 */
public final class Forecast {
    /** Seconds between predictions, and between the positions that they are made from. */
    public static final double STEP = 0.1;

    private static final Strata STRATA = new Strata();
    private static final int SAMPLES = Strata.COUNT;

    private final Encounter encounter;
    private final List<Avatar> avatars;
    private final int steps;
    private final double w0;
    private final double w1;
    private final double w2;
    private final Blur[] blurs;
    private final Reach[] reaches;
    private final Expectation expectation;
    private final boolean[] seen;
    private final double[] x;
    private final double[] y;
    private final double[] vx;
    private final double[] vy;
    private final double[] spread;
    private final double[] sampleX;
    private final double[] sampleY;
    private final double[] weight;
    private final boolean[] held = new boolean[SAMPLES];

    /** Makes a forecast of nobody yet, for the avatars of an encounter over a ground. */
    public Forecast(Encounter encounter, Ways ways) {
        this.encounter = encounter;
        this.avatars = encounter.avatars();
        this.steps = stepsOf(encounter);
        this.w0 = encounter.number(Quantity.W0);
        this.w1 = encounter.number(Quantity.W1);
        this.w2 = encounter.number(Quantity.W2);
        int count = avatars.size();
        blurs = new Blur[count];
        reaches = new Reach[count];
        double sigma = encounter.number(Quantity.SIGMA);
        for (int a = 0; a < count; a++) {
            blurs[a] = new Blur(sigma, encounter.growth(), avatars.get(a).mobility());
            reaches[a] = new Reach(ways, avatars.get(a).speed(), Strata.K * sigma);
        }
        expectation = new Expectation((int) encounter.number(Quantity.HISTORY), STEP);
        seen = new boolean[count];
        x = new double[count];
        y = new double[count];
        vx = new double[count];
        vy = new double[count];
        spread = new double[count * (steps + 1)];
        sampleX = new double[count * (steps + 1) * SAMPLES];
        sampleY = new double[sampleX.length];
        weight = new double[sampleX.length];
    }

    /** Returns the number of steps that an encounter's horizon takes. */
    public static int stepsOf(Encounter encounter) {
        return (int) Math.ceil(encounter.number(Quantity.HORIZON) / STEP - 1e-9);
    }

    /** Returns the positions that a history must hold for the forecast, at the encounter's rate. */
    public static int capacity(Encounter encounter) {
        return (int) Math.ceil((encounter.number(Quantity.HISTORY) + 1) * STEP * encounter.number(Quantity.RATE) + 1e-9)
                + 2;
    }

    /** Forecasts every uncertain avatar from its past; one of which nothing has been seen is left out. */
    public void compute(List<History> pasts) {
        for (int a = 0; a < avatars.size(); a++) {
            Avatar avatar = avatars.get(a);
            seen[a] = avatar.kind() == Avatar.Kind.UNCERTAIN && expectation.of(pasts.get(a), avatar.speed());
            if (seen[a]) {
                x[a] = pasts.get(a).x();
                y[a] = pasts.get(a).y();
                vx[a] = expectation.vx();
                vy[a] = expectation.vy();
                spreadOut(a);
            }
        }
    }

    private void spreadOut(int a) {
        double last = steps * STEP;
        double speed = Math.sqrt(vx[a] * vx[a] + vy[a] * vy[a]);
        reaches[a].at(x[a], y[a], last, speed * last + Strata.K * blurs[a].after(last));
        for (int i = 0; i <= steps; i++) {
            double seconds = i * STEP;
            double sigma = blurs[a].after(seconds);
            double middleX = x[a] + vx[a] * seconds;
            double middleY = y[a] + vy[a] * seconds;
            int first = (a * (steps + 1) + i) * SAMPLES;
            double all = 0;
            double left = 0;
            for (int j = 0; j < SAMPLES; j++) {
                sampleX[first + j] = middleX + sigma * STRATA.x(j);
                sampleY[first + j] = middleY + sigma * STRATA.y(j);
                held[j] = reaches[a].reaches(sampleX[first + j], sampleY[first + j], seconds);
                all += STRATA.bell(j);
                left += held[j] ? STRATA.bell(j) : 0;
            }
            spread[a * (steps + 1) + i] = Strata.K * sigma;
            double total = total(sigma, all);
            for (int j = 0; j < SAMPLES; j++) {
                weight[first + j] = held[j] ? STRATA.bell(j) / left * total : 0;
            }
            if (left == 0) {
                gather(a, i, total);
            }
        }
    }

    /** Returns what the weights of all samples add up to: one, or the paper's bare mean of densities. */
    private double total(double sigma, double all) {
        return encounter.influence() == Encounter.Influence.PAPER
                ? all / SAMPLES / (sigma * Math.sqrt(2 * Math.PI))
                : 1;
    }

    /** Expects the avatar at the nearest place that it can reach. */
    private void gather(int a, int i, double total) {
        double seconds = i * STEP;
        double middleX = x[a] + vx[a] * seconds;
        double middleY = y[a] + vy[a] * seconds;
        int block = reaches[a].nearest(middleX, middleY, seconds);
        int first = (a * (steps + 1) + i) * SAMPLES;
        sampleX[first] = block < 0 ? x[a] : reaches[a].ways().standX(block);
        sampleY[first] = block < 0 ? y[a] : reaches[a].ways().standY(block);
        weight[first] = total;
        double dx = sampleX[first] - middleX;
        double dy = sampleY[first] - middleY;
        spread[a * (steps + 1) + i] = Math.sqrt(dx * dx + dy * dy);
    }

    /** Returns the number of steps to the horizon. */
    public int steps() {
        return steps;
    }

    /** Tells whether an avatar is forecast. */
    public boolean has(int avatar) {
        return seen[avatar];
    }

    /** Returns the expected x of an avatar after {@code seconds}. */
    public double expectedX(int avatar, double seconds) {
        return x[avatar] + vx[avatar] * seconds;
    }

    /** Returns the expected y of an avatar after {@code seconds}. */
    public double expectedY(int avatar, double seconds) {
        return y[avatar] + vy[avatar] * seconds;
    }

    /** Returns the standard deviation of an avatar's place in metres after {@code seconds}. */
    public double sigma(int avatar, double seconds) {
        return blurs[avatar].after(seconds);
    }

    Reach reach(int avatar) {
        return reaches[avatar];
    }

    /** Returns the step nearest to a time from now; beyond the horizon one more than {@link #steps}. */
    public int step(double seconds) {
        return (int) Math.min(steps + 1.0, Math.rint(Math.max(0, seconds) / STEP));
    }

    /**
     * Returns the risk of being at a place with a velocity at a step: the influences of all avatars together, at
     * least 0; 0 beyond the horizon. Cost O(samples) for each avatar that is near enough to matter.
     */
    public double risk(double atX, double atY, double withX, double withY, int step) {
        if (step > steps) {
            return 0;
        }
        double sum = 0;
        for (int a = 0; a < seen.length; a++) {
            if (seen[a]) {
                sum += influence(a, atX, atY, withX, withY, step);
            }
        }
        return sum;
    }

    /** Returns how likely an avatar is within {@code reach} metres of a place at a step, from 0 to 1. */
    public double contact(int a, double atX, double atY, double reach, int step) {
        double all = 0;
        double near = 0;
        int first = (a * (steps + 1) + step) * SAMPLES;
        for (int j = first; j < first + SAMPLES; j++) {
            double dx = atX - sampleX[j];
            double dy = atY - sampleY[j];
            all += weight[j];
            near += dx * dx + dy * dy < reach * reach ? weight[j] : 0;
        }
        return near / all;
    }

    /** Returns the influence of one avatar, at least 0: the weighted mean of equation 5 over its samples. */
    private double influence(int a, double atX, double atY, double withX, double withY, int step) {
        double fromX = atX - (x[a] + vx[a] * step * STEP);
        double fromY = atY - (y[a] + vy[a] * step * STEP);
        double away = Math.sqrt(fromX * fromX + fromY * fromY);
        double towardX = withX - vx[a];
        double towardY = withY - vy[a];
        double closing = Math.abs(w2) * Math.sqrt(towardX * towardX + towardY * towardY);
        double reach = spread[a * (steps + 1) + step];
        double nearest = w1 <= 0 ? Math.max(0, away - reach) : away + reach;
        if (w0 + w1 * nearest + closing <= 0) {
            return 0;
        }
        double sum = 0;
        int first = (a * (steps + 1) + step) * SAMPLES;
        for (int j = first; j < first + SAMPLES; j++) {
            double dx = atX - sampleX[j];
            double dy = atY - sampleY[j];
            double d = Math.sqrt(dx * dx + dy * dy);
            double rate = d > 1e-9 ? (towardX * dx + towardY * dy) / d : 0;
            sum += weight[j] * Math.max(0, w0 + w1 * d + w2 * rate);
        }
        return sum;
    }
}
