package troupe.app.plan;

import java.util.List;
import troupe.run.Simulation;

/**
 * Tells of a simulation what its run does not.
 *
 * @param controls what can be set while it runs
 * @param stepMillis how long each of its steps took, in milliseconds of this machine; not to be changed
 */
public record Live(List<Simulation.Control> controls, double[] stepMillis) {
    /** Of tasks that are no simulations. */
    public static final Live NONE = new Live(List.of(), new double[0]);

    /** Copies the list. */
    public Live {
        controls = List.copyOf(controls);
    }
}
