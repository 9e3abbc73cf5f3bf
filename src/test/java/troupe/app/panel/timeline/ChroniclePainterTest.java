package troupe.app.panel.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.play.Chronicle;
import troupe.paint.Theme;

class ChroniclePainterTest {
    private static final int LEFT = 60;

    /** Counts the pixels painted left of the plot, or from there on, for a run that is so many pixels wide. */
    private static long painted(int wide, boolean before) {
        BufferedImage image = new BufferedImage(500, 120, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = image.createGraphics();
        Look look = new Look(Theme.LIGHT, new Texts(Locale.ENGLISH));
        g.setFont(look.font());
        ChroniclePainter painter =
                new ChroniclePainter(look, time -> LEFT + wide * time, new ChroniclePainter.Rows(10, 20, 40, 120));
        painter.paintCurve(g, new Chronicle.Curve("risk", new double[] {0, 0.25}), 1);
        g.dispose();
        return IntStream.range(0, 120)
                .mapToLong(y -> IntStream.range(before ? 0 : LEFT - 2, before ? LEFT - 2 : 500)
                        .filter(x -> image.getRGB(x, y) != 0)
                        .count())
                .sum();
    }

    /** Where a run had only begun, the greatest value of its curve once stood half outside, left of the plot. */
    @Test
    void nothingIsPaintedLeftOfThePlotHoweverShortTheRunIs() {
        for (int wide : new int[] {0, 5, 30, 100, 400}) {
            assertEquals(0, painted(wide, true), wide + " pixels wide");
            assertTrue(painted(wide, false) > 50, wide + " pixels wide");
        }
    }
}
