package troupe.run;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;

/** Keeps what was given to a simulation from outside, in the order of its steps. Not safe for use by several threads. */
public final class Inputs {
    private final List<Run.Input> given = new ArrayList<>();
    private int taken;

    /** Makes an empty list. */
    public Inputs() {}

    /**
     * Keeps one more input.
     *
     * @param controls what can be set
     * @param steps the steps done
     * @throws IllegalArgumentException as {@link Simulation#give} says; nothing is then changed
     */
    public void give(Run.Input input, List<Simulation.Control> controls, long steps) {
        Simulation.Control control = controls.stream()
                .filter(c -> c.key().equals(input.key()))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("there is no control '" + input.key() + "'; there are "
                        + String.join(
                                ", ",
                                controls.stream().map(Simulation.Control::key).toList())));
        if (!(input.value() >= control.min() && input.value() <= control.max())) {
            throw new IllegalArgumentException(input.key() + "=" + input.value() + "; needs a number from "
                    + control.min() + " to " + control.max());
        }
        long earliest = given.isEmpty()
                ? steps
                : Math.max(steps, given.get(given.size() - 1).step());
        if (input.step() < earliest) {
            throw new IllegalArgumentException(
                    input.key() + " of step " + input.step() + "; needs a step from " + earliest);
        }
        given.add(input);
    }

    /** Hands out what holds from a step or an earlier one, each input once and in their order. */
    public void take(long step, Consumer<Run.Input> receiver) {
        while (taken < given.size() && given.get(taken).step() <= step) {
            receiver.accept(given.get(taken++));
        }
    }

    /** Returns all that was given, a view. */
    public List<Run.Input> all() {
        return Collections.unmodifiableList(given);
    }
}
