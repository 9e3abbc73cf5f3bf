package troupe.paint.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.paint.Viewport;
import troupe.run.frame.Channel;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;

/** Holds what is laid in pixel by pixel against the shapes that it stands for. */
class AgentPixelsTest {
    private static final int WIDE = 300;
    private static final int HIGH = 200;
    private static final int PEOPLE = 40;

    private static CrowdGroup group(String id, String colour) {
        CrowdGroup.Members members = CrowdGroup.Members.of(PEOPLE, Polygon.rectangle(1, 1, 9, 9));
        return new CrowdGroup(id, "", colour, Optional.of(Place.of(5, 5)), Optional.of(members), List.of());
    }

    private static final Crowd CROWD = Crowd.of("crowd", List.of(group("a", "#0000cc"), group("b", "#cc0000")));

    /** Returns agents that wander about a square of ten metres, and over its edge; some have arrived. */
    private static Frames wandering(Random random) {
        List<Channel> channels = new ArrayList<>();
        for (String owner : List.of("a", "b")) {
            channels.add(new Channel("x", "m", Channel.Type.F64, owner, PEOPLE));
            channels.add(new Channel("y", "m", Channel.Type.F64, owner, PEOPLE));
            channels.add(new Channel("heading", "rad", Channel.Type.F32, owner, PEOPLE));
            channels.add(new Channel("state", "walking,waiting,arrived", Channel.Type.U8, owner, PEOPLE));
        }
        FrameRecorder recorder = new FrameRecorder(25, channels);
        double[] values = new double[2 * 4 * PEOPLE];
        for (int k = 0; k < values.length; k++) {
            int channel = k / PEOPLE % 4;
            values[k] = channel == 3
                    ? random.nextInt(3)
                    : channel == 2 ? 7 * random.nextDouble() : 10 * random.nextDouble();
        }
        for (int frame = 0; frame <= 60; frame++) {
            for (int m = 0; m < PEOPLE; m++) {
                for (int first : new int[] {m, m + 4 * PEOPLE}) {
                    double heading = values[first + 2 * PEOPLE] + 0.02 * frame;
                    values[first] += 0.06 * Math.cos(heading);
                    values[first + PEOPLE] += 0.06 * Math.sin(heading);
                }
            }
            recorder.append(values);
        }
        return recorder.frames();
    }

    private static BufferedImage paint(CrowdPainter painter, Viewport view, double scale, AgentPixels pixels) {
        int wide = (int) (WIDE * scale);
        int high = (int) (HIGH * scale);
        BufferedImage image = new BufferedImage(wide, high, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setClip(0, 0, wide, high);
        g.setColor(new Color(0xe0e0d8));
        g.fillRect(0, 0, wide, high);
        g.scale(scale, scale);
        if (pixels == null) {
            painter.paintAgents(g, view, 2.2);
        } else {
            painter.paintAgents(g, view, 2.2, pixels);
        }
        g.dispose();
        return image;
    }

    /** Returns how far two pictures differ: the mean over all channels, and the share of channels far apart. */
    private static double[] difference(BufferedImage one, BufferedImage other) {
        double sum = 0;
        int far = 0;
        int all = one.getWidth() * one.getHeight();
        for (int k = 0; k < all; k++) {
            int a = one.getRGB(k % one.getWidth(), k / one.getWidth());
            int b = other.getRGB(k % one.getWidth(), k / one.getWidth());
            for (int shift = 0; shift < 24; shift += 8) {
                int apart = Math.abs((a >> shift & 0xff) - (b >> shift & 0xff));
                sum += apart;
                far += apart > 90 ? 1 : 0;
            }
        }
        return new double[] {sum / (3.0 * all), far / (3.0 * all)};
    }

    @Test
    void showsWhatTheShapesShow() {
        long seed = Long.getLong("seed", 3);
        Random random = new Random(seed);
        AgentPixels pixels = new AgentPixels();
        for (int round = 0; round < 24; round++) {
            Frames frames = wandering(random);
            boolean trails = round % 2 == 0;
            CrowdPainter painter = new CrowdPainter(CROWD, frames, Theme.LIGHT, CrowdPainter.DEEPEST, trails);
            Viewport view = Viewport.fit(new troupe.geometry.Box(0, 0, 10, 10), WIDE, HIGH, 5)
                    .zoomed(new double[] {0.5, 1, 2, 4}[round % 4], 150, 100);
            double scale = round % 3 == 0 ? 2 : 1;
            BufferedImage exact = paint(painter, view, scale, null);
            BufferedImage laid = paint(painter, view, scale, pixels);
            double[] apart = difference(exact, laid);
            String what = "round " + round + " seed " + seed + ": mean " + apart[0] + ", far " + apart[1];
            double[] empty = difference(paint(painter, view.panned(5000, 0), scale, null), exact);
            assertTrue(empty[0] > 1, "nothing to see in " + what);
            assertTrue(apart[0] < 0.12 * empty[0] && apart[1] < 0.002, what + " of " + empty[0]);
        }
    }

    @Test
    void holdsNothingOfThePictureBefore() {
        Random random = new Random(8);
        CrowdPainter first = new CrowdPainter(CROWD, wandering(random), Theme.LIGHT);
        CrowdPainter second = new CrowdPainter(CROWD, wandering(random), Theme.DARK);
        Viewport view = new Viewport(0, 10, 20);
        AgentPixels used = new AgentPixels();
        for (CrowdPainter painter : List.of(first, second, first)) {
            int[] fresh = rgb(paint(painter, view, 1, new AgentPixels()));
            assertArrayEquals(fresh, rgb(paint(painter, view, 1, used)));
        }
    }

    private static int[] rgb(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    @Test
    void largeAgentsAreThoseOfTheShapes() {
        CrowdPainter painter = new CrowdPainter(CROWD, wandering(new Random(4)), Theme.LIGHT);
        Viewport near = new Viewport(3, 6, 200);
        assertArrayEquals(rgb(paint(painter, near, 1, null)), rgb(paint(painter, near, 1, new AgentPixels())));
    }

    @Test
    void linesCoverHalfOfTheirWidthOnEachSide() {
        AgentPixels pixels = new AgentPixels();
        BufferedImage image = new BufferedImage(20, 20, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setClip(0, 0, 20, 20);
        assertTrue(pixels.begin(g));
        // three pixels wide along the middle of row 10, from column 5 to 15, straight on over a place between
        pixels.line(new double[] {5, 10.5, 9, 10.5, 15, 10.5}, 6, 3, Color.WHITE);
        pixels.draw(g);
        int[] column = new int[20];
        for (int y = 0; y < 20; y++) {
            column[y] = image.getRGB(10, y) & 0xff;
        }
        assertArrayEquals(new int[] {0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0}, column);
        assertEquals(0, image.getRGB(2, 10) & 0xff);
        assertEquals(255, image.getRGB(4, 10) & 0xff);
        assertEquals(255, image.getRGB(15, 10) & 0xff);
        assertEquals(0, image.getRGB(17, 10) & 0xff);
    }
}
