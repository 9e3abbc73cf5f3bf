package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import troupe.app.document.Mark;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.Encounter;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Draws boxes round obstacles, avatars, groups and the ends of tasks, and does with them what is done with one thing. */
class BoxRobotTest extends RobotTest {
    @Override
    void begin() {}

    private void open(String scene) throws Exception {
        Path file = Files.copy(Path.of("scenes", scene), folder.resolve("scene.xml"));
        studio = new StudioFixture(folder, file, Map.of("language", "en"));
    }

    private Set<String> box(double x0, double y0, double x1, double y1) {
        studio.drag(studio.window().canvas(), studio.pixel(x0, y0), studio.pixel(x1, y1));
        return new TreeSet<>(
                OnEventThread.get(() -> studio.session().selection().ids()));
    }

    private void await(String what, Predicate<Scene> holds) {
        Await.until(what, () -> holds.test(studio.session().document().scene()));
    }

    private int steps() {
        return OnEventThread.get(
                () -> studio.session().document().history().names().size());
    }

    private static Encounter encounter(Scene scene) {
        return (Encounter) scene.task("cross").orElseThrow();
    }

    private static Place start(Scene scene, String avatar) {
        return Mark.start(encounter(scene).avatar(avatar).orElseThrow()).orElseThrow();
    }

    @Test
    void aBoxTakesAvatarsAndPlacesWithTheObstaclesAndAllMoveTogether() throws Exception {
        open("risk/crossing.xml");
        assertEquals(Set.of("kiosk", "cross#goal", "cross/bob", "cross/bob#0"), box(0.3, 5.6, 5.8, 9.7));
        Scene before = studio.scene();
        Point from = studio.pixel(1.4, 8.6);
        Point to = studio.pixel(2.4, 8.1);
        studio.drag(studio.window().canvas(), from, to);
        Scene after = studio.scene();
        double dx = start(after, "bob").x() - 1;
        double dy = start(after, "bob").y() - 6.4;
        assertTrue(dx > 0.7 && dx < 1.3 && dy < -0.2 && dy > -0.8, dx + ", " + dy);
        assertEquals(
                0.8 + dx,
                after.obstacle("kiosk").orElseThrow().outline().bounds().minX(),
                1e-3);
        List<Avatar.Head> heads = Mark.heads(encounter(after).avatar("bob").orElseThrow());
        assertEquals(5.2 + dx, heads.get(0).to().x(), 1e-3);
        assertEquals(Place.of(9.2, 4.2), heads.get(1).to());
        assertEquals(9.2 + dy, encounter(after).goal().y(), 1e-3);
        assertEquals(1, steps());
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        await("undone in one step", before::equals);
    }

    @Test
    void whatABoxHoldsIsCutAndPastedInOneStepEach() throws Exception {
        open("risk/crossing.xml");
        Scene before = studio.scene();
        assertEquals(Set.of("kiosk", "cross#goal", "cross/bob", "cross/bob#0"), box(0.3, 5.6, 5.8, 9.7));
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_X);
        await(
                "cut",
                s -> s.obstacle("kiosk").isEmpty() && encounter(s).avatars().isEmpty());
        assertEquals(1, steps());
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_V);
        await("pasted", s -> s.obstacle("kiosk").isPresent() && encounter(s).equals(encounter(before)));
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_D);
        await("doubled", s -> encounter(s).avatar("bob-1").isPresent());
        assertEquals(Place.of(1.5, 5.9), start(studio.scene(), "bob-1"));
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_Z);
        await("all undone", before::equals);
    }

    @Test
    void bothEndsOfATaskInABoxAreTheTask() throws Exception {
        open("risk/crossing.xml");
        Set<String> all = box(0.3, 0.3, 9.7, 9.7);
        assertEquals(Set.of("kiosk", "planter", "cross", "cross/bob", "cross/bob#0", "cross/bob#1"), all);
        studio.keys(KeyEvent.VK_SHIFT, KeyEvent.VK_RIGHT);
        await("nudged", s -> encounter(s).start().equals(Place.of(5.5, 0.8)));
        assertEquals(Place.of(5.5, 9.2), encounter(studio.scene()).goal());
        assertEquals(1, steps());
    }

    @Test
    void groupsAreTakenByABoxAndDeleted() throws Exception {
        open("crowd/fork.xml");
        assertEquals(Set.of("fork/blue", "fork/black"), box(-0.4, -0.4, 12.4, 6.6));
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_D);
        await(
                "doubled",
                s -> ((Crowd) s.task("fork").orElseThrow()).group("blue-1").isPresent());
        studio.keys(KeyEvent.VK_DELETE);
        await(
                "deleted",
                s -> ((Crowd) s.task("fork").orElseThrow()).group("blue-1").isEmpty());
        assertEquals(2, steps());
    }
}
