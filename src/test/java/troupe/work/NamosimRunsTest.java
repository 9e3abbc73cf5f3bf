package troupe.work;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import troupe.SharedData;
import troupe.exchange.Formats;
import troupe.run.Engine;
import troupe.run.Report;
import troupe.scene.Ability;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.Task;
import troupe.scene.setting.Settings;

/** Plans the journeys of published scenes of navigation among movable obstacles. */
class NamosimRunsTest {

    @ParameterizedTest
    @CsvSource({
        "minimal_stilman_2005, 1",
        "minimal_stilman_rrt_star, 1",
        "minimal_nav_only, 1",
        "1_robot_2_goals, 2",
        "intersections_base, 1"
    })
    void movesNothingWhereNothingNeedBeMoved(String name, int journeys) throws Exception {
        Scene scene = Formats.importer("namosim").read(SharedData.require("namo/" + name + ".svg"));
        assertEquals(journeys, scene.tasks().size());
        for (Task task : scene.tasks()) {
            Map<String, Object> report = planned(scene, task.id());
            assertEquals(true, report.get("solved"), name);
            assertEquals(List.of(), report.get("moved"), name);
            assertEquals(List.of(Ability.WALK.key()), report.get("abilities"), name);
            Journey journey = (Journey) task;
            double straight = Math.hypot(
                    journey.goal().x() - journey.start().x(),
                    journey.goal().y() - journey.start().y());
            double length = (double) report.get("length");
            assertTrue(length > straight - 2 * scene.world().cell() && length < 2 * straight, name + " " + length);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "obstacle_on_goal, movable_box, ''",
        "teleop, movable_box, ''",
        "1_robot_2_obstacles, '', box_1 box_2",
        "overlapping_movables, '', movable_box movable_box-3"
    })
    void findsNoWayWhereOneMustMoveAndMayNot(String name, String blocker, String together) throws Exception {
        Scene drawn = Formats.importer("namosim").read(SharedData.require("namo/" + name + ".svg"));
        Scene scene = Settings.apply(drawn, "goal_0", "preference.move", "off");
        Map<String, Object> report = planned(scene, "goal_0");
        assertEquals(false, report.get("solved"), name);
        if (!blocker.isEmpty()) {
            assertTrue(((List<?>) report.get("blocked_by")).contains(blocker), name + " " + report);
        }
        String joint = String.join(
                " ",
                ((List<?>) report.get("blocked_together"))
                        .stream().map(String.class::cast).toList());
        assertEquals(together, joint, name);
        Scene walls = new Scene(
                scene.title(),
                scene.world(),
                scene.obstacles().stream().filter(o -> !o.movable()).toList(),
                List.of(),
                scene.actors(),
                scene.tasks());
        assertEquals(true, planned(walls, "goal_0").get("solved"), name + " past the walls alone");
    }

    @ParameterizedTest
    @CsvSource({
        "obstacle_on_goal, movable_box",
        "teleop, movable_box",
        "1_robot_2_obstacles, box_1 box_2",
        "overlapping_movables, movable_box movable_box-3"
    })
    void movesWhatBarsTheWay(String name, String barring) throws Exception {
        Scene drawn = Formats.importer("namosim").read(SharedData.require("namo/" + name + ".svg"));
        for (String manipulation : List.of("grip", "free")) {
            Scene scene = Settings.apply(drawn, "goal_0", "manipulation", manipulation);
            Map<String, Object> report = planned(scene, "goal_0");
            assertEquals(true, report.get("solved"), name + " " + manipulation);
            Set<String> moved = new TreeSet<>();
            for (Object each : (List<?>) report.get("moved")) {
                moved.add((String) ((Report) each).values().get("id"));
            }
            assertEquals(barring, String.join(" ", moved), name + " " + manipulation);
            assertEquals(manipulation.equals("grip"), (double) report.get("transfer_length") > 0, name);
        }
    }

    private static Map<String, Object> planned(Scene scene, String task) {
        Engine engine = Tasks.start(scene, task);
        while (engine.outcome().isRunning()) {
            engine.step(100_000);
        }
        Report report = engine.run().report();
        return report.values();
    }
}
