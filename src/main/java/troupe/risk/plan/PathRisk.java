package troupe.risk.plan;

import troupe.risk.forecast.Forecast;

/** Sums the risk of a path over time, sampled at the forecast's steps. Used by one thread at a time. */
public final class PathRisk {
    private final Forecast forecast;
    private final Hazards hazards;

    /** Makes a judge of paths. */
    public PathRisk(Forecast forecast, Hazards hazards) {
        this.forecast = forecast;
        this.hazards = hazards;
    }

    /**
     * Returns the risk of a path added up over the steps of the forecast whose time lies in a span, in risk times
     * steps; it gives up once the sum is above {@code most}, and returns what it has.
     *
     * @param now the time in seconds of step 0
     * @param from the first time in seconds
     * @param to the last time in seconds, exclusive
     */
    public double sum(TimedPath path, double now, double from, double to, double most) {
        double sum = 0;
        int first = (int) Math.max(0, Math.ceil((from - now) / Forecast.STEP - 1e-9));
        for (int i = first; i <= forecast.steps() && now + i * Forecast.STEP < to - 1e-9 && sum <= most; i++) {
            sum += at(path, now, i);
        }
        return sum;
    }

    /** Returns the risk of a path at a step of the forecast. */
    public double at(TimedPath path, double now, int step) {
        double time = now + step * Forecast.STEP;
        int i = path.at(time);
        double vx = 0;
        double vy = 0;
        if (i + 1 < path.size()) {
            double span = path.t(i + 1) - path.t(i);
            vx = span > 0 ? (path.x(i + 1) - path.x(i)) / span : 0;
            vy = span > 0 ? (path.y(i + 1) - path.y(i)) / span : 0;
        }
        return forecast.risk(path.xAt(time), path.yAt(time), vx, vy, step);
    }

    /** Returns the mean risk of a path from now to the horizon or its end, 0 if it has ended. */
    public double mean(TimedPath path, double now) {
        int last = (int) Math.min(forecast.steps(), Math.floor((path.t(path.size() - 1) - now) / Forecast.STEP + 1e-9));
        double sum = 0;
        for (int i = 0; i <= last; i++) {
            sum += at(path, now, i);
        }
        return last < 0 ? 0 : sum / (last + 1);
    }

    /** Tells whether a path touches what is certain between two times in seconds. */
    public boolean hits(TimedPath path, double now, double from, double to) {
        int first = (int) Math.max(0, Math.floor((from - now) / Hazards.STAMP));
        for (int k = first; k < hazards.most() && now + k * Hazards.STAMP <= to + 1e-9; k++) {
            double time = now + k * Hazards.STAMP;
            if (time <= path.t(path.size() - 1) && hazards.hits(path.xAt(time), path.yAt(time), time - now)) {
                return true;
            }
        }
        return false;
    }
}
