package troupe.app.session;

import java.util.Optional;
import troupe.app.document.EventThread;
import troupe.app.document.Listeners;
import troupe.run.Run;

/** Holds the run that is kept to be compared with the one that is shown. Belongs to the event thread. */
public final class Comparison {
    private final Listeners<Comparison> listeners = new Listeners<>();
    private Optional<Kept> kept = Optional.empty();

    /** A run that is kept, and what it is called. */
    public record Kept(String name, Run run) {}

    /** Makes one that holds nothing. */
    Comparison() {}

    /** Returns the observers, told after each change. */
    public Listeners<Comparison> listeners() {
        return listeners;
    }

    /** Returns the run that is kept. */
    public Optional<Kept> kept() {
        return kept;
    }

    /** Keeps a run in place of the one before. */
    public void keep(String name, Run run) {
        EventThread.require();
        kept = Optional.of(new Kept(name, run));
        listeners.tell(this);
    }

    /** Lets go of the run. */
    public void drop() {
        EventThread.require();
        kept = Optional.empty();
        listeners.tell(this);
    }
}
