package troupe.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.paint.field.CategoryLook;
import troupe.paint.field.ColourMap;
import troupe.paint.field.OverlayPainter;
import troupe.paint.motion.Track;
import troupe.paint.picture.Legend;
import troupe.paint.scene.Cover;
import troupe.paint.scene.ObstacleLook;
import troupe.run.view.Overlay;
import troupe.scene.Ability;
import troupe.scene.Obstacle;

/** Asks the parts of the painters one by one. */
class PaintersTest {

    @Test
    void looksTellWhatHangsWhatIsAStairAndWhatIsLow() {
        List<ObstacleLook> looks = ObstacleLook.of(Sketch.scene().obstacles());
        Set<String> hanging = ids(looks.stream().filter(ObstacleLook::hanging).toList());
        assertEquals(Set.of("gallery", "table"), hanging);
        Set<String> stair = ids(looks.stream().filter(ObstacleLook::stair).toList());
        assertEquals(12, stair.size());
        assertTrue(stair.stream().allMatch(id -> id.startsWith("stair-")));
        assertTrue(ids(looks.stream().filter(ObstacleLook::low).toList()).contains("low-wall"));
        assertFalse(ids(looks.stream().filter(ObstacleLook::low).toList()).contains("north"));
    }

    private static Set<String> ids(List<ObstacleLook> looks) {
        return looks.stream().map(l -> l.obstacle().id()).collect(Collectors.toSet());
    }

    @Test
    void aBoxThatStandsOnATableDoesNotHang() {
        Obstacle table = new Obstacle("table", "", Polygon.rectangle(0, 0, 2, 1), 0.7, 0.1, false, 20, "");
        Obstacle box = new Obstacle("box", "", Polygon.rectangle(0.5, 0.3, 0.9, 0.7), 0.8, 0.3, true, 5, "");
        List<ObstacleLook> looks = ObstacleLook.of(List.of(box, table));
        assertEquals("table", looks.get(0).obstacle().id(), "lower tops are painted first");
        assertTrue(looks.get(0).hanging());
        assertFalse(looks.get(1).hanging());
    }

    @Test
    void hatchStaysInsideAConcaveOutline() {
        Shape shape = new Clipping(graphics(), new Viewport(0, 0, 1))
                .polygon(Polygon.of(0, 0, 100, 0, 100, 100, 60, 100, 60, 40, 40, 40, 40, 100, 0, 100));
        Path2D hatch = Shapes.hatch(shape, 7, 0.4);
        double[] at = new double[6];
        double[] from = new double[2];
        int lines = 0;
        for (PathIterator it = hatch.getPathIterator(null); !it.isDone(); it.next()) {
            if (it.currentSegment(at) == PathIterator.SEG_LINETO) {
                lines++;
                for (double s = 0.01; s < 1; s += 0.07) {
                    assertTrue(shape.contains(from[0] + s * (at[0] - from[0]), from[1] + s * (at[1] - from[1])));
                }
            }
            from[0] = at[0];
            from[1] = at[1];
        }
        assertTrue(lines > 20, lines + " lines");
    }

    private static Graphics2D graphics() {
        return new BufferedImage(10, 10, BufferedImage.TYPE_INT_RGB).createGraphics();
    }

    @Test
    void clippingCutsToTheSurroundingsOfWhatIsSeen() {
        Graphics2D g = graphics();
        g.setClip(0, 0, 100, 100);
        Clipping clipping = new Clipping(g, new Viewport(0, 0, 1));
        Path2D triangle = clipping.polygon(Polygon.of(-1e300, -50, 1e300, -50, 1e300, 1e300));
        assertEquals(new Rectangle2D.Double(-4000, -4000, 8100, 4050), triangle.getBounds2D());
        assertTrue(clipping.polygon(Polygon.of(5000, 0, 6000, 0, 6000, 9))
                .getBounds2D()
                .isEmpty());
        assertEquals(
                new Rectangle2D.Double(-4000, 50, 8100, 0),
                clipping.line(new double[] {-1e9, -50, 1e9, -50}, 2).getBounds2D());
        Path2D twice = clipping.line(new double[] {0, 0, 0, 9e5, 50, 9e5, 50, 0, 60, 0}, 2);
        int begins = 0;
        for (PathIterator it = twice.getPathIterator(null); !it.isDone(); it.next()) {
            begins += it.currentSegment(new double[6]) == PathIterator.SEG_MOVETO ? 1 : 0;
        }
        assertEquals(2, begins, "out at the top, in again");
    }

    @Test
    void coverCutsALineWhereItPassesBelow() {
        Cover cover = new Cover(Sketch.scene());
        List<Cover.Part> below = cover.parts(List.of(new double[] {3, 10, 0}, new double[] {3, 12.6, 0}));
        assertEquals(
                List.of(false, true, false),
                below.stream().map(Cover.Part::covered).toList());
        assertEquals(11.2, below.get(1).coordinates()[1], 0.051);
        List<Cover.Part> above = cover.parts(List.of(new double[] {3, 11.5, 2.6}, new double[] {3, 12.2, 2.6}));
        assertEquals(List.of(false), above.stream().map(Cover.Part::covered).toList());
    }

    @Test
    void colourMapsRunOneWayInLightness() {
        for (Theme theme : Theme.values()) {
            ColourMap map = new ColourMap(theme);
            double before = light(map.argb(0));
            double direction = theme == Theme.LIGHT ? -1 : 1;
            for (int i = 1; i <= 64; i++) {
                double now = light(map.argb(i / 64.0));
                assertTrue(direction * (now - before) > 0, theme + " at " + i);
                before = now;
            }
            assertEquals(map.argb(0), map.argb(-5));
            assertEquals(map.argb(1), map.argb(7));
        }
    }

    private static double light(int rgb) {
        return 0.2126 * linear(rgb >> 16 & 255) + 0.7152 * linear(rgb >> 8 & 255) + 0.0722 * linear(rgb & 255);
    }

    private static double linear(int level) {
        return Math.pow(level / 255.0, 2.2);
    }

    @Test
    void categoriesDifferInPatternToo() {
        List<String> words = List.of("stable", "border", "gap", "jumpable", "forbidden");
        Set<CategoryLook.Pattern> patterns = new HashSet<>();
        for (CategoryLook look : CategoryLook.of(words, Theme.LIGHT)) {
            assertTrue(patterns.add(look.pattern()), look + " has the pattern of another");
        }
        CategoryLook[] layers = CategoryLook.of(List.of("0", "1", "2", "3", "4", "5"), Theme.DARK);
        for (int i = 0; i < layers.length; i++) {
            for (int j = 0; j < i; j++) {
                assertNotEquals(layers[i].pattern(), layers[j].pattern());
                assertNotEquals(layers[i].colour(), layers[j].colour());
            }
        }
    }

    @Test
    void abilitiesHaveTheColoursOfTheDesign() {
        assertEquals(new Color(0x0072b2), Theme.LIGHT.color(Ability.WALK));
        assertEquals(new Color(0xc2410c), Theme.LIGHT.color(Ability.MOVE));
        assertEquals(new Color(0xf0b03f), Theme.DARK.color(Ability.VAULT));
        assertEquals(null, Theme.stroke(Ability.WALK, 4).getDashArray());
        assertNotEquals(null, Theme.stroke(Ability.MOVE, 4).getDashArray());
    }

    @Test
    void legendNamesWhatIsShownAndNothingElse() {
        Overlay.Field classes = Sketch.classes();
        Legend legend = Legend.of(
                Sketch.run(),
                List.of(classes, Sketch.skeleton(), Sketch.potential()),
                false,
                Theme.LIGHT,
                Legend.ENGLISH);
        assertEquals(
                List.of(
                        "walk",
                        "sidestep",
                        "stride",
                        "vault",
                        "move an obstacle",
                        "stable",
                        "border",
                        "gap",
                        "jumpable",
                        "forbidden",
                        "skeleton",
                        "potential, every 1 m"),
                legend.texts());
        Overlay.Field few =
                new Overlay.Field("class", 0, classes.frame(), new float[classes.values().length], classes.scale());
        assertEquals(
                List.of("stable"),
                Legend.of(null, List.of(few), true, Theme.LIGHT, Legend.ENGLISH).texts());
        assertEquals(
                List.of("potential, 0 to 12 m", "every 1 m"),
                Legend.of(null, List.of(Sketch.potential()), true, Theme.LIGHT, Legend.ENGLISH)
                        .texts());
    }

    @Test
    void densePointsAreSmaller() {
        assertEquals(3.2, OverlayPainter.radius(Double.POSITIVE_INFINITY), "one point alone");
        assertEquals(2.48, OverlayPainter.radius(4), 1e-9);
        assertEquals(1.4, OverlayPainter.radius(0.1));
    }

    @Test
    void legendNamesTheViewsOfASearchThatMovesThings() {
        assertEquals(
                List.of("bars the expected path", "trigger points", "expected path"),
                Legend.of(null, Sketch.moving(), true, Theme.LIGHT, Legend.ENGLISH)
                        .texts());
    }

    @Test
    void legendNamesTheViewOfSeveralLayersOnceAndCutsLongLists() {
        Overlay.Field low = Sketch.potential();
        Overlay.Field high = new Overlay.Field("potential", 1, low.frame(), low.values(), low.scale());
        assertEquals(
                List.of("potential, 0 to 12 m", "every 1 m"),
                Legend.of(null, List.of(low, high), true, Theme.DARK, Legend.ENGLISH)
                        .texts());
        float[] values = new float[low.values().length];
        for (int i = 0; i < values.length; i++) {
            values[i] = i % 30;
        }
        List<String> words = java.util.stream.IntStream.range(0, 30)
                .mapToObj(k -> "layer " + k)
                .toList();
        Overlay.Field layers = new Overlay.Field("layers", 0, low.frame(), values, new Overlay.Categories(words));
        List<String> texts = Legend.of(null, List.of(layers), true, Theme.DARK, Legend.ENGLISH)
                .texts();
        assertEquals("layer 7", texts.get(7));
        assertEquals(List.of("+ 22"), texts.subList(8, texts.size()));
    }

    @Test
    void scaleBarHasARoundLength() {
        assertEquals(1, ScaleBar.nice(1));
        assertEquals(2, ScaleBar.nice(1.2));
        assertEquals(5, ScaleBar.nice(2.1));
        assertEquals(10, ScaleBar.nice(5.5));
        assertEquals(0.05, ScaleBar.nice(0.03), 1e-12);
        assertEquals(200, ScaleBar.nice(150));
    }

    @Test
    void labelsKeepApart() {
        Labels labels = new Labels();
        labels.take(new Rectangle2D.Double(10, 10, 20, 10));
        assertFalse(labels.free(new Rectangle2D.Double(25, 15, 20, 10)));
        assertFalse(labels.free(new Rectangle2D.Double(31, 10, 5, 5)), "a gap of two pixels is kept");
        assertTrue(labels.free(new Rectangle2D.Double(33, 10, 5, 5)));
    }

    @Test
    void trackReadsPlaceHeadingAndAbilityOfAFrame() {
        Track track = Track.of(Sketch.run()).get(0);
        assertEquals("ann", track.id());
        assertEquals(1.1, track.x(0));
        assertEquals("walk", track.ability(0));
        assertEquals("vault", track.ability(90));
        assertEquals(90, Track.frameAt(Sketch.run().frames(), 3.6));
        assertEquals(250, Track.frameAt(Sketch.run().frames(), 99));
        assertEquals(0, Track.frameAt(Sketch.run().frames(), -1));
    }

    @Test
    void metresAreShortWithATrueMinus() {
        assertEquals("0.8", Shapes.metres(0.8));
        assertEquals("2.0", Shapes.metres(2));
        assertEquals("−1.25", Shapes.metres(-1.25));
    }
}
