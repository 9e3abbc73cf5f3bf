package troupe.risk.study;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.risk.forecast.Blur;
import troupe.risk.forecast.Expectation;
import troupe.risk.forecast.Forecast;
import troupe.risk.forecast.History;
import troupe.scene.Avatar;
import troupe.scene.Encounter.Growth;
import troupe.scene.xml.TrackTable;

/**
 * Compares what is predicted of recorded people with what they did: how far off the predictions were, how often a
 * true position lay inside the predicted discs of 50 and 90 percent, and which blur fits best. Immutable.
 *
 * <p>A prediction is made at every recorded instant from the second of a person on, from what was recorded until
 * then; it is judged where the person was still recorded the given time later.
 */
public final class Calibration {
    /** The seconds ahead that the table tells. */
    public static final List<Double> AHEAD = List.of(0.4, 0.8, 1.6, 3.2);

    /** The seconds ahead that a fit looks at: every 0.4 s up to 3.2 s. */
    private static final int TIMES = 8;

    private static final double EACH = 0.4;
    /** Radii of the discs of half and nine tenths of a Gaussian's mass, in standard deviations. */
    private static final double HALF = Math.sqrt(2 * StrictMath.log(2));

    private static final double MOST = Math.sqrt(2 * StrictMath.log(10));
    /**
     * The logarithms of the least and greatest standard deviation in metres, and mobility, that a fit looks at.
     * Recorded places are not known better than by some centimetres, even where they were smoothed since.
     */
    private static final double[] LEAST = {StrictMath.log(0.03), StrictMath.log(0.05)};

    private static final double[] LIMIT = {StrictMath.log(2), StrictMath.log(100)};
    private static final int FIT_GRID = 40;
    private static final int FIT_ROUNDS = 12;

    private final List<double[]> errors;

    /** Judges errors in metres that are known already, those of each 0.4 s ahead up to 3.2 s. */
    Calibration(List<double[]> errors) {
        this.errors = List.copyOf(errors);
    }

    /**
     * Predicts the people of a table of tracks at every instant. Cost O(positions times history).
     *
     * @param history earlier positions that a prediction looks at
     * @param speed the highest speed expected, in m/s
     */
    public static Calibration of(TrackTable tracks, int history, double speed) {
        List<List<Double>> found = new ArrayList<>();
        for (int k = 0; k < TIMES; k++) {
            found.add(new ArrayList<>());
        }
        Expectation expectation = new Expectation(history, Forecast.STEP);
        for (TrackTable.Person person : tracks.people()) {
            List<Avatar.Fix> fixes = person.fixes();
            History past = new History(Math.max(2, fixes.size()));
            for (int i = 0; i < fixes.size(); i++) {
                Avatar.Fix now = fixes.get(i);
                past.see(now.time(), now.x(), now.y());
                if (i > 0) {
                    expectation.of(past, speed);
                    judge(fixes, i, expectation, found);
                }
            }
        }
        return new Calibration(found.stream()
                .map(list -> list.stream().mapToDouble(Double::doubleValue).toArray())
                .toList());
    }

    private static void judge(List<Avatar.Fix> fixes, int i, Expectation expectation, List<List<Double>> found) {
        Avatar.Fix now = fixes.get(i);
        int next = i;
        for (int k = 0; k < TIMES; k++) {
            double ahead = EACH * (k + 1);
            double time = now.time() + ahead;
            while (next < fixes.size() && fixes.get(next).time() < time - 1e-6) {
                next++;
            }
            if (next == fixes.size()) {
                return;
            }
            Avatar.Fix after = fixes.get(next);
            Avatar.Fix before = fixes.get(next - 1);
            double share = Math.min(1, (time - before.time()) / (after.time() - before.time()));
            double dx = before.x() + share * (after.x() - before.x()) - now.x() - expectation.vx() * ahead;
            double dy = before.y() + share * (after.y() - before.y()) - now.y() - expectation.vy() * ahead;
            found.get(k).add(Math.sqrt(dx * dx + dy * dy));
        }
    }

    private static int index(double ahead) {
        int k = (int) Math.rint(ahead / EACH) - 1;
        if (k < 0 || k >= TIMES || Math.abs(EACH * (k + 1) - ahead) > 1e-9) {
            throw new IllegalArgumentException("ahead=" + ahead + " s; needs a multiple of 0.4 from 0.4 to 3.2");
        }
        return k;
    }

    /** Returns the number of predictions judged {@code ahead} seconds later, one of {@link #AHEAD}. */
    public int count(double ahead) {
        return errors.get(index(ahead)).length;
    }

    /** Returns how far off the middle one of the predictions was, in metres; NaN if there are none. */
    public double median(double ahead) {
        double[] sorted = errors.get(index(ahead)).clone();
        Arrays.sort(sorted);
        return sorted.length == 0 ? Double.NaN : sorted[sorted.length / 2];
    }

    /** Returns the share of true positions inside the predicted disc of half the mass. */
    public double insideHalf(Blur blur, double ahead) {
        return inside(blur, ahead, HALF);
    }

    /** Returns the share of true positions inside the predicted disc of nine tenths of the mass. */
    public double insideNineTenths(Blur blur, double ahead) {
        return inside(blur, ahead, MOST);
    }

    private double inside(Blur blur, double ahead, double radius) {
        double[] all = errors.get(index(ahead));
        double most = radius * blur.after(ahead);
        return (double) Arrays.stream(all).filter(e -> e <= most).count() / all.length;
    }

    /**
     * Finds the blur of a growth under which what people did was likeliest: the greatest likelihood of the errors
     * as draws from two-dimensional Gaussians, over all times up to 3.2 s, each counting the same. Far misses weigh
     * in it as they do in a risk; a fit of the shares inside the discs passes over them.
     *
     * @throws IllegalArgumentException if there is no prediction to judge
     */
    public Blur fit(Growth growth) {
        double[] spread = errors.stream()
                .mapToDouble(all -> Arrays.stream(all).map(e -> e * e).sum() / (2 * all.length))
                .toArray();
        if (Double.isNaN(spread[0])) {
            throw new IllegalArgumentException("no person is recorded for long enough to judge a prediction");
        }
        double[] low = LEAST.clone();
        double[] high = LIMIT.clone();
        Blur best = new Blur(0.1, growth, 1);
        for (int round = 0; round < FIT_ROUNDS; round++) {
            double least = Double.POSITIVE_INFINITY;
            for (int i = 0; i <= FIT_GRID; i++) {
                for (int j = 0; j <= FIT_GRID; j++) {
                    Blur blur = new Blur(
                            StrictMath.exp(low[0] + (high[0] - low[0]) * i / FIT_GRID),
                            growth,
                            StrictMath.exp(low[1] + (high[1] - low[1]) * j / FIT_GRID));
                    double unlikely = unlikely(spread, blur);
                    if (unlikely < least) {
                        least = unlikely;
                        best = blur;
                    }
                }
            }
            narrow(low, high, 0, StrictMath.log(best.sigma()));
            narrow(low, high, 1, StrictMath.log(best.mobility()));
        }
        return best;
    }

    private static void narrow(double[] low, double[] high, int axis, double middle) {
        double half = (high[axis] - low[axis]) / 4;
        low[axis] = Math.max(LEAST[axis], middle - half);
        high[axis] = Math.min(LIMIT[axis], middle + half);
    }

    /** Returns the mean negative log likelihood, but for a constant; times without a prediction count nothing. */
    private static double unlikely(double[] spread, Blur blur) {
        double sum = 0;
        for (int k = 0; k < TIMES; k++) {
            double sigma = blur.after(EACH * (k + 1));
            sum += Double.isNaN(spread[k]) ? 0 : 2 * StrictMath.log(sigma) + spread[k] / (sigma * sigma);
        }
        return sum;
    }
}
