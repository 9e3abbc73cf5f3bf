package troupe.work;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import troupe.paint.BlockTexts;
import troupe.paint.Labels;
import troupe.paint.StoredPictures;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.paint.motion.RunPainter;
import troupe.paint.picture.Legend;
import troupe.paint.scene.ScenePainter;
import troupe.run.Run;
import troupe.run.view.Overlay;
import troupe.scene.xml.SceneException;

/** Compares the legends of all views, and the labels of scenes and ways, with stored pictures; letters are blocks. */
class TextPicturesTest {
    private static final int WIDTH = 460;
    private static final int ROW = 37;
    private static final int MOST = 440;

    private interface Painting {
        void on(Graphics2D g) throws SceneException, IOException;
    }

    private static BufferedImage image(int width, int height, Theme theme, Painting painting)
            throws SceneException, IOException {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(theme.color(Tone.CANVAS));
        g.fillRect(0, 0, width, height);
        painting.on(new BlockTexts(g));
        g.dispose();
        return image;
    }

    /** Paints the legend of each view, one below the other; {@code shift} pixels aside. */
    private static BufferedImage legends(Theme theme, Theme painted, int shift) throws SceneException, IOException {
        List<ViewPicturesTest.Case> cases =
                ViewPicturesTest.cases().filter(c -> c.theme() == theme).toList();
        return image(WIDTH, ROW * (cases.size() + 2), theme, g -> {
            int y = 4;
            for (ViewPicturesTest.Case one : cases) {
                List<Overlay> overlays = ViewPicturesTest.shown(one.scenario()).overlays().stream()
                        .filter(o -> o.key().equals(ViewPicturesTest.view(one.key())))
                        .toList();
                boolean filled = !ViewPicturesTest.LINED.contains(one.key());
                y += legend(g, Legend.of(null, overlays, filled, painted, Legend.ENGLISH), shift, y);
            }
            Run run = ViewPicturesTest.shown(ViewPicturesTest.JOURNEY).run();
            legend(g, Legend.of(run, List.of(), true, painted, Legend.ENGLISH), shift, y);
        });
    }

    private static int legend(Graphics2D g, Legend legend, int shift, int y) {
        legend.paint(g, 4 + shift, y, MOST);
        return legend.size(g, MOST).height + 4;
    }

    /** Paints the labels of a scene, and of the ways of a run. */
    private static BufferedImage labels(ViewPicturesTest.Scenario what, Theme theme, Theme painted, int shift)
            throws SceneException, IOException {
        return image(420, 320, theme, g -> {
            ViewPicturesTest.Shown shown = ViewPicturesTest.shown(what);
            Viewport view = Viewport.fit(what.part(), 2.0 + shift, 2, 416, 316);
            RunPainter run = new RunPainter(shown.run(), painted);
            ScenePainter scene = run.scene(shown.scene(), what.time());
            scene.paintGround(g, view);
            scene.paintObstacles(g, view);
            Labels labels = new Labels();
            run.paintLegs(g, view);
            run.paintEnds(g, view);
            run.takeRoom(labels, view, what.time());
            scene.paintLabels(g, view, labels);
            run.paintPills(g, view, labels);
            run.paintActors(g, view, what.time());
        });
    }

    private static Theme other(Theme theme) {
        return theme == Theme.LIGHT ? Theme.DARK : Theme.LIGHT;
    }

    private static void assertNoticed(String what, BufferedImage right, Stream<BufferedImage> spoiled) {
        spoiled.forEach(picture -> {
            double difference = StoredPictures.difference(right, picture);
            assertTrue(difference > 1, what + " spoiled differs by " + difference + " only");
        });
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void legendsLookLikeTheStoredPicture(Theme theme) throws SceneException, IOException {
        BufferedImage now = legends(theme, theme, 0);
        StoredPictures.assertLooksLike("legends-" + theme.key(), now);
        assertNoticed("legends", now, Stream.of(legends(theme, theme, 3), legends(theme, other(theme), 0)));
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void labelsLookLikeTheStoredPictures(Theme theme) throws SceneException, IOException {
        for (ViewPicturesTest.Scenario what :
                List.of(ViewPicturesTest.JOURNEY, ViewPicturesTest.ENCOUNTER, ViewPicturesTest.CROWD)) {
            BufferedImage now = labels(what, theme, theme, 0);
            StoredPictures.assertLooksLike("labels-" + what.task() + "-" + theme.key(), now);
            assertNoticed(
                    what.task(), now, Stream.of(labels(what, theme, theme, 3), labels(what, theme, other(theme), 0)));
        }
    }
}
