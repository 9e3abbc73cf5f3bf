package troupe.run;

import java.util.List;

/**
 * Simulates step by step and takes input from outside while it works: where a person steers an avatar, a slider
 * that is moved. One unit of {@link #step} is one step of the simulation, which makes one frame, and
 * {@link Engine.Progress#work()} the number of steps done. The run holds what was given, so that the same scene,
 * task and inputs make the same run again.
 */
public interface Simulation extends Engine {

    /** Returns what can be set while it runs, in a fixed order; never null, may be empty. */
    List<Control> controls();

    /**
     * Gives a value that holds from step {@code input.step()} on; steps count from 0. It then stands in the inputs
     * of the run. Values are given in the order of their steps; of several for one key and step the last holds.
     *
     * @throws IllegalArgumentException if there is no such control, the value lies outside its range or is not
     *     finite, or the step lies before the steps done or before that of an earlier input; nothing is then changed
     */
    void give(Run.Input input);

    /**
     * Names a value that can be set while a simulation runs.
     *
     * @param key its name in {@link Run.Input}: {@code avatar.ID.x}, {@code weight.separation}, …
     * @param owner id of the element that it belongs to
     * @param unit its unit, empty for a bare number
     * @param min its least value, inclusive
     * @param max its greatest value, inclusive
     * @param value its value where nothing has been given
     */
    record Control(String key, String owner, String unit, double min, double max, double value) {

        /** Checks that the range holds the value. */
        public Control {
            if (!(min <= value && value <= max)) {
                throw new IllegalArgumentException(
                        "control " + key + " = " + value + "; needs a number from " + min + " to " + max);
            }
        }
    }
}
