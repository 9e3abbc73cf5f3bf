package troupe.paint.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.paint.Theme;
import troupe.run.view.Strip;

class StripPainterTest {
    private static final int WIDTH = 14 + 84 + 400 + 14;

    private static Strip strip(double likely) {
        return new Strip(
                "probability",
                0.1,
                List.of("somebody with a name that is too long by far", "b"),
                List.of(new double[] {0, likely, 0, Double.NaN}, new double[] {0, 0, 0, 0}));
    }

    /** Returns how bright a strip is in the middle of a value, from 0 to 255. */
    private static int grey(BufferedImage image, int row, int value) {
        return new Color(image.getRGB(14 + 84 + 50 + 100 * value, 14 + 11 + 22 * row)).getGreen();
    }

    @Test
    void theLikelierTheDarkerOnLightGroundAndTheBrighterOnDark() {
        BufferedImage light = new StripPainter(strip(0.2), Theme.LIGHT).image(WIDTH);
        BufferedImage dark = new StripPainter(strip(0.2), Theme.DARK).image(WIDTH);
        assertEquals(WIDTH, light.getWidth());
        assertTrue(grey(light, 0, 1) < grey(light, 0, 0) - 100);
        assertTrue(grey(dark, 0, 1) > grey(dark, 0, 0) + 100);
        assertEquals(grey(light, 1, 1), grey(light, 0, 0));
    }

    @Test
    void theGreysEndAtTheFirstRoundShareThatNothingIsAbove() {
        // of 5, 10, 25, 50 and 100 percent: 4 of 5 is as dark as 8 of 10, and darker than 8 of 25
        int four = grey(new StripPainter(strip(0.04), Theme.LIGHT).image(WIDTH), 0, 1);
        int eight = grey(new StripPainter(strip(0.08), Theme.LIGHT).image(WIDTH), 0, 1);
        int eleven = grey(new StripPainter(strip(0.11), Theme.LIGHT).image(WIDTH), 0, 1);
        assertEquals(four, eight);
        assertTrue(eleven > eight + 50);
    }

    @Test
    void nothingIsPaintedOutsideAndNamesDoNotRunIntoTheStrips() {
        BufferedImage image = new StripPainter(strip(0.2), Theme.LIGHT).image(WIDTH);
        int ground = image.getRGB(0, 0);
        for (int y = 14; y < 14 + 22; y++) {
            assertEquals(ground, image.getRGB(14 + 84 - 3, y), "beside the strip, at " + y);
        }
        for (int x = 0; x < WIDTH; x++) {
            assertEquals(ground, image.getRGB(x, 2));
            assertEquals(ground, image.getRGB(x, image.getHeight() - 3));
        }
    }
}
