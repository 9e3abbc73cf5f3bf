package troupe.paint.solid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.geometry.Box;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;

/** Compares what a stage shows with rays that are walked through the prisms in small steps. */
class StageOracleTest {
    private static final int SIZE = 96;
    /** Colours that stay apart however much they are shaded: by which of their parts are nought. */
    private static final int[] COLOURS = {0xff0000, 0x00ff00, 0x0000ff, 0xffff00, 0x00ffff, 0xff00ff};

    private record Prism(Polygon outline, double low, double high, int colour) {
        boolean holds(double x, double y, double z) {
            return z > low && z < high && outline.contains(x, y);
        }
    }

    private static Prism prism(Random random, int colour) {
        double[] corners = random.nextBoolean()
                ? new double[] {0, 0, 3, 0, 3, 1, 1, 1, 1, 3, 0, 3} // concave
                : new double[] {0, 0, 0, 2, 2, 3, 3, 1}; // clockwise
        Polygon turned = Polygon.of(corners)
                .at(new Pose(2 + 6 * random.nextDouble(), 2 + 6 * random.nextDouble(), 7 * random.nextDouble()));
        double low = random.nextInt(3) == 0 ? 0 : 3 * random.nextDouble();
        return new Prism(turned, low, low + 0.2 + 3 * random.nextDouble(), colour);
    }

    private static int parts(int rgb) {
        return ((rgb & 0xff0000) != 0 ? 4 : 0) | ((rgb & 0xff00) != 0 ? 2 : 0) | ((rgb & 0xff) != 0 ? 1 : 0);
    }

    /** Walks from the eye to the ground; returns the parts of the first prism met, 0 for none. */
    private static int first(List<Prism> prisms, Camera camera, double px, double py) {
        double azimuth = camera.angle().azimuthRad();
        double elevation = camera.angle().elevationRad();
        double u = camera.left() + px / camera.scale();
        double w = camera.top() - py / camera.scale();
        for (double z = 7; z > 0; z -= 0.01) {
            double v = (w - z * Math.cos(elevation)) / Math.sin(elevation);
            double x = u * Math.cos(azimuth) - v * Math.sin(azimuth);
            double y = u * Math.sin(azimuth) + v * Math.cos(azimuth);
            for (Prism prism : prisms) {
                if (prism.holds(x, y, z)) {
                    return parts(prism.colour());
                }
            }
        }
        return 0;
    }

    @Test
    void showsWhateverIsNearestHoweverThingsLieOverAndWithinEachOther() {
        long seed = Long.getLong("troupe.seed", 20_261);
        Random random = new Random(seed);
        Stage stage = new Stage();
        int seen = 0;
        for (int round = 0; round < 25; round++) {
            List<Prism> prisms = new ArrayList<>();
            for (int colour : COLOURS) {
                prisms.add(prism(random, colour));
            }
            Camera.Angle angle =
                    new Camera.Angle(7 * random.nextDouble(), Math.toRadians(15 + 65 * random.nextDouble()));
            Camera camera = Camera.fit(angle, new Box(0, 0, 10, 10), 0, 6, SIZE, SIZE);
            stage.set(camera, SIZE, SIZE, 1, round % 2 == 0, Color.BLACK);
            prisms.forEach(
                    p -> stage.prism(p.outline(), p.low(), p.high(), new Color(p.colour()), new Color(p.colour())));
            BufferedImage image = stage.image();
            int wrong = 0;
            int compared = 0;
            for (int y = 2; y < SIZE - 2; y += 3) {
                for (int x = 2; x < SIZE - 2; x += 3) {
                    int parts = parts(image.getRGB(x, y) & 0xffffff);
                    boolean even = parts == parts(image.getRGB(x - 1, y) & 0xffffff)
                            && parts == parts(image.getRGB(x + 1, y) & 0xffffff)
                            && parts == parts(image.getRGB(x, y - 1) & 0xffffff)
                            && parts == parts(image.getRGB(x, y + 1) & 0xffffff);
                    if (even) { // away from edges, where a ray of another slope may meet another thing
                        compared++;
                        wrong += first(prisms, camera, x + 0.5, y + 0.5) == parts ? 0 : 1;
                        seen += parts == 0 ? 0 : 1;
                    }
                }
            }
            assertTrue(compared > 500, "seed " + seed + ", round " + round + ": compared " + compared);
            assertTrue(wrong <= 2, "seed " + seed + ", round " + round + ": " + wrong + " of " + compared + " wrong");
        }
        assertTrue(seen > 3_000, "saw things at " + seen + " pixels");
    }

    private static final Camera FROM_SOUTH =
            Camera.fit(new Camera.Angle(0, Math.toRadians(45)), new Box(0, 0, 10, 10), 0, 2, SIZE, SIZE);

    private static int at(BufferedImage image, double x, double y, double z) {
        return image.getRGB((int) FROM_SOUTH.px(x, y), (int) FROM_SOUTH.py(x, y, z)) & 0xffffff;
    }

    @Test
    void aPitIsSeenThroughItsHoleOnly() {
        Stage stage = new Stage();
        stage.set(FROM_SOUTH, SIZE, SIZE, 1, false, Color.BLACK);
        Polygon hole = Polygon.rectangle(2, 4, 8, 8);
        stage.floor(hole, -3, Color.RED, List.of());
        stage.keepWithin(List.of(hole), 0);
        stage.floor(Polygon.rectangle(0, 0, 10, 10), 0, Color.GREEN, List.of(hole));
        BufferedImage image = stage.image();
        // seen half-way up from the south, the floor of the pit lies 3 m further south than where it shows
        assertEquals(0xff0000, at(image, 5, 7.5, -3));
        assertEquals(0x00ff00, at(image, 5, 2, 0));
        assertEquals(0x00ff00, at(image, 5, 6, -3)); // the near edge of the pit hides that part of its floor
    }

    @Test
    void aFigureShowsFaintlyThroughWhatHidesItAndGlassTintsWhatLiesBehind() {
        Stage stage = new Stage();
        stage.set(FROM_SOUTH, SIZE, SIZE, 1, false, Color.BLACK);
        stage.prism(Polygon.rectangle(0, 4, 10, 5), 0, 3, Color.GREEN, Color.GREEN);
        stage.figure(0.5);
        stage.ball(5, 6, 0.5, 0.4, 1, Color.RED);
        stage.ball(2, 2, 0.5, 0.4, 1, Color.RED);
        stage.ball(2, 2, 0.5, 0.4, 1, Color.RED);
        int hidden = at(stage.image(), 5, 6, 0.5);
        assertEquals(127, hidden >> 16, 1);
        assertNotEquals(0, hidden & 0xff00);
        assertEquals(0xff0000, at(stage.image(), 2, 2, 0.5));
        stage.glass(0.25);
        stage.prism(Polygon.rectangle(0, 0, 10, 1), 0, 4, Color.BLUE, Color.BLUE);
        int tinted = at(stage.image(), 2, 2, 0.5);
        assertEquals(191, tinted >> 16, 1);
        assertTrue((tinted & 0xff) > 30 && (tinted & 0xff) < 70, Integer.toHexString(tinted));
    }

    @Test
    void aCameraTurnsZoomsAndPansAsTold() {
        Camera camera = FROM_SOUTH.zoomed(2, 10, 20).panned(5, -3);
        assertEquals(5 + 10 + 2 * (FROM_SOUTH.px(3, 4) - 10), camera.px(3, 4), 1e-9);
        assertEquals(-3 + 20 + 2 * (FROM_SOUTH.py(3, 4, 1) - 20), camera.py(3, 4, 1), 1e-9);
        Camera.Angle low = Camera.Angle.DEFAULT.turned(0, -5);
        assertEquals(Camera.Angle.MIN_ELEVATION, low.elevationRad());
        assertEquals(Camera.Angle.MAX_ELEVATION, low.turned(1, 9).elevationRad());
    }
}
