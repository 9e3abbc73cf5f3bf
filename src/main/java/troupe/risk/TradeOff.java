package troupe.risk;

import java.util.ArrayList;
import java.util.List;
import troupe.risk.forecast.Forecast;
import troupe.risk.forecast.History;
import troupe.risk.forecast.Ways;
import troupe.risk.plan.Ground;
import troupe.risk.plan.Hazards;
import troupe.risk.plan.PathRisk;
import troupe.risk.plan.TimeSearch;
import troupe.risk.plan.TimedPath;
import troupe.scene.Actor;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Quantity;
import troupe.scene.Scene;

/**
 * Tells what caution costs: for each caution the plan of least length plus caution times risk, after the avatars
 * have been watched for a second from the start.
 */
public final class TradeOff {
    /** Seconds that the avatars are watched before the plans are made. */
    public static final double WATCHED = 1;

    private static final long LIMIT = 2_000_000;

    private TradeOff() {}

    /**
     * One plan.
     *
     * @param caution metres of way that a second of risk 1 counts
     * @param length of the plan in metres
     * @param risk gathered on the plan up to the horizon, in seconds of risk 1
     * @param seconds that the plan takes, waits included
     */
    public record Choice(double caution, double length, double risk, double seconds) {}

    /**
     * Plans an encounter with each caution; one that has no plan is left out.
     *
     * @throws IllegalArgumentException if the scene lacks the actor, or a caution is out of range
     */
    public static List<Choice> of(Scene scene, Encounter encounter, List<Double> cautions) {
        Actor actor = scene.actor(encounter.actor())
                .orElseThrow(() -> new IllegalArgumentException("the scene has no actor '" + encounter.actor() + "'"));
        Ground ground = new Ground(scene, actor, encounter.goal());
        Ways ways = EncounterViews.ways(scene);
        List<History> pasts = watched(encounter);
        int start = ground.region().locate(encounter.start());
        List<Choice> choices = new ArrayList<>();
        for (double caution : cautions) {
            Encounter cautious = encounter
                    .with(Encounter.Method.RISK)
                    .with(Encounter.Order.OPTIMAL)
                    .with(Quantity.CAUTION, caution);
            Forecast forecast = new Forecast(cautious, ways);
            forecast.compute(pasts);
            Hazards hazards = new Hazards(new double[0], encounter.number(Quantity.HORIZON));
            TimedPath path = new TimedPath();
            TimeSearch search = new TimeSearch(ground, cautious, forecast, hazards, LIMIT);
            boolean found = start >= 0
                    && search.search(encounter.start().x(), encounter.start().y(), start, 0, path)
                            .isFound();
            if (found) {
                double end = path.t(path.size() - 1);
                double risk = new PathRisk(forecast, hazards).sum(path, 0, 0, end, Double.POSITIVE_INFINITY);
                choices.add(new Choice(caution, path.length(), risk * Forecast.STEP, end));
            }
        }
        return choices;
    }

    private static List<History> watched(Encounter encounter) {
        List<History> pasts = new ArrayList<>();
        double rate = encounter.number(Quantity.RATE);
        for (Course course : encounter.avatars().stream().map(Course::of).toList()) {
            History past = new History(Forecast.capacity(encounter));
            for (int k = 0; k <= WATCHED * rate; k++) {
                if (course.isThere(k / rate)) {
                    past.see(k / rate, course.x(k / rate), course.y(k / rate));
                }
            }
            pasts.add(past);
        }
        return pasts;
    }
}
