package troupe.work.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.run.view.Overlay;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Encounter;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.xml.SceneXml;
import troupe.work.Tasks;

class MomentViewsTest {
    private final MomentViews views = new MomentViews();

    private static Run crowd(int people) {
        CrowdGroup.Members members = CrowdGroup.Members.of(people, Polygon.rectangle(4, 4, 12, 12));
        Crowd crowd = Crowd.of("all", List.of(CrowdGroup.of("few", Place.of(14, 8), members)));
        Scene scene = new Scene("Field", new World(16, 16, 0.1), List.of(), List.of(), List.of(), List.of(crowd));
        Engine engine = Tasks.start(scene, "all");
        engine.step(20);
        return engine.run();
    }

    private static Run encounter(int steps) throws Exception {
        Scene scene = SceneXml.read(Path.of("scenes/risk/crossing.xml")).scene();
        Engine engine = Tasks.start(scene, "cross");
        engine.step(steps);
        return engine.run();
    }

    private static double volume(Overlay.Field field) {
        double sum = 0;
        for (float value : field.values()) {
            sum += Float.isNaN(value) ? 0 : value;
        }
        return sum * field.frame().cell() * field.frame().cell();
    }

    @Test
    void theDensityAddsUpToThePeople() {
        Overlay.Field field =
                (Overlay.Field) views.at(crowd(60), 0.4, List.of("density"), 0).get(0);
        assertEquals(60, volume(field), 1.5);
    }

    @Test
    void onePersonAloneIsABellOfHalfAMetre() {
        Run run = crowd(1);
        Overlay.Field field =
                (Overlay.Field) views.at(run, 0, List.of("density"), 0).get(0);
        Frames frames = run.frames();
        int cell = field.frame()
                .cellAt(frames.value(0, frames.channel("few", "x"), 0), frames.value(0, frames.channel("few", "y"), 0));
        // in the middle 1 / (2 pi 0.5^2), at most a cell's corner, 0.15 m, off the person
        assertEquals(0.6366, field.values()[cell], 0.03);
    }

    @Test
    void noDensityLiesInWalls() throws Exception {
        Scene scene = SceneXml.read(Path.of("scenes/crowd/fork.xml")).scene();
        Engine engine = Tasks.start(scene, "fork");
        engine.step(3);
        Overlay.Field field =
                (Overlay.Field) views.at(engine.run(), 0, List.of("density"), 0).get(0);
        assertTrue(Float.isNaN(field.values()[field.frame().cellAt(7.8, 3)]), "in the west wall");
        assertTrue(field.values()[field.frame().cellAt(9, 3)] > 0.5, "in the corridor");
    }

    @Test
    void theProbabilityOfOneAvatarAddsUpToOneAndSpreadsWithTime() throws Exception {
        Run run = encounter(40);
        Overlay.Field soon =
                (Overlay.Field) views.at(run, 1.2, List.of("probability"), 0.5).get(0);
        Overlay.Field late =
                (Overlay.Field) views.at(run, 1.2, List.of("probability"), 2).get(0);
        // a hundredth of the peak is left out, and with it a hundredth of the volume
        assertEquals(0.99, volume(soon), 0.015);
        assertEquals(0.99, volume(late), 0.03);
        assertTrue(cells(late) > 2 * cells(soon), cells(late) + " cells after " + cells(soon));
        assertEquals(soon.frame(), late.frame());
    }

    private static int cells(Overlay.Field field) {
        int cells = 0;
        for (float value : field.values()) {
            cells += Float.isNaN(value) ? 0 : 1;
        }
        return cells;
    }

    @Test
    void thePlanBeforeIsThatOfTheFrameBefore() throws Exception {
        Run run = encounter(60);
        Encounter encounter = (Encounter) run.scene().task("cross").orElseThrow();
        Frames frames = run.frames();
        int x = frames.channel(encounter.actor(), "plan.x");
        Overlay.Lines lines = (Overlay.Lines)
                views.at(run, 59 / 30.0, List.of("plan-before"), 0).get(0);
        assertEquals(frames.value(58, x, 7), lines.lines().get(0)[14]);
        assertEquals(List.of(), views.at(run, 0, List.of("plan-before"), 0), "there is none before the first");
    }

    @Test
    void otherTasksHaveNone() throws Exception {
        assertEquals(List.of(), views.at(encounter(2), 0, List.of("density", "trails"), 0));
        assertEquals(List.of(), views.at(crowd(2), 0, List.of("probability", "plan-before"), 0));
    }

    @Test
    void aFieldIsReadAsItsLegendSays() throws Exception {
        Run run = encounter(10);
        Overlay.Field field =
                (Overlay.Field) views.at(run, 0.3, List.of("probability"), 1).get(0);
        assertEquals(
                MomentViews.scale(run.scene().task("cross").orElseThrow(), "probability", 1)
                        .orElseThrow(),
                field.scale());
        assertSame(Overlay.Continuous.class, field.scale().getClass());
    }

    @Test
    void theStripIsThatOfTheMoment() throws Exception {
        Run run = encounter(100);
        assertEquals(List.of("Bob"), views.strip(run, 0).orElseThrow().names());
        double early = views.strip(run, 0.5).orElseThrow().most(0);
        double late = views.strip(run, 2.8).orElseThrow().most(0);
        assertTrue(late > early + 0.1, early + " and then " + late);
        assertTrue(views.strip(crowd(3), 0.2).isEmpty());
        assertTrue(views.strip(encounterOfNoFrame(), 0).isEmpty());
    }

    private static Run encounterOfNoFrame() throws Exception {
        return Tasks.start(SceneXml.read(Path.of("scenes/risk/crossing.xml")).scene(), "cross")
                .run();
    }
}
