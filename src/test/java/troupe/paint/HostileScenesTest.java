package troupe.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.paint.picture.Picture;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

/** Paints scenes full of mistakes: the studio shows a scene while it is being mended. */
class HostileScenesTest {
    private static final double[] ODD = {
        0,
        -0.0,
        1,
        -1,
        3.7,
        1e-9,
        1e6,
        -1e6,
        1e15,
        Double.MIN_VALUE,
        1e300,
        -1e300,
        Double.MAX_VALUE,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY
    };

    private final long seed = Long.getLong("troupe.seed", 77);
    private final Random random = new Random(seed);

    private double number() {
        return random.nextInt(4) == 0 ? ODD[random.nextInt(ODD.length)] : random.nextDouble() * 10;
    }

    private Polygon polygon() {
        double[] at = new double[2 * (1 + random.nextInt(7))];
        for (int i = 0; i < at.length; i++) {
            at[i] = number();
        }
        return Polygon.of(at);
    }

    private double height() {
        return random.nextInt(10) == 0 ? Double.NaN : number();
    }

    private Scene scene() {
        List<Obstacle> obstacles = new ArrayList<>();
        List<Ditch> ditches = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            String colour = random.nextBoolean() ? "" : random.nextBoolean() ? "#12ab34" : "red\u0000";
            obstacles.add(new Obstacle(
                    "o" + i, "Nøme " + i, polygon(), height(), height(), random.nextBoolean(), number(), colour));
        }
        ditches.add(new Ditch("d", "", polygon(), height()));
        World world = random.nextInt(3) > 0 ? new World(10, 8, 0.05) : new World(height(), height(), height());
        Journey journey = Journey.of("j", "nobody", Place.of(height(), height()), Place.of(number(), number()));
        return new Scene("", world, obstacles, ditches, List.of(Actor.standard("ann")), List.of(journey));
    }

    @Test
    void anySceneGivesAPictureOfTheSizeAskedFor() {
        for (int round = 0; round < 300; round++) {
            Scene scene = scene();
            Theme theme = random.nextBoolean() ? Theme.LIGHT : Theme.DARK;
            try {
                BufferedImage image = Picture.of(scene).with(theme).image(160);
                assertEquals(160, image.getWidth());
            } catch (RuntimeException e) {
                throw new AssertionError("round " + round + " of seed " + seed + ": " + scene, e);
            }
        }
    }

    @Test
    void aPictureTooLargeForMemoryIsRefusedBeforehand() {
        Picture tall = Picture.of(new Scene("", new World(1, 1000, 1), List.of(), List.of(), List.of(), List.of()));
        assertEquals(160, tall.image(160).getWidth());
        assertThrows(IllegalArgumentException.class, () -> tall.image(Picture.MAX_WIDTH, 4));
    }
}
