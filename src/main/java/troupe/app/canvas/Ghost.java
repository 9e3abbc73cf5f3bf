package troupe.app.canvas;

import java.awt.Graphics2D;
import troupe.app.look.Look;
import troupe.app.session.Comparison;
import troupe.app.session.Session;
import troupe.paint.Viewport;
import troupe.paint.motion.GhostPainter;

/** Paints the run that is kept for comparison. Belongs to the event thread. */
final class Ghost {
    private final Look look;
    private final Session session;
    private Comparison.Kept of;
    private GhostPainter painter;

    Ghost(Look look, Session session) {
        this.look = look;
        this.session = session;
    }

    private void refresh() {
        Comparison.Kept kept = session.comparison().kept().orElse(null);
        if (kept != of) {
            of = kept;
            painter = kept == null ? null : new GhostPainter(kept.run(), look.theme());
        }
    }

    /** Returns what its painting depends on. */
    Object stamp() {
        refresh();
        return painter == null ? "" : painter;
    }

    /** Paints its ways, if a run is kept. */
    void paintWays(Graphics2D g, Viewport view) {
        refresh();
        if (painter != null) {
            painter.paintWays(g, view);
        }
    }

    /** Paints its movers at the moment shown, if a run is kept. */
    void paintMovers(Graphics2D g, Viewport view) {
        refresh();
        if (painter != null) {
            painter.paintMovers(g, view, session.playback().time());
        }
    }
}
