package troupe.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class InputsTest {
    private static final List<Simulation.Control> CONTROLS = List.of(
            new Simulation.Control("weight.cohesion", "all", "", 0, 20, 1),
            new Simulation.Control("avatar.guy.x", "guy", "m", 0, 12, 6));

    private final Inputs inputs = new Inputs();

    private void give(long step, String key, double value, long done) {
        inputs.give(new Run.Input(step, key, value), CONTROLS, done);
    }

    private List<Double> take(long step) {
        List<Double> taken = new ArrayList<>();
        inputs.take(step, input -> taken.add(input.value()));
        return taken;
    }

    @Test
    void handsOutEachInputOnceWhenItsStepHasCome() {
        give(3, "weight.cohesion", 2, 0);
        give(3, "weight.cohesion", 4, 1);
        give(5, "avatar.guy.x", 0, 2);
        assertEquals(List.of(), take(2));
        assertEquals(List.of(2.0, 4.0), take(4));
        assertEquals(List.of(0.0), take(9));
        assertEquals(List.of(), take(9));
        assertEquals(3, inputs.all().size());
    }

    @Test
    void refusesWhatCannotHoldAndKeepsWhatItHad() {
        give(4, "weight.cohesion", 20, 0);
        assertTrue(refusal(4, "weight.cohesoin", 1, 0).contains("there are weight.cohesion, avatar.guy.x"));
        assertTrue(refusal(4, "weight.cohesion", 20.5, 0).contains("from 0.0 to 20.0"));
        assertTrue(refusal(4, "weight.cohesion", Double.NaN, 0).contains("from 0.0 to 20.0"));
        assertTrue(refusal(3, "weight.cohesion", 1, 0).contains("needs a step from 4"));
        assertTrue(refusal(6, "weight.cohesion", 1, 7).contains("needs a step from 7"));
        assertEquals(1, inputs.all().size());
    }

    private String refusal(long step, String key, double value, long done) {
        return assertThrows(IllegalArgumentException.class, () -> give(step, key, value, done))
                .getMessage();
    }
}
