package troupe.risk.forecast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.region.Region;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Growth;
import troupe.scene.Encounter.Influence;
import troupe.scene.Encounter.Quantity;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

/** Checks equations 1 to 5 against values worked out by hand, and what they must keep to. */
class EquationsTest {
    private static final double STEP = Forecast.STEP;

    private static History walked(double x, double y, double vx, double vy, int positions) {
        History history = new History(64);
        for (int k = positions - 1; k >= 0; k--) {
            history.see(10 - k * STEP, x - k * STEP * vx, y - k * STEP * vy);
        }
        return history;
    }

    private static Ways ways(Obstacle... walls) {
        Scene scene = new Scene("", new World(10, 10, 0.1), List.of(walls), List.of(), List.of(), List.of());
        return new Ways(Region.of(scene, Actor.walker("p", 0, 0)));
    }

    private static Encounter encounter(Map<Quantity, Double> numbers) {
        Encounter plain = Encounter.of(
                "e", "a", Place.of(1, 1), Place.of(9, 9), List.of(Avatar.of("b", new Avatar.Pointer(Place.of(5, 5)))));
        for (Map.Entry<Quantity, Double> number : numbers.entrySet()) {
            plain = plain.with(number.getKey(), number.getValue());
        }
        return plain;
    }

    private static Forecast forecast(Encounter encounter, History past, Obstacle... walls) {
        Forecast forecast = new Forecast(encounter, ways(walls));
        forecast.compute(List.of(past));
        return forecast;
    }

    @Test
    void equation1AddsTheChangesOfVelocityHalvedEachTimeFurtherBack() {
        // velocities, newest first: 1.4, 1.0, 0.9; changes 0.4 and 0.1; 1.4 + 0.4 + 0.1 / 2 = 1.85
        Expectation expectation = new Expectation(3, 0.1);
        double[] xs = {0.33, 0.19, 0.09, 0};
        expectation.expect(xs, new double[4], 4, 10);
        assertEquals(1.85, expectation.vx(), 1e-12);
        assertEquals(0, expectation.vy(), 1e-12);
        // missing terms are none: with two positions the velocity alone
        expectation.expect(xs, new double[4], 2, 10);
        assertEquals(1.4, expectation.vx(), 1e-12);
        expectation.expect(xs, new double[4], 1, 10);
        assertEquals(0, expectation.vx());
    }

    @Test
    void theExpectedSpeedIsCapped() {
        Expectation expectation = new Expectation(3, 0.1);
        expectation.expect(new double[] {0.6, 0, 0, 0}, new double[] {0.8, 0, 0, 0}, 4, 1.5);
        assertEquals(0.9, expectation.vx(), 1e-12);
        assertEquals(1.2, expectation.vy(), 1e-12);
    }

    @Test
    void theHistoryIsResampledOnStraightLines() {
        History history = new History(8);
        history.see(0, 0, 0);
        history.see(0.4, 4, 2);
        double[] xs = new double[3];
        double[] ys = new double[3];
        assertEquals(3, history.resample(0.15, xs, ys));
        assertEquals(4, xs[0], 1e-12);
        assertEquals(2.5, xs[1], 1e-12);
        assertEquals(0.5, ys[2], 1e-12);
        assertEquals(2, history.resample(0.3, xs, ys));
    }

    @Test
    void equations2And3MoveAndBlurThePlace() {
        Forecast forecast = forecast(encounter(Map.of(Quantity.SIGMA, 0.2)), walked(3, 4, 1, 0.5, 9));
        assertEquals(3 + 1 * 1.6, forecast.expectedX(0, 1.6), 1e-9);
        assertEquals(4 + 0.5 * 1.6, forecast.expectedY(0, 1.6), 1e-9);
        assertEquals(0.2 * (1 + Avatar.DEFAULT_MOBILITY * 1.6), forecast.sigma(0, 1.6), 1e-12);
        assertEquals(0.2 * (1 + 2 * 1.5), new Blur(0.2, Growth.ROOT, 2).after(2.25), 1e-12);
        assertEquals(0.2, new Blur(0.2, Growth.CONSTANT, 2).after(3), 1e-12);
    }

    @Test
    void equation4IsAGaussianOfTwoDimensions() {
        Forecast forecast = forecast(encounter(Map.of(Quantity.SIGMA, 0.4)), walked(5.05, 5.05, 0, 0, 9));
        float[] density = density(forecast, ways(), 0);
        int cols = ways().frame().cols();
        int middle = ways().frame().cellAt(5.05, 5.05);
        assertEquals(1 / (2 * Math.PI * 0.16), density[middle], 2e-3);
        assertEquals(1 / (2 * Math.PI * 0.16) * Math.exp(-0.5), density[middle + 4], 2e-3);
        assertEquals(density[middle + 4], density[middle + 4 * cols], 1e-6);
    }

    private static float[] density(Forecast forecast, Ways ways, double seconds) {
        float[] density = new float[ways.frame().size()];
        new ProbabilityMap(forecast, ways).add(0, seconds, density);
        return density;
    }

    @Test
    void theDensityAddsUpToOneAtEveryStepWithWallsClipped() {
        Obstacle wall = new Obstacle("w", "", Polygon.rectangle(6, 0, 6.3, 9), 0, 2, false, 20, "");
        Ways ways = ways(wall);
        for (double sigma : new double[] {0.03, 0.1, 0.3}) {
            Forecast forecast = forecast(encounter(Map.of(Quantity.SIGMA, sigma)), walked(5, 2, 1.2, 0, 9), wall);
            for (int step = 0; step <= forecast.steps(); step++) {
                float[] density = density(forecast, ways, step * STEP);
                double sum = 0;
                double behind = 0;
                for (int cell = 0; cell < density.length; cell++) {
                    double mass = density[cell] * 0.01;
                    sum += mass;
                    boolean inWall = !ways.isFree(cell);
                    assertTrue(!inWall || density[cell] == 0, "mass in a wall at step " + step);
                    boolean beyond = ways.frame().centreX(ways.frame().col(cell)) > 6.3
                            && ways.frame().centreY(ways.frame().row(cell)) < 6;
                    behind += beyond ? mass : 0;
                }
                assertEquals(1, sum, 0.01, "sigma " + sigma + ", step " + step);
                assertEquals(0, behind, 1e-9, "it would take 7 m round the wall, step " + step);
            }
        }
    }

    @Test
    void equation5IsWorkedOutByHandForACertainPlace() {
        // an avatar that hardly blurs, at (5, 5), at rest; the actor 1 m to its left
        Encounter encounter =
                encounter(Map.of(Quantity.SIGMA, 0.001, Quantity.W0, 3.0, Quantity.W1, -2.0, Quantity.W2, -0.5));
        Forecast forecast = forecast(encounter, walked(5, 5, 0, 0, 9));
        assertEquals(3 - 2, forecast.risk(4, 5, 0, 0, 0), 0.01);
        // closing in at 1.2 m/s: d' = -1.2, so 0.6 more; going away: 0.6 less
        assertEquals(1.6, forecast.risk(4, 5, 1.2, 0, 0), 0.01);
        assertEquals(0.4, forecast.risk(4, 5, -1.2, 0, 0), 0.01);
        // moving across changes nothing, and far away it is cut to none
        assertEquals(1, forecast.risk(4, 5, 0, 1.2, 0), 0.01);
        assertEquals(0, forecast.risk(2, 5, 0, 0, 0));
    }

    @Test
    void influenceFallsWithDistanceAndWithOpeningSpeed() {
        Forecast forecast = forecast(encounter(Map.of()), walked(5, 5, 0.8, 0, 9));
        for (int step = 0; step <= forecast.steps(); step += 5) {
            double x = forecast.expectedX(0, step * STEP);
            double last = Double.POSITIVE_INFINITY;
            for (double away = 0; away < 4; away += 0.1) {
                double here = forecast.risk(x, 5 + away, 0.8, 0, step);
                assertTrue(here <= last + 1e-6, "step " + step + ", " + away + " m");
                last = here;
            }
            last = Double.POSITIVE_INFINITY;
            for (double opening = -2; opening <= 2; opening += 0.25) {
                double here = forecast.risk(x, 6, 0.8, opening, step);
                assertTrue(here <= last + 1e-9, "step " + step + ", opening at " + opening);
                last = here;
            }
        }
    }

    @Test
    void theInfluenceAgreesWithAFineSumOverTheDisc() {
        Forecast forecast = forecast(encounter(Map.of(Quantity.W0, 3.0)), walked(5, 5, 0.8, 0.3, 9));
        for (int step = 0; step <= forecast.steps(); step += 8) {
            double seconds = step * STEP;
            double sigma = forecast.sigma(0, seconds);
            double mx = forecast.expectedX(0, seconds);
            double my = forecast.expectedY(0, seconds);
            double sum = 0;
            double mass = 0;
            int n = 200;
            for (int i = -n; i <= n; i++) {
                for (int j = -n; j <= n; j++) {
                    double dx = 2.5 * sigma * i / n;
                    double dy = 2.5 * sigma * j / n;
                    if (dx * dx + dy * dy <= 6.25 * sigma * sigma) {
                        double p = Math.exp(-(dx * dx + dy * dy) / (2 * sigma * sigma));
                        double d = Math.hypot(mx + 0.6 - mx - dx, my - 0.2 - my - dy);
                        double rate = ((0.2 - 0.8) * (0.6 - dx) + (1 - 0.3) * (-0.2 - dy)) / d;
                        sum += p * Math.max(0, 3 - 2 * d - 0.5 * rate);
                        mass += p;
                    }
                }
            }
            double found = forecast.risk(mx + 0.6, my - 0.2, 0.2, 1, step);
            assertEquals(sum / mass, found, 0.06 * Math.max(0.3, sum / mass), "step " + step);
        }
    }

    @Test
    void thePapersInfluenceIsTheBareMeanWithTheNormaliserOfOneDimension() {
        Map<Quantity, Double> numbers =
                Map.of(Quantity.SIGMA, 0.5, Quantity.W0, 1000.0, Quantity.W1, 0.0, Quantity.W2, 0.0);
        Forecast forecast = forecast(encounter(numbers).with(Influence.PAPER), walked(5, 5, 0, 0, 9));
        // the mean of exp(-r^2/2) over the disc of 2.5 is (1 - exp(-3.125)) * 2 / 6.25
        double mean = (1 - Math.exp(-3.125)) * 2 / 6.25 / (0.5 * Math.sqrt(2 * Math.PI));
        assertEquals(1000 * mean, forecast.risk(5, 5, 0, 0, 0), 12);
    }
}
