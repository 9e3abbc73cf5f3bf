package troupe.work;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import troupe.geometry.Box;
import troupe.paint.StoredPictures;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.paint.field.OverlayPainter;
import troupe.paint.motion.RunPainter;
import troupe.paint.scene.ScenePainter;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.run.view.GridOverlays;
import troupe.run.view.Overlay;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.work.view.Fields;
import troupe.work.view.MomentViews;

/**
 * Compares every view that the window lays over a scene, as the planners make it and as the window's painters paint
 * it, with stored pictures in both themes. Each picture is also painted in ways it should not be, to see that this
 * would be noticed.
 */
class ViewPicturesTest {
    private static final int WIDTH = 220;
    private static final int HEIGHT = 160;
    static final Scenario JOURNEY = new Scenario("unified/courtyard", "to-the-fountain", new Box(0, 0, 18, 13), 8.2, 0);
    private static final Scenario CRATE =
            new Scenario("unified/courtyard", "to-the-fountain", new Box(5.5, 5.5, 12.5, 10.5), 8.2, 0);
    static final Scenario ENCOUNTER = new Scenario("risk/crossing", "cross", new Box(1, 2, 7.5, 9.5), 2.2, 1);
    static final Scenario CROWD = new Scenario("crowd/fork", "fork", new Box(4.5, 12.5, 15.5, 20.5), 14, 0);
    static final Set<String> LINED = Set.of("potential-lines");
    private static final Map<String, Shown> MADE = new HashMap<>();

    /** A task of a sample scene, the part of it that is looked at, the moment, and how far ahead avatars are expected. */
    record Scenario(String scene, String task, Box part, double time, double ahead) {}

    /** What a task gave. */
    record Shown(Scene scene, Run run, List<Overlay> overlays) {}

    /** How a picture is spoiled. */
    private enum Spoiled {
        NOT,
        LEFT_OUT,
        SHIFTED,
        OTHER_COLOUR
    }

    /** One view in one theme. */
    record Case(Scenario scenario, String key, Theme theme) {
        @Override
        public String toString() {
            return "view-" + key + "-" + theme.key();
        }
    }

    static Stream<Case> cases() {
        Stream<Case> journey = Stream.concat(GridOverlays.KEYS.stream(), Stream.of("potential-lines", "effort"))
                .flatMap(key -> themes(JOURNEY, key));
        Stream<Case> crate = Stream.of("triggers", "expected-path", "instance").flatMap(key -> themes(CRATE, key));
        Stream<Case> encounter = Stream.of(
                        MomentViews.PROBABILITY, MomentViews.RISK, "expected-ways", MomentViews.BEFORE)
                .flatMap(key -> themes(ENCOUNTER, key));
        Stream<Case> crowd = Stream.of(MomentViews.DENSITY, "trails").flatMap(key -> themes(CROWD, key));
        return Stream.of(journey, crate, encounter, crowd).flatMap(s -> s);
    }

    private static Stream<Case> themes(Scenario scenario, String key) {
        return Stream.of(Theme.values()).map(theme -> new Case(scenario, key, theme));
    }

    static Shown shown(Scenario scenario) throws SceneException, IOException {
        Shown made = MADE.get(scenario.scene());
        if (made == null) {
            made = make(scenario);
            MADE.put(scenario.scene(), made);
        }
        return made;
    }

    private static Shown make(Scenario what) throws SceneException, IOException {
        Scene scene = SceneXml.read(Path.of("scenes/" + what.scene() + ".xml")).scene();
        Engine engine = Tasks.start(scene, what.task());
        Run run = engine.finish();
        List<Overlay> overlays = new ArrayList<>();
        if (what.scene().equals(JOURNEY.scene())) {
            Fields.of(scene, what.task(), GridOverlays.KEYS).overlays().forEach(overlays::addAll);
            engine.overlays(List.of(0, 0, 2)).stream()
                    .filter(o -> !GridOverlays.KEYS.contains(o.key()))
                    .forEach(overlays::add);
        } else {
            List<String> keys = List.of(
                    MomentViews.DENSITY,
                    MomentViews.PROBABILITY,
                    MomentViews.RISK,
                    MomentViews.EXPECTED,
                    MomentViews.BEFORE);
            overlays.addAll(new MomentViews().at(run, what.time(), keys, what.ahead()));
        }
        return new Shown(scene, run, overlays);
    }

    static String view(String key) {
        return switch (key) {
            case "potential-lines" -> "potential";
            case "expected-ways" -> MomentViews.EXPECTED;
            default -> key;
        };
    }

    private static BufferedImage image(Case what, Spoiled spoiled) throws SceneException, IOException {
        Shown shown = shown(what.scenario());
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(what.theme().color(Tone.CANVAS));
        g.fillRect(0, 0, WIDTH, HEIGHT);
        Viewport view = Viewport.fit(what.scenario().part(), 2, 2, WIDTH - 4.0, HEIGHT - 4.0);
        boolean trails = what.key().equals("trails");
        RunPainter run =
                new RunPainter(shown.run(), what.theme(), Integer.MAX_VALUE, trails && spoiled != Spoiled.LEFT_OUT);
        ScenePainter scene = run.scene(shown.scene(), what.scenario().time());
        scene.paintGround(g, view);
        scene.paintObstacles(g, view);
        List<Overlay> overlays = shown.overlays().stream()
                .filter(o -> o.key().equals(view(what.key())))
                .toList();
        assertFalse(overlays.isEmpty() && !trails, "no view " + what.key());
        Theme painted = spoiled == Spoiled.OTHER_COLOUR ? other(what.theme()) : what.theme();
        Viewport at = spoiled == Spoiled.SHIFTED ? view.panned(3, 0) : view;
        if (spoiled != Spoiled.LEFT_OUT) {
            overlays.forEach(o -> new OverlayPainter(o, painted, !LINED.contains(what.key())).paint(g, at));
        }
        if (overlays.stream().anyMatch(Overlay.Field.class::isInstance)) {
            scene.paintOutlines(g, view);
        }
        if (trails) {
            RunPainter actors = spoiled == Spoiled.OTHER_COLOUR ? new RunPainter(shown.run(), painted, 1, true) : run;
            actors.paintActors(g, at, what.scenario().time());
        }
        g.dispose();
        return image;
    }

    private static Theme other(Theme theme) {
        return theme == Theme.LIGHT ? Theme.DARK : Theme.LIGHT;
    }

    @ParameterizedTest
    @MethodSource("cases")
    void looksLikeTheStoredPicture(Case what) throws SceneException, IOException {
        StoredPictures.assertLooksLike(what.toString(), image(what, Spoiled.NOT));
    }

    @ParameterizedTest
    @MethodSource("cases")
    void spoiledPictureIsNoticed(Case what) throws SceneException, IOException {
        BufferedImage right = image(what, Spoiled.NOT);
        for (Spoiled spoiled : List.of(Spoiled.LEFT_OUT, Spoiled.SHIFTED, Spoiled.OTHER_COLOUR)) {
            double difference = StoredPictures.difference(right, image(what, spoiled));
            assertTrue(difference > 1, what + " " + spoiled + " differs by " + difference + " only");
        }
    }
}
