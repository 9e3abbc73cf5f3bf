package troupe.paint.picture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import troupe.paint.Sketch;
import troupe.paint.StoredPictures;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.paint.field.OverlayPainter;
import troupe.paint.motion.RunPainter;
import troupe.paint.scene.ScenePainter;
import troupe.paint.solid.Camera;
import troupe.paint.solid.SolidPainter;
import troupe.run.Run;
import troupe.run.view.Overlay;

/**
 * Compares pictures of what painters draw, each made by hand, with stored ones.
 */
class PictureTest {
    private static final int WIDTH = 240;

    /** A named picture without text. */
    private record Case(String name, Theme theme) {
        BufferedImage image() {
            int height = 174;
            if (name.startsWith("solid")) {
                return solid(height);
            }
            BufferedImage image = new BufferedImage(WIDTH, height, BufferedImage.TYPE_INT_RGB);
            Graphics2D g = image.createGraphics();
            g.setColor(theme.color(Tone.CANVAS));
            g.fillRect(0, 0, WIDTH, height);
            Viewport view = name.startsWith("move") ? new Viewport(5.8, 10, 38) : new Viewport(-0.1, 13.1, 13.2);
            RunPainter run = new RunPainter(name.startsWith("move") ? Sketch.haul() : Sketch.run(), theme);
            double time = name.equals("move") ? 8 : name.equals("moved") ? 10 : 3.6;
            ScenePainter scene = run.scene(Sketch.scene(), time);
            scene.paintGround(g, view);
            scene.paintObstacles(g, view);
            switch (name) {
                case "potential" -> new OverlayPainter(Sketch.potential(), theme).paint(g, view);
                case "contours" -> new OverlayPainter(Sketch.potential(), theme, false).paint(g, view);
                case "class" -> new OverlayPainter(Sketch.classes(), theme).paint(g, view);
                case "skeleton" -> new OverlayPainter(Sketch.skeleton(), theme).paint(g, view);
                case "trigger-points" -> new OverlayPainter(Sketch.triggers(), theme).paint(g, view);
                case "move-views" -> Sketch.moving().forEach(o -> new OverlayPainter(o, theme).paint(g, view));
                case "run", "move", "moved" -> {
                    run.paintLegs(g, view);
                    run.paintEnds(g, view);
                    run.paintActors(g, view, time);
                }
                default -> assertEquals("scene", name);
            }
            g.dispose();
            return image;
        }

        private BufferedImage solid(int height) {
            Run run = name.equals("solid-moved") ? Sketch.haul() : Sketch.run();
            Camera.Angle angle = name.equals("solid-north")
                    ? new Camera.Angle(Math.toRadians(200), Math.toRadians(25))
                    : Camera.Angle.DEFAULT;
            Camera camera = SolidPainter.fit(Sketch.scene(), angle, 4, 4, WIDTH - 8.0, height - 8.0);
            return new SolidPainter(Sketch.scene(), Optional.of(run), theme)
                    .marking(Set.of("crate"))
                    .image(camera, WIDTH, height, 1, name.equals("solid-moved") ? 8 : 3.6, theme.color(Tone.CANVAS));
        }

        @Override
        public String toString() {
            return name + "-" + theme.key();
        }
    }

    static Stream<Case> cases() {
        return Stream.of(
                        "scene",
                        "run",
                        "potential",
                        "contours",
                        "class",
                        "skeleton",
                        "trigger-points",
                        "move",
                        "moved",
                        "move-views",
                        "solid",
                        "solid-moved",
                        "solid-north")
                .flatMap(name -> Stream.of(Theme.values()).map(theme -> new Case(name, theme)));
    }

    @ParameterizedTest
    @MethodSource("cases")
    void looksLikeTheStoredPicture(Case picture) throws IOException {
        StoredPictures.assertLooksLike(picture.toString(), picture.image());
    }

    @Test
    void differentPicturesDoNotPass() {
        List<BufferedImage> images = new ArrayList<>();
        cases().forEach(c -> images.add(c.image()));
        for (int i = 0; i < images.size(); i++) {
            for (int j = 0; j < i; j++) {
                double difference = StoredPictures.difference(images.get(i), images.get(j));
                assertTrue(difference > 1, "pictures " + j + " and " + i + " differ by " + difference + " only");
            }
        }
    }

    @Test
    void samePictureTwiceIsEqualPixelByPixel() {
        Picture picture = Picture.of(Sketch.run(), 3.6).with(List.of(Sketch.classes(), Sketch.skeleton()));
        assertArrayEquals(pixels(picture.image(500)), pixels(picture.image(500)));
    }

    @Test
    void animationShowsTheSameActorsAsThePicture() {
        Picture picture = Picture.of(Sketch.run(), 0).with(Theme.DARK);
        Animation animation = new Animation(picture, 400, 1);
        BufferedImage moving = animation.image(8);
        BufferedImage still = animation.image(0);
        assertFalse(java.util.Arrays.equals(pixels(moving), pixels(still)), "nothing moved");
        assertArrayEquals(pixels(animation.image(8)), pixels(moving));
        assertEquals(picture.size(400).height, moving.getHeight());
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    @Test
    void legendAndScaleNeverCoverTheScene() {
        List<Overlay> overlays = List.of(Sketch.potential(), Sketch.classes(), Sketch.skeleton(), Sketch.triggers());
        Picture picture = Picture.of(Sketch.run(), 1).with(overlays);
        for (int width = Picture.MIN_WIDTH; width < 1500; width += 41) {
            assertTrue(
                    picture.sceneBox(width).getMaxY()
                            <= picture.footerBox(width).getMinY(),
                    "at width " + width);
            assertTrue(picture.sceneBox(width).getMinX() >= 0);
            assertTrue(picture.footerBox(width).getMaxY() <= picture.size(width).height);
        }
    }

    @Test
    void refusesSizesThatMakeNoPicture() {
        Picture picture = Picture.of(Sketch.scene());
        assertThrows(IllegalArgumentException.class, () -> picture.image(0));
        assertThrows(IllegalArgumentException.class, () -> picture.image(Picture.MAX_WIDTH + 1));
        assertThrows(IllegalArgumentException.class, () -> picture.image(300, Double.NaN));
        assertEquals(600, picture.image(300, 2).getWidth());
    }
}
