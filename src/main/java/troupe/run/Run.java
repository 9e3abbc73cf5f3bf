package troupe.run;

import java.util.List;
import troupe.run.frame.Frames;
import troupe.scene.Scene;
import troupe.search.Outcome;

/**
 * Holds what was planned: the scene with all settings applied, the task, how it ended, its report, the
 * frames, and the paths to draw. It stands alone: scene, task and seed make the same run again.
 *
 * @param task id of the task in {@code scene}
 * @param inputs live input by step, in order; empty if there was none
 */
public record Run(
        Scene scene, String task, Outcome outcome, Report report, Frames frames, List<Leg> legs, List<Input> inputs) {

    /** Copies the lists. */
    public Run {
        legs = List.copyOf(legs);
        inputs = List.copyOf(inputs);
    }

    /**
     * A stretch of a path travelled with one ability: {@code x, y, z} triples in metres, the times in
     * seconds at which it begins and ends, and the energy in joules that it takes. {@code what} is the id
     * of the obstacle vaulted or moved, empty otherwise.
     */
    public record Leg(
            String actor,
            String ability,
            String what,
            double begin,
            double end,
            double energy,
            List<double[]> points) {}

    /** A value that was given from outside while the task ran: {@code key = value} before step {@code step}. */
    public record Input(long step, String key, double value) {}
}
