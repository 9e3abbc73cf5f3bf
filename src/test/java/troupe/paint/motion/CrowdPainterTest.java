package troupe.paint.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.paint.Viewport;
import troupe.paint.picture.Picture;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.search.Outcome;

class CrowdPainterTest {
    private static final Color RED = new Color(0xcc0000);
    private static final Color BLUE = new Color(0x0000cc);

    /** Two agents of parts of one group: one walks from 2,2 to 8,2, the other has arrived at 5,8. */
    private static Run run() {
        CrowdGroup.Members one = CrowdGroup.Members.of(1, Polygon.rectangle(1, 1, 9, 9));
        CrowdGroup walking = new CrowdGroup(
                "walking", "", "#0000cc", java.util.Optional.empty(), java.util.Optional.of(one), List.of());
        CrowdGroup there =
                new CrowdGroup("there", "", "", java.util.Optional.empty(), java.util.Optional.of(one), List.of());
        CrowdGroup both = new CrowdGroup(
                "both",
                "",
                "#cc0000",
                java.util.Optional.of(Place.of(5, 8)),
                java.util.Optional.empty(),
                List.of(walking, there));
        List<Channel> channels = new java.util.ArrayList<>();
        for (String owner : List.of("walking", "there")) {
            channels.add(new Channel("x", "m", Channel.Type.F64, owner, 1));
            channels.add(new Channel("y", "m", Channel.Type.F64, owner, 1));
            channels.add(new Channel("heading", "rad", Channel.Type.F32, owner, 1));
            channels.add(new Channel("state", "walking,waiting,arrived", Channel.Type.U8, owner, 1));
        }
        FrameRecorder recorder = new FrameRecorder(25, channels);
        for (int k = 0; k <= 100; k++) {
            recorder.append(2 + 0.06 * k, 2, 0, 0, 5, 8, 0, 2);
        }
        Crowd crowd = Crowd.of("crowd", List.of(both));
        Scene scene = new Scene("", new World(10, 10, 0.1), List.of(), List.of(), List.of(), List.of(crowd));
        return new Run(
                scene, "crowd", Outcome.FOUND, Report.builder().build(), recorder.frames(), List.of(), List.of());
    }

    private static int colourAt(int level, boolean trails, double x, double y) {
        Run run = run();
        Frames frames = run.frames();
        BufferedImage image = new BufferedImage(400, 400, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        Viewport view = Viewport.fit(new troupe.geometry.Box(0, 0, 10, 10), 400, 400, 0);
        new CrowdPainter((Crowd) run.scene().tasks().get(0), frames, Theme.LIGHT, level, trails)
                .paintAgents(g, view, 4);
        g.dispose();
        return image.getRGB((int) view.px(x), (int) view.py(y)) & 0xffffff;
    }

    @Test
    void agentsHaveTheColourOfTheirGroupAtTheChosenLevel() {
        assertEquals(BLUE.getRGB() & 0xffffff, colourAt(CrowdPainter.DEEPEST, false, 7.86, 2));
        assertEquals(RED.getRGB() & 0xffffff, colourAt(1, false, 7.86, 2));
    }

    @Test
    void trailsShowWhereAnAgentCameFrom() {
        assertEquals(0, colourAt(CrowdPainter.DEEPEST, false, 6.5, 2));
        int trail = colourAt(CrowdPainter.DEEPEST, true, 6.5, 2);
        assertTrue((trail & 0xff) > 0 && (trail >> 16) == 0, Integer.toHexString(trail));
    }

    @Test
    void picturesOfARunShowTheCrowd() {
        BufferedImage image = new BufferedImage(600, 700, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        Picture.of(run(), 4).paint(g, 600);
        g.dispose();
        boolean blue = false;
        for (int i = 0; i < 600 * 600 && !blue; i++) {
            blue = (image.getRGB(i % 600, i / 600) & 0xffffff) == (BLUE.getRGB() & 0xffffff);
        }
        assertTrue(blue);
    }
}
