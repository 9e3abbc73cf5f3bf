package troupe.run.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

class StripTest {
    private static final Strip STRIP = new Strip(
            "probability",
            0.1,
            List.of("a", "b", "c"),
            List.of(new double[] {0, 0.3}, new double[] {Double.NaN, 0.1}, new double[] {0.2, 0.5, Double.NaN}));

    @Test
    void keepsTheGreatestRowsInTheirOrder() {
        assertEquals(List.of("a", "c"), STRIP.greatest(2).names());
        assertEquals(List.of("c"), STRIP.greatest(1).names());
        assertEquals(STRIP.rows(), STRIP.greatest(9).rows());
        assertEquals(0.1, STRIP.most(1));
        assertEquals(0, new Strip("p", 1, List.of("x"), List.of(new double[] {Double.NaN})).most(0));
    }

    @Test
    void needsANameForEachRow() {
        assertThrows(IllegalArgumentException.class, () -> new Strip("p", 1, List.of(), STRIP.rows()));
    }
}
