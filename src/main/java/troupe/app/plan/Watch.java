package troupe.app.plan;

import java.util.concurrent.TimeUnit;
import java.util.function.UnaryOperator;
import troupe.run.Run;

/** Watches the work for one request: whether it is still wanted, and when to report. Safe for any thread. */
final class Watch implements Simulating.Watcher {
    private static final long REPORT_MS = 60;

    private final Announcer announcer;
    private final Snapshot snapshot;
    private final long patienceMs;
    private volatile long begin = System.nanoTime();
    private volatile boolean left;
    private volatile long reported = begin - TimeUnit.MILLISECONDS.toNanos(REPORT_MS);
    private Plan latest;

    /** Watches the work for a snapshot, which within a gesture may go on for {@code patienceMs}. */
    Watch(Announcer announcer, Snapshot snapshot, long patienceMs) {
        this.announcer = announcer;
        this.snapshot = snapshot;
        this.patienceMs = patienceMs;
    }

    Snapshot snapshot() {
        return snapshot;
    }

    /** Begins to measure how long it takes. */
    void begin() {
        begin = System.nanoTime();
    }

    double elapsedMs() {
        return (System.nanoTime() - begin) / 1e6;
    }

    /** Tells whether it is of a moment of a gesture. */
    boolean isMoment() {
        return snapshot.version().preview() > 0;
    }

    /** Takes over what was told last of the same snapshot. */
    synchronized void goOnFrom(Plan plan) {
        latest = plan;
    }

    /** Returns what was told last, null if nothing was. */
    synchronized Plan latest() {
        return latest;
    }

    synchronized void tell(Plan plan) {
        latest = plan;
        announcer.tell(this, plan);
    }

    /** Tells more of the plan unless the person has cancelled this work. */
    synchronized void tellWanted(UnaryOperator<Plan> more) {
        if (!isCancelled()) {
            tell(more.apply(latest));
        }
    }

    /** Tells the views of the plan. */
    synchronized void tellViews(Views views) {
        latest = latest.withViews(views);
        announcer.tellViews(this, latest);
    }

    /** Notes that its work is left behind: nothing more of it is told. */
    void leave() {
        left = true;
    }

    boolean isLeft() {
        return left;
    }

    /** Tells whether this very snapshot is asked for. */
    boolean isNewest() {
        return announcer.newest() == snapshot && !left;
    }

    /** Tells whether this very snapshot is asked for, and not cancelled. */
    boolean isWanted() {
        return isNewest() && !isCancelled();
    }

    /** Tells whether this work was cancelled or is of another revision than the one asked for. */
    boolean isUnwanted() {
        Snapshot asked = announcer.newest();
        return isCancelled()
                || asked == null
                || asked.version().revision() != snapshot.version().revision();
    }

    @Override
    public boolean isCancelled() {
        return announcer.isCancelled(snapshot);
    }

    @Override
    public boolean isObsolete() {
        return announcer.newest() != snapshot && (isUnwanted() || elapsedMs() > patienceMs);
    }

    @Override
    public void publish(Run run, Live live) {
        tell(latest().grown(run, live, elapsedMs()));
    }

    @Override
    public void report(long done, double share) {
        long now = System.nanoTime();
        if (now - reported >= TimeUnit.MILLISECONDS.toNanos(REPORT_MS)) {
            reported = now;
            announcer.tell(this, new Work(true, done, share));
        }
    }
}
