package troupe.exchange;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import troupe.SharedData;
import troupe.exchange.scenario.NamosimImport;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Compares the published drawings with what NAMOSIM itself reads from them. */
class NamosimDataTest {
    /** What NAMOSIM takes a curved goal's centre from are its control points; they lie so far off, in metres. */
    private static final double CONTROL_POINTS = 0.02;

    private static final Pattern FIELD = Pattern.compile("\"(\\w+)\": (\"[^\"]*\"|\\[[^\\[\\]{}]*\\]|[-\\d.e]+)");

    @ParameterizedTest
    @ValueSource(
            strings = {
                "minimal_stilman_2005",
                "minimal_stilman_rrt_star",
                "minimal_nav_only",
                "obstacle_on_goal",
                "1_robot_2_goals",
                "1_robot_2_obstacles",
                "overlapping_movables",
                "intersections_base"
            })
    void readsWhatNamosimReads(String name) throws Exception {
        Scene scene = new NamosimImport().read(SharedData.require("namo/" + name + ".svg"));
        String text = Files.readString(SharedData.require("namo/expected.json"));
        int begin = text.indexOf("\"" + name + ".svg\"");
        int end = text.indexOf(".svg\"", begin + name.length() + 8);
        String expected = text.substring(begin, end < 0 ? text.length() : end);
        String walls = between(expected, "\"walls\"", "\"movables\"");
        String movables = between(expected, "\"movables\"", "\"robots\"");
        String robots = expected.substring(expected.indexOf("\"robots\""));

        double[] size = fields(expected, "size_m").get(0);
        assertEquals(size[0], scene.world().width(), 1e-9);
        assertEquals(size[1], scene.world().depth(), 1e-9);
        double[] cells = fields(expected, "cells").get(0);
        assertCells(
                cells[0],
                scene.world().width(),
                scene.world().cell(),
                scene.world().cols());
        assertCells(
                cells[1],
                scene.world().depth(),
                scene.world().cell(),
                scene.world().rows());
        assertEquals(fields(expected, "cell_m").get(0)[0], scene.world().cell(), 1e-12);
        walls(scene, walls);
        movables(scene, movables);
        robots(scene, robots);
    }

    /** Asserts the number of cells along a side; where cells fit exactly NAMOSIM may round up to one more. */
    private static void assertCells(double expected, double metres, double cell, int found) {
        boolean fits = Math.abs(metres / cell - Math.rint(metres / cell)) < 1e-9;
        assertTrue(found == expected || fits && found == expected - 1, found + " cells, expected " + expected);
    }

    private static void walls(Scene scene, String expected) {
        List<Obstacle> walls =
                scene.obstacles().stream().filter(o -> !o.movable()).toList();
        assertEquals(words(expected, "id"), walls.stream().map(Obstacle::id).toList());
        for (int i = 0; i < walls.size(); i++) {
            double area = fields(expected, "area").get(i)[0];
            assertEquals(
                    area,
                    Math.abs(walls.get(i).outline().signedArea()),
                    1e-4,
                    walls.get(i).id());
            double[] box = fields(expected, "bbox").get(i);
            Box bounds = walls.get(i).outline().bounds();
            double[] found = {bounds.minX(), bounds.minY(), bounds.maxX(), bounds.maxY()};
            assertArrayEquals(box, found, 1e-4, walls.get(i).id());
        }
    }

    private static void movables(Scene scene, String expected) {
        List<Obstacle> movables =
                scene.obstacles().stream().filter(Obstacle::movable).toList();
        assertEquals(words(expected, "id"), movables.stream().map(Obstacle::id).toList());
        for (int i = 0; i < movables.size(); i++) {
            double[] centroid = fields(expected, "centroid").get(i);
            Point found = movables.get(i).outline().centroid();
            assertEquals(centroid[0], found.x(), 1e-4, movables.get(i).id());
            assertEquals(centroid[1], found.y(), 1e-4, movables.get(i).id());
            double area = fields(expected, "area").get(i)[0];
            assertEquals(area, Math.abs(movables.get(i).outline().signedArea()), 1e-4);
        }
    }

    private static void robots(Scene scene, String expected) {
        Actor robot = scene.actors().get(0);
        assertEquals(1, scene.actors().size());
        assertEquals(words(expected, "id").get(0), robot.id());
        assertEquals(fields(expected, "circ_radius").get(0)[0], robot.walk().radius(), 1e-3);
        double[] centroid = fields(expected, "centroid").get(0);
        List<double[]> goals = fields(expected, "xy");
        assertEquals(goals.size(), scene.tasks().size());
        for (int i = 0; i < goals.size(); i++) {
            Journey journey = (Journey) scene.tasks().get(i);
            assertEquals(words(expected, "id").get(i + 1), journey.id());
            assertTrue(metres(centroid, journey.start()) < 1e-3, "start " + journey.start());
            assertTrue(metres(goals.get(i), journey.goal()) < CONTROL_POINTS, "goal " + journey.goal());
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "minimal_stilman_2005",
                "minimal_stilman_rrt_star",
                "minimal_nav_only",
                "obstacle_on_goal",
                "1_robot_2_goals",
                "1_robot_2_obstacles",
                "teleop",
                "overlapping_movables",
                "intersections_base"
            })
    void agreesWithTheIndex(String name) throws Exception {
        Path file = SharedData.require("namo/" + name + ".svg");
        Scene scene = new NamosimImport().read(file);
        String[] row = Files.readAllLines(SharedData.require("namo/index.csv")).stream()
                .filter(line -> line.startsWith(name + ".svg,"))
                .findFirst()
                .orElseThrow()
                .split(",");
        long movable = scene.obstacles().stream().filter(Obstacle::movable).count();
        assertEquals(Integer.parseInt(row[5]), scene.obstacles().size() - movable, "walls");
        assertEquals(Integer.parseInt(row[6]), movable, "movables");
        assertEquals(Integer.parseInt(row[7]), scene.tasks().size(), "goals");
        assertEquals(
                Double.parseDouble(row[8]), 100 * scene.actors().get(0).walk().radius(), 0.06, "radius in cm");
        String[] goals = row[10].split(" ; ");
        for (int i = 0; i < goals.length; i++) {
            Journey journey = (Journey) scene.tasks().get(i);
            assertPlace(row[9], journey.start(), scene);
            assertPlace(goals[i], journey.goal(), scene);
        }
    }

    /** Asserts that a place is where the index has it, in tenths of a centimetre, y down. */
    private static void assertPlace(String expected, Place place, Scene scene) {
        String[] xy = expected.strip().split(" ");
        assertEquals(Double.parseDouble(xy[0]), 100 * place.x(), 0.15);
        assertEquals(Double.parseDouble(xy[1]), 100 * (scene.world().depth() - place.y()), 0.15);
    }

    private static double metres(double[] expected, Place place) {
        return Math.hypot(expected[0] - place.x(), expected[1] - place.y());
    }

    private static String between(String text, String from, String to) {
        return text.substring(text.indexOf(from), text.indexOf(to));
    }

    /** Returns the numbers of each field of a name, in the order of the text. */
    private static List<double[]> fields(String text, String name) {
        return raw(text, name).stream()
                .map(v -> Arrays.stream(v.replaceAll("[\\[\\]\\s]", "").split(","))
                        .mapToDouble(Double::parseDouble)
                        .toArray())
                .toList();
    }

    private static List<String> words(String text, String name) {
        return raw(text, name).stream().map(v -> v.replace("\"", "")).toList();
    }

    private static List<String> raw(String text, String name) {
        List<String> found = new ArrayList<>();
        Matcher matcher = FIELD.matcher(text);
        while (matcher.find()) {
            if (matcher.group(1).equals(name)) {
                found.add(matcher.group(2));
            }
        }
        return found;
    }
}
