package troupe.risk.plan;

import troupe.risk.forecast.Forecast;

/**
 * Updates a plan to new forecasts: {@code Update_Path} and {@code Perturb_Path} of Avatars, figures 7 to 9. The
 * stretch from now to the horizon is led through a point moved off its middle, toward the straight line first and
 * then to either side; if that does not do, its halves are tried, down to four cells. In the end the changes are
 * kept if mean risk and length together are better.
 *
 * <p>Deviations: of stretches of equal risk the shorter is taken, so that an idle plan straightens and does not
 * wander; mean risk is compared stretch by stretch. Used by one thread at a time; it keeps its memory.
 */
public final class Updating {
    private static final double SAME = 1e-9;
    private static final double LEAST_CELLS = 4;

    private final Ground ground;
    private final PathRisk risk;
    private final int reach;
    private final double trade;
    private final double horizon;
    private final double cell;
    private final TimedPath work = new TimedPath();
    private final TimedPath trial = new TimedPath();
    private double now;
    private int tries;

    /**
     * Makes an updating.
     *
     * @param reach the cells that a middle may be moved aside
     * @param trade the metres of way that mean risk 1 counts
     * @param horizon seconds that are looked ahead
     */
    public Updating(Ground ground, PathRisk risk, int reach, double trade, double horizon) {
        this.ground = ground;
        this.risk = risk;
        this.reach = reach;
        this.trade = trade;
        this.horizon = horizon;
        this.cell = ground.region().frame().cell();
    }

    /** Returns the score of a path: its length in metres and {@code trade} times its mean risk; the less the better. */
    public double score(TimedPath path, double at) {
        return path.length() + trade * risk.mean(path, at);
    }

    /**
     * Updates a path that begins now.
     *
     * @return whether it was changed
     */
    public boolean update(TimedPath path, double at) {
        now = at;
        tries = 0;
        work.set(path);
        stretch(0, lastIndex(work));
        if (tries == 0 || !(score(work, now) < score(path, now) - SAME)) {
            return false;
        }
        path.set(work);
        return true;
    }

    private int lastIndex(TimedPath path) {
        int last = path.at(now + horizon);
        return Math.min(path.size() - 1, last + 1);
    }

    private void stretch(int l, int r) {
        if (r - l < 2 || work.length(l, r) < LEAST_CELLS * cell) {
            return;
        }
        int before = work.size();
        if (perturb(l, r)) {
            tries++;
            return;
        }
        int m = (l + r) / 2;
        stretch(l, m);
        int shift = work.size() - before;
        stretch(m + shift, r + shift);
    }

    /** Tries to lead the stretch through another point; tells whether the work was changed. */
    private boolean perturb(int l, int r) {
        double dx = work.x(r) - work.x(l);
        double dy = work.y(r) - work.y(l);
        double chord = Math.sqrt(dx * dx + dy * dy);
        if (chord < SAME) {
            return false;
        }
        int m = middle(l, r);
        double nx = -dy / chord;
        double ny = dx / chord;
        // how far the middle lies off the line, to its left
        double off = (work.x(m) - work.x(l)) * nx + (work.y(m) - work.y(l)) * ny;
        double sum = stretchRisk(work, work.t(l), work.t(r));
        double length = work.length(l, r);
        double inward = off > 0 ? -1 : 1;
        if (Math.abs(off) > SAME && attempt(l, r, work.x(m) - off * nx, work.y(m) - off * ny, sum, length)) {
            return true;
        }
        for (int k = 1; k <= reach; k++) {
            for (int side = 0; side < 2; side++) {
                double by = (side == 0 ? inward : -inward) * k * cell;
                if (attempt(l, r, work.x(m) + by * nx, work.y(m) + by * ny, sum, length)) {
                    return true;
                }
            }
        }
        return false;
    }

    private int middle(int l, int r) {
        double half = work.length(l, r) / 2;
        int m = l;
        double sum = 0;
        while (m + 1 < r - 1 && sum < half) {
            m++;
            sum += work.length(m - 1, m);
        }
        return Math.max(l + 1, m);
    }

    private double stretchRisk(TimedPath path, double from, double to) {
        return risk.sum(path, now, from, Math.min(to, now + horizon), Double.POSITIVE_INFINITY);
    }

    private boolean attempt(int l, int r, double x, double y, double sum, double length) {
        double dx = x - work.x(l);
        double dy = y - work.y(l);
        double ex = work.x(r) - x;
        double ey = work.y(r) - y;
        double longer = Math.sqrt(dx * dx + dy * dy) + Math.sqrt(ex * ex + ey * ey);
        double took = work.t(r) - work.t(l);
        double takes = longer / ground.speed();
        if (sum <= SAME && longer >= length - SAME && takes >= took - SAME) {
            return false;
        }
        trial.clear();
        trial.add(work, 0, l + 1, 0);
        int q = lead(x, y);
        if (q < 0 || lead(work.x(r), work.y(r)) != work.q(r)) {
            return false;
        }
        double later = trial.t(trial.size() - 1) - work.t(r);
        int end = trial.size() - 1;
        trial.add(work, r + 1, work.size(), later);
        double steps = took / Forecast.STEP;
        double mean = steps > 0 ? sum / steps : 0;
        double most = mean * takes / Forecast.STEP;
        double found = risk.sum(trial, now, trial.t(l), Math.min(trial.t(end), now + horizon), most);
        boolean better = found < most - SAME || found <= most + SAME && takes < took - SAME;
        if (!better || risk.hits(trial, now, trial.t(l), now + horizon)) {
            return false;
        }
        work.set(trial);
        return true;
    }

    /** Leads the trial straight on to a place, a point each cell; returns the place's configuration, -1 if barred. */
    private int lead(double x, double y) {
        int last = trial.size() - 1;
        double fromX = trial.x(last);
        double fromY = trial.y(last);
        double fromT = trial.t(last);
        double dx = x - fromX;
        double dy = y - fromY;
        double length = Math.sqrt(dx * dx + dy * dy);
        int pieces = (int) Math.max(1, Math.rint(length / cell));
        int q = trial.q(last);
        for (int k = 1; k <= pieces && q >= 0; k++) {
            double share = (double) k / pieces;
            double px = trial.x(trial.size() - 1);
            double py = trial.y(trial.size() - 1);
            q = ground.follow(px, py, q, fromX + share * dx, fromY + share * dy);
            trial.add(fromX + share * dx, fromY + share * dy, fromT + share * length / ground.speed(), q);
        }
        return q;
    }
}
