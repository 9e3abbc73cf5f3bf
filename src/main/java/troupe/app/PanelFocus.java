package troupe.app;

import java.awt.Component;
import java.awt.Container;
import java.awt.KeyboardFocusManager;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import troupe.app.look.Named;

/** Leads the keys from panel to panel: top bar, tools, outline, views, canvas, inspector, timeline, start page. */
final class PanelFocus {
    private static final List<String> PANELS =
            List.of("top", "tools", "outline", "start", "chips", "canvas", "solid", "inspector", "timeline", "tour");

    private PanelFocus() {}

    /** Gives the keys to the first part of the next panel that is shown, or of the one before; round and round. */
    static void move(JFrame frame, boolean forward) {
        List<Component> panels = shown(frame);
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        int at = forward ? -1 : 0;
        boolean found = false;
        for (int i = 0; i < panels.size(); i++) {
            boolean within = owner != null && SwingUtilities.isDescendingFrom(owner, panels.get(i));
            // the views lie in the canvas: the innermost panel counts
            if (within && (!found || SwingUtilities.isDescendingFrom(panels.get(i), panels.get(at)))) {
                at = i;
                found = true;
            }
        }
        for (int step = 1; step <= panels.size(); step++) {
            int next = Math.floorMod(forward ? at + step : at - step, panels.size());
            Optional<Component> first = first(panels.get(next));
            if (first.isPresent() && first.get() != owner) {
                FocusEvent.Cause cause =
                        forward ? FocusEvent.Cause.TRAVERSAL_FORWARD : FocusEvent.Cause.TRAVERSAL_BACKWARD;
                first.get().requestFocusInWindow(cause);
                return;
            }
        }
    }

    private static List<Component> shown(JFrame frame) {
        List<Component> panels = new ArrayList<>();
        for (String name : PANELS) {
            Named.find(frame, name).filter(Component::isShowing).ifPresent(panels::add);
        }
        return panels;
    }

    /** Returns the panel itself if it takes keys, else the first part of it that does. */
    private static Optional<Component> first(Component panel) {
        if (takesKeys(panel)) {
            return Optional.of(panel);
        }
        if (panel instanceof Container container) {
            for (Component part : container.getComponents()) {
                Optional<Component> found = first(part);
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }

    private static boolean takesKeys(Component part) {
        return new Takers().accept(part);
    }

    /** Knows what takes keys, as the Tab key does. */
    private static final class Takers extends javax.swing.LayoutFocusTraversalPolicy {
        @Override
        public boolean accept(Component part) {
            return super.accept(part);
        }
    }
}
