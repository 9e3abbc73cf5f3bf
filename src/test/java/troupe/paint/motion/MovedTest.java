package troupe.paint.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.geometry.Pose;
import troupe.paint.Sketch;
import troupe.paint.Theme;
import troupe.paint.Viewport;
import troupe.paint.picture.Animation;
import troupe.paint.picture.Legend;
import troupe.paint.picture.Picture;
import troupe.paint.scene.ObstacleLook;
import troupe.run.Run;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/** Paints what a run moves: the crate of the sketch leaves at 7 s and arrives at 9 s. */
class MovedTest {
    private static final Run RUN = Sketch.haul();
    private static final int BEFORE = 0;
    private static final int UNDER_WAY = 200;
    private static final int AFTER = 250;

    private final Moved moved = new Moved(RUN);

    private static Point crate(Scene scene) {
        return scene.obstacle("crate").orElseThrow().outline().centroid();
    }

    @Test
    void sceneShowsTheCrateOnceAtItsPoseOfTheFrame() {
        assertSame(RUN.scene(), moved.scene(RUN.scene(), BEFORE), "nothing has been moved yet");
        Scene now = moved.scene(RUN.scene(), UNDER_WAY);
        assertEquals(RUN.scene().obstacles().size(), now.obstacles().size());
        assertEquals(9.2, crate(now).x(), 1e-9);
        assertEquals(7.85, crate(now).y(), 1e-9);
        Polygon outline = now.obstacle("crate").orElseThrow().outline();
        double turn = StrictMath.atan2(outline.y(1) - outline.y(0), outline.x(1) - outline.x(0));
        assertEquals(0.6, turn, 1e-9, "half of 1.2 rad");
        assertEquals(10.25, crate(moved.scene(RUN.scene(), AFTER)).x(), 1e-9);
    }

    @Test
    void traceStaysWhereItStoodAndOutlineWaitsWhereItIsGoingTo() {
        assertEquals(List.of(ObstacleLook.Trace.AHEAD), traces(BEFORE));
        assertEquals(List.of(ObstacleLook.Trace.AHEAD, ObstacleLook.Trace.LEFT), traces(UNDER_WAY));
        assertEquals(List.of(ObstacleLook.Trace.LEFT), traces(AFTER));
        Obstacle left = moved.traces(RUN.scene(), AFTER).get(0).obstacle();
        assertEquals(RUN.scene().obstacle("crate").orElseThrow(), left);
    }

    private List<ObstacleLook.Trace> traces(int frame) {
        return moved.traces(RUN.scene(), frame).stream()
                .map(ObstacleLook::trace)
                .toList();
    }

    @Test
    void obstacleThatWasEditedMeanwhileStaysWhereItIs() {
        Obstacle crate = RUN.scene().obstacle("crate").orElseThrow();
        Scene edited = RUN.scene().with(crate.withOutline(crate.outline().shifted(0.3, 0)));
        assertSame(edited, moved.scene(edited, AFTER));
        assertEquals(List.of(), moved.traces(edited, AFTER));
        Scene named =
                RUN.scene().with(new Obstacle("crate", "Box", crate.outline(), 0, 1, true, crate.mass(), "#336699"));
        assertEquals(
                "#336699",
                moved.scene(named, AFTER).obstacle("crate").orElseThrow().colour());
        assertEquals(10.25, crate(moved.scene(named, AFTER)).x(), 1e-9);
    }

    @Test
    void wayIsThatOfTheCentroidFromFirstToLast() {
        assertEquals(1, moved.ways().size());
        double[] way = moved.ways().get(0);
        assertArrayEquals(new double[] {8.15, 7.5}, Arrays.copyOf(way, 2), 1e-9);
        assertArrayEquals(new double[] {10.25, 8.2}, Arrays.copyOfRange(way, way.length - 2, way.length), 1e-9);
        assertEquals(2 * 51, way.length, "a place for each frame in which it is elsewhere");
        assertTrue(Moved.any(RUN));
        assertFalse(Moved.any(Sketch.run()), "a run without the channels of what it moves");
        assertEquals(List.of(), new Moved(Sketch.run()).ways());
    }

    @Test
    void posesAreEqualAsLongAsNothingIsMoved() {
        RunPainter painter = new RunPainter(RUN, Theme.LIGHT);
        assertEquals(List.of(new Pose(8.15, 7.5, 0)), painter.poses(0));
        assertEquals(painter.poses(0), painter.poses(6.9));
        assertNotEquals(painter.poses(0), painter.poses(7.5));
        assertEquals(painter.poses(9.2), painter.poses(99));
    }

    @Test
    void holdIsTheNearestPointOfTheOutline() {
        Polygon box = Polygon.rectangle(2, 1, 4, 3);
        assertEquals(new Point(2, 2), Hands.hold(box, 1, 2));
        assertEquals(new Point(4, 3), Hands.hold(box, 5, 5));
        assertEquals(new Point(3.5, 1), Hands.hold(box, 3.5, 0.5));
    }

    @Test
    void handsAreSeenWhileTheCrateIsHeldAndAtNoOtherTime() {
        Journey journey = (Journey) RUN.scene().task(RUN.task()).orElseThrow();
        Scene scene = RUN.scene().with(journey.with(Journey.Manipulation.FREE));
        Run free = new Run(scene, RUN.task(), RUN.outcome(), RUN.report(), RUN.frames(), RUN.legs(), List.of());
        assertFalse(Arrays.equals(actors(RUN, 8), actors(free, 8)), "no hands");
        assertArrayEquals(actors(RUN, 6.5), actors(free, 6.5));
        assertArrayEquals(actors(RUN, 9.4), actors(free, 9.4));
    }

    private static int[] actors(Run run, double time) {
        BufferedImage image = new BufferedImage(300, 300, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        new RunPainter(run, Theme.LIGHT).paintActors(g, new Viewport(5, 11, 50), time);
        g.dispose();
        return image.getRGB(0, 0, 300, 300, null, 0, 300);
    }

    @Test
    void animationShowsTheCrateWhereItIsInWhateverOrderTheTimesCome() {
        Picture picture = Picture.of(RUN, 0);
        Animation animation = new Animation(picture, 600, 1);
        int[] under = pixels(animation.image(8));
        int[] before = pixels(animation.image(0));
        int[] after = pixels(animation.image(10));
        assertArrayEquals(under, pixels(animation.image(8)));
        assertArrayEquals(before, pixels(new Animation(picture, 600, 1).image(0)));
        assertArrayEquals(after, pixels(new Animation(picture, 600, 1).image(10)));
        assertTrue(wood(picture, before, 8.45, 7.15), "the crate at its first place");
        assertFalse(wood(picture, after, 8.45, 7.15), "the crate is painted at its first place after it has left");
        assertTrue(wood(picture, after, 10.25, 8.45), "the crate at its last place");
        assertFalse(wood(picture, before, 10.25, 8.45));
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    /** Tells whether most of the pixels around a place in metres are of solid wood. */
    private static boolean wood(Picture picture, int[] pixels, double x, double y) {
        var box = picture.sceneBox(600);
        double scale = box.getWidth() / 18;
        int column = (int) (box.getX() + x * scale);
        int row = (int) (box.getMaxY() - y * scale);
        int wood = 0;
        for (int k = 0; k < 25; k++) {
            Color c = new Color(pixels[(row + k / 5 - 2) * 600 + column + k % 5 - 2]);
            wood += c.getRed() < 190 && c.getRed() - c.getBlue() > 70 ? 1 : 0;
        }
        return wood > 15;
    }

    @Test
    void legendTellsWhatTheTraceIs() {
        List<String> texts =
                Legend.of(RUN, List.of(), true, Theme.LIGHT, Legend.ENGLISH).texts();
        assertEquals("where it stood", texts.get(texts.size() - 1));
        assertFalse(Legend.of(Sketch.run(), List.of(), true, Theme.LIGHT, Legend.ENGLISH)
                .texts()
                .contains("where it stood"));
    }
}
