package troupe.run.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

class AspectTest {
    private static final Aspect SPACE =
            new Aspect("space", List.of(Aspect.Choice.of("scene"), Aspect.Choice.of("moved", "Crate", "Bench")));

    @Test
    void namesAChoiceInOneLine() {
        assertEquals("scene", SPACE.choices().get(0).text());
        assertEquals("moved Crate, Bench", SPACE.choices().get(1).text());
    }

    @Test
    void takesTheFirstWhereNothingThatExistsIsChosen() {
        assertEquals(1, SPACE.chosen(List.of(5, 1), 1));
        assertEquals(0, SPACE.chosen(List.of(1), 1));
        assertEquals(0, SPACE.chosen(List.of(2), 0));
        assertEquals(0, SPACE.chosen(List.of(-1), 0));
    }

    @Test
    void refusesToOfferNothing() {
        assertThrows(IllegalArgumentException.class, () -> new Aspect("space", List.of()));
    }

    @Test
    void oneLooksAheadAsFarAsThePredictionGoes() {
        Aspect ahead = Ahead.aspect(1, List.of("risk"));
        assertEquals(
                List.of("seconds 0.4", "seconds 0.8"),
                ahead.choices().stream().map(Aspect.Choice::text).toList());
        assertEquals(0.8, Ahead.seconds(1, 1));
        assertEquals(0.4, Ahead.seconds(1, 2));
        assertEquals(3.2, Ahead.seconds(4, 3));
        assertEquals(0.4, Ahead.seconds(4, 4));
        assertEquals(0.4, Ahead.seconds(4, -1));
        assertEquals(
                List.of(Aspect.Choice.of("now")), Ahead.aspect(0.3, List.of()).choices());
        assertEquals(0, Ahead.seconds(0.3, 0));
    }
}
