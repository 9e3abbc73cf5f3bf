package troupe.app.document;

import java.awt.EventQueue;

/** Guards what belongs to the event thread. */
public final class EventThread {
    private EventThread() {}

    /**
     * Checks that the caller runs on the event thread.
     *
     * @throws IllegalStateException if it does not
     */
    public static void require() {
        if (!EventQueue.isDispatchThread()) {
            throw new IllegalStateException(
                    "called from " + Thread.currentThread().getName() + "; the document belongs to the event thread");
        }
    }
}
