package troupe.app.plan;

import java.util.Optional;
import java.util.function.Supplier;
import troupe.app.document.EventThread;

/**
 * Lets a person take part in the simulation that is shown. What is set while nothing is shown has no effect.
 * Belongs to the event thread.
 */
public final class Intervention {
    private final Supplier<Optional<Steering>> shown;
    private final Runnable wake;

    /** Makes the interventions in what {@code shown} gives; {@code wake} is told after each. */
    Intervention(Supplier<Optional<Steering>> shown, Runnable wake) {
        this.shown = shown;
        this.wake = wake;
    }

    /**
     * Takes hold at a step: what was simulated from it on is dropped, and until {@link #release()} the simulation
     * stays near the steps told by {@link #pace}.
     */
    public void grab(long step) {
        EventThread.require();
        shown.get().ifPresent(s -> s.grab(step));
        wake.run();
    }

    /** Sets a value from the next step of the simulation on. */
    public void set(String control, double value) {
        EventThread.require();
        shown.get().ifPresent(s -> s.set(control, value));
        wake.run();
    }

    /** Tells the step that is shown, for a simulation that is held. */
    public void pace(long step) {
        shown.get().ifPresent(s -> s.pace(step));
    }

    /** Lets the simulation run ahead again. */
    public void release() {
        EventThread.require();
        shown.get().ifPresent(Steering::release);
        wake.run();
    }
}
