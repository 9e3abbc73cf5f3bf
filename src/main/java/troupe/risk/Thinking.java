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
import troupe.risk.plan.Updating;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Method;
import troupe.scene.Encounter.Quantity;
import troupe.search.Outcome;

/**
 * Decides at every step how the actor goes on: keeps, updates or makes its plan (Avatars, section 4.2), waits, or
 * steps aside. It sees where the avatars are now; of certain ones it knows the course.
 */
final class Thinking {
    /** A search that has not ended by then is given up for this step. */
    private static final long LIMIT = 60_000;
    /** A fresh plan is straightened in so many passes at most. */
    private static final int PASSES = 6;
    /** An evading actor looks so many directions round. */
    private static final int DIRECTIONS = 16;
    /** An evading actor looks so many steps of the forecast ahead. */
    private static final int INSTANTS = 4;
    /** What a metre of overlap counts to one that evades, in risk. */
    private static final double TOUCH = 1e3;

    private final Encounter encounter;
    private final Ground ground;
    private final List<Course> courses;
    private final List<History> histories = new ArrayList<>();
    private final Forecast forecast;
    private final Hazards hazards;
    private final PathRisk risk;
    private final TimeSearch search;
    private final Updating updating;
    private final TimedPath path = new TimedPath();
    private final double[] near;
    private final double step;
    private final boolean still;
    private boolean planned;
    private long expanded;
    private double x;
    private double y;
    private int q;

    Thinking(Encounter encounter, double radius, Ground ground, Ways ways, List<Course> courses) {
        this.encounter = encounter;
        this.ground = ground;
        this.courses = courses;
        near = new double[courses.size()];
        for (int a = 0; a < near.length; a++) {
            histories.add(new History(Forecast.capacity(encounter)));
            near[a] = radius
                    + encounter.avatars().get(a).radius()
                    + 0.5 * ground.region().frame().cell();
        }
        double horizon = encounter.number(Quantity.HORIZON);
        still = encounter.method() == Method.STATIC;
        step = 1 / encounter.number(Quantity.RATE);
        forecast = new Forecast(encounter, ways);
        hazards = new Hazards(near, horizon);
        risk = new PathRisk(forecast, hazards);
        search = new TimeSearch(ground, encounter, forecast, hazards, LIMIT);
        updating = new Updating(
                ground, risk, (int) encounter.number(Quantity.REACH), encounter.number(Quantity.TRADE), horizon);
    }

    /** Sees where an avatar is at a time; NaN if it is not there. */
    void see(int avatar, double time, double atX, double atY) {
        if (Double.isNaN(atX)) {
            histories.get(avatar).clear();
        } else {
            histories.get(avatar).see(time, atX, atY);
        }
    }

    /** Decides how to go on from a place. */
    Action decide(double now, double atX, double atY, int atQ) {
        x = atX;
        y = atY;
        q = atQ;
        if (planned) {
            path.begin(now);
        }
        if (planned && encounter.method() == Method.ONCE) {
            return Action.KEPT;
        }
        look(now);
        if (planned && !still) {
            if (!risk.hits(path, now, now, now + encounter.number(Quantity.HORIZON))) {
                return updating.update(path, now) ? Action.UPDATED : Action.KEPT;
            }
        }
        return replan(now);
    }

    private void look(double now) {
        if (!still) {
            forecast.compute(histories);
        }
        hazards.clear();
        for (int a = 0; a < courses.size(); a++) {
            boolean certain = encounter.avatars().get(a).kind() == Avatar.Kind.CERTAIN;
            double atX = courses.get(a).x(now);
            double atY = courses.get(a).y(now);
            for (int k = 0; k < hazards.most() && !Double.isNaN(atX); k++) {
                double ahead = k * Hazards.STAMP;
                if (still) {
                    hazards.stamp(a, k, atX, atY);
                } else if (certain) {
                    hazards.stamp(
                            a, k, courses.get(a).x(now + ahead), courses.get(a).y(now + ahead));
                } else if (ahead <= Hazards.PRESENT) {
                    hazards.stamp(a, k, forecast.expectedX(a, ahead), forecast.expectedY(a, ahead));
                }
            }
        }
    }

    private Action replan(double now) {
        Outcome outcome = search.search(x, y, q, now, path);
        expanded += search.expanded();
        planned = outcome.isFound();
        if (planned) {
            for (int pass = 0; pass < PASSES && updating.update(path, now); pass++) {
                // until nothing is gained
            }
            return Action.REPLANNED;
        }
        path.clear();
        path.add(x, y, now, q);
        if (!hazards.hits(x, y, 0) && !hazards.hits(x, y, step)) {
            path.add(x, y, now + step, q);
            return Action.WAITED;
        }
        evade(now);
        return Action.EVADED;
    }

    /** Steps to the place round about from where the next instants are least dangerous, as if it went on so. */
    private void evade(double now) {
        double bestX = x;
        double bestY = y;
        int bestQ = q;
        double least = Double.POSITIVE_INFINITY;
        for (int d = -1; d < DIRECTIONS; d++) {
            double angle = 2 * Math.PI * d / DIRECTIONS;
            double speed = d < 0 ? 0 : ground.speed();
            double vx = speed * StrictMath.cos(angle);
            double vy = speed * StrictMath.sin(angle);
            int to = ground.follow(x, y, q, x + vx * step, y + vy * step);
            double danger = to < 0 ? Double.POSITIVE_INFINITY : danger(now, vx, vy);
            if (danger < least) {
                least = danger;
                bestX = x + vx * step;
                bestY = y + vy * step;
                bestQ = to;
            }
        }
        path.add(bestX, bestY, now + step, bestQ);
    }

    /** Returns the risk of going on with a velocity for some instants, until a wall; who would touch it outweighs all. */
    private double danger(double now, double vx, double vy) {
        double sum = 0;
        double atX = x;
        double atY = y;
        boolean goes = true;
        for (int k = 1; k <= INSTANTS; k++) {
            double ahead = k * Forecast.STEP;
            goes = goes && ground.follow(x, y, q, x + vx * ahead, y + vy * ahead) >= 0;
            atX = goes ? x + vx * ahead : atX;
            atY = goes ? y + vy * ahead : atY;
            sum += forecast.risk(atX, atY, goes ? vx : 0, goes ? vy : 0, forecast.step(ahead));
            sum += TOUCH * overlap(now, atX, atY, ahead);
        }
        return sum;
    }

    /** Returns by how many metres avatars would be too near at a place, where they are expected then. */
    private double overlap(double now, double atX, double atY, double ahead) {
        double sum = 0;
        for (int a = 0; a < near.length; a++) {
            Course course = courses.get(a);
            boolean certain = encounter.avatars().get(a).kind() == Avatar.Kind.CERTAIN;
            double time = certain && !still ? now + ahead : now;
            boolean expected = !certain && !still && forecast.has(a);
            double dx = atX - (expected ? forecast.expectedX(a, ahead) : course.x(time));
            double dy = atY - (expected ? forecast.expectedY(a, ahead) : course.y(time));
            double less = near[a] - Math.sqrt(dx * dx + dy * dy);
            sum += less > 0 ? less : 0;
        }
        return sum;
    }

    /** Returns the plan: where the actor will be, from now on. */
    TimedPath path() {
        return path;
    }

    /** Returns the mean risk of the plan from now on. */
    double risk(double now) {
        return risk.mean(path, now);
    }

    long expanded() {
        return expanded;
    }
}
