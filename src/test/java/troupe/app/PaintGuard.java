package troupe.app;

import java.awt.EventQueue;
import javax.swing.JComponent;
import javax.swing.RepaintManager;

/** Remembers whether painting or layout was ever asked for off the event thread. */
final class PaintGuard extends RepaintManager {
    private volatile String wrong = "";

    @Override
    public void addDirtyRegion(JComponent component, int x, int y, int width, int height) {
        check(component);
        super.addDirtyRegion(component, x, y, width, height);
    }

    @Override
    public synchronized void addInvalidComponent(JComponent component) {
        check(component);
        super.addInvalidComponent(component);
    }

    private void check(JComponent component) {
        if (!EventQueue.isDispatchThread() && component.isShowing()) {
            wrong = component.getClass().getName() + " from "
                    + Thread.currentThread().getName();
            throw new IllegalStateException("painting asked for off the event thread: " + wrong);
        }
    }

    /** Returns what was wrong, empty if nothing was. */
    String wrong() {
        return wrong;
    }
}
