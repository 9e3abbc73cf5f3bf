package troupe.app.plan;

import java.util.concurrent.Executor;
import troupe.app.document.Listeners;
import troupe.app.document.Version;
import troupe.run.Run;
import troupe.search.Outcome;

/**
 * Tells on the event thread what was planned, and knows what is asked for: only what is of the revision asked for
 * last and newer than what was told before is told. A plan whose views are still to be made is told with those
 * of before, so that nothing flickers. What is asked for may be read by any thread; all else belongs to the event
 * thread.
 */
final class Announcer {
    private final Executor eventThread;
    private final Listeners<Plan> plans = new Listeners<>();
    private final Listeners<Work> works = new Listeners<>();
    private volatile Snapshot newest;
    private volatile Snapshot cancelled;
    private Version told = new Version(-1, 0);
    private Plan shown;

    /** Makes an announcer that nothing was asked for. */
    Announcer(Executor eventThread) {
        this.eventThread = eventThread;
    }

    Listeners<Plan> plans() {
        return plans;
    }

    Listeners<Work> works() {
        return works;
    }

    /** Notes what is asked for, null for nothing any more. */
    void ask(Snapshot snapshot) {
        newest = snapshot;
    }

    /** Returns what is asked for, null if nothing is. */
    Snapshot newest() {
        return newest;
    }

    /** Notes that the person does not want to wait for what is asked for, and says so. */
    void cancel() {
        Snapshot unwanted = newest;
        cancelled = unwanted;
        idle(unwanted);
    }

    /** Wants a snapshot again that may have been cancelled. */
    void resume(Snapshot snapshot) {
        if (cancelled == snapshot) {
            cancelled = null;
        }
    }

    boolean isCancelled(Snapshot snapshot) {
        return cancelled == snapshot;
    }

    /** Forgets the views that are shown, because the next plan is of something else. */
    void forget() {
        shown = null;
    }

    /** Tells that nothing is done for a snapshot any more, unless another one is asked for by then. */
    void idle(Snapshot snapshot) {
        eventThread.execute(() -> {
            if (newest == snapshot) {
                works.tell(Work.IDLE);
            }
        });
    }

    /** Tells how far the work of a request has come, while it is wanted. */
    void tell(Watch watch, Work work) {
        eventThread.execute(() -> {
            if (watch.isWanted()) {
                works.tell(work);
            }
        });
    }

    /** Tells a plan. */
    void tell(Watch watch, Plan plan) {
        eventThread.execute(() -> {
            Version version = plan.snapshot().version();
            if (isOfNow(watch) && version.compareTo(told) >= 0) {
                told = version;
                show(plan.withViews(plan.views().over(viewsBefore(plan))));
            }
        });
    }

    /** Tells a plan with new views; if a later moment of the same gesture has been told, puts its views there. */
    void tellViews(Watch watch, Plan plan) {
        eventThread.execute(() -> {
            if (isOfNow(watch) && (watch.isMoment() || watch.isNewest())) {
                boolean late = shown != null && plan.snapshot().version().compareTo(told) < 0;
                Plan under = late ? shown : plan;
                told = under.snapshot().version();
                Views merged = plan.views().over(viewsBefore(plan));
                show(under.withViews(late ? merged.aged() : merged));
            }
        });
    }

    private boolean isOfNow(Watch watch) {
        Snapshot asked = newest;
        return !watch.isLeft()
                && asked != null
                && asked.version().revision() == watch.snapshot().version().revision();
    }

    /** Returns the views that a plan may be shown with until its own are made. */
    private Views viewsBefore(Plan plan) {
        boolean follow = plan.run()
                .map(Run::outcome)
                .filter(outcome -> !outcome.isRunning() && !outcome.equals(Outcome.CANCELLED))
                .isPresent();
        boolean same =
                shown != null && shown.snapshot().task().equals(plan.snapshot().task());
        return follow && same ? shown.views() : Views.NONE;
    }

    private void show(Plan plan) {
        shown = plan;
        plans.tell(plan);
    }
}
