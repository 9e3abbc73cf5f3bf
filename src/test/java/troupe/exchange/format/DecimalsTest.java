package troupe.exchange.format;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class DecimalsTest {
    private static final long SEED = Long.getLong("seed", 5);

    private static String six(double value) {
        return Decimals.six(new StringBuilder(), value).toString();
    }

    @Test
    void sixDecimalsAreWritten() {
        assertEquals("2.156900", six(2.1569));
        assertEquals("-0.000001", six(-0.0000014));
        assertEquals("0.000000", six(-0.0000004));
        assertEquals("0.000000", six(-0.0));
        assertEquals("-12.050000", six(-12.05));
        assertEquals("10000000000.000000", six(1e10));
        assertEquals("3999999999.500000", six(3999999999.5));
    }

    @Test
    void zerosAtTheEndAreLeftOut() {
        assertEquals("2", Decimals.trimmed(2));
        assertEquals("0", Decimals.trimmed(-1e-9));
        assertEquals("100", Decimals.trimmed(100));
        assertEquals("-0.25", Decimals.trimmed(-0.25));
    }

    @Test
    void everyNumberIsWithinHalfAMillionth() {
        SplittableRandom random = new SplittableRandom(SEED);
        for (int k = 0; k < 20_000; k++) {
            double value = (random.nextDouble() - 0.5) * StrictMath.pow(10, random.nextInt(-7, 9));
            BigDecimal error =
                    new BigDecimal(six(value)).subtract(new BigDecimal(value)).abs();
            BigDecimal most = new BigDecimal("0.000000501").add(new BigDecimal(Math.ulp(value)));
            assertEquals(true, error.compareTo(most) <= 0, "seed " + SEED + ": " + value + " as " + six(value));
            assertEquals(
                    6,
                    new BigDecimal(six(value))
                            .setScale(6, RoundingMode.UNNECESSARY)
                            .scale());
        }
    }
}
