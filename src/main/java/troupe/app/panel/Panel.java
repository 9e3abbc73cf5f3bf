package troupe.app.panel;

import java.awt.LayoutManager;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import troupe.app.look.Look;
import troupe.app.session.Session;
import troupe.paint.Tone;

/** A part of the window that shows a session, and leaves what it observes when it is closed. */
public abstract class Panel extends JPanel implements AutoCloseable {
    private final transient Look look;
    private final transient Session session;
    private final transient List<Runnable> leave = new ArrayList<>();

    /** Makes a panel of a session. */
    protected Panel(Look look, Session session, LayoutManager layout) {
        super(layout);
        this.look = look;
        this.session = session;
        setBackground(look.color(Tone.PANEL));
    }

    /** Returns the looks. */
    protected final Look look() {
        return look;
    }

    /** Returns the session. */
    protected final Session session() {
        return session;
    }

    /** Remembers what removes an observer again. */
    protected final void observing(Runnable remover) {
        leave.add(remover);
    }

    @Override
    public void close() {
        leave.forEach(Runnable::run);
    }
}
