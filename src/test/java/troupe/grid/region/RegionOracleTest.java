package troupe.grid.region;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/** Compares spans, bodies, feet and clearance with {@link SlowRegion} at every span of random layered scenes. */
class RegionOracleTest {
    private static final int SCENES = 240;
    private static final double BAND = 1e-9;

    @Test
    void everySpanAgreesWithTheDefinition() {
        int[] seen = new int[6];
        for (long seed = 1; seed <= SCENES; seed++) {
            Scene scene = RandomScenes.layered(seed, 5, seed % 3 == 0 ? 0.25 : 0.16);
            Actor actor = RandomScenes.actor(seed);
            compare("seed " + seed, scene, actor, seen);
        }
        for (byte kind : new byte[] {Kind.ABSENT, Kind.STABLE, Kind.BORDER, Kind.FORBIDDEN}) {
            assertTrue(seen[kind] > 1000, "the scenes hold too few places of kind " + Kind.word(kind));
        }
    }

    private static void compare(String seed, Scene scene, Actor actor, int[] seen) {
        Region region = Region.of(scene, actor);
        SlowRegion slow = new SlowRegion(scene, actor);
        GridFrame frame = region.frame();
        for (int cell = 0; cell < frame.size(); cell++) {
            double x = frame.centreX(frame.col(cell));
            double y = frame.centreY(frame.row(cell));
            List<SlowRegion.Stretch> spans = slow.spans(x, y);
            assertTrue(spans.size() <= region.spans().sheets(), seed);
            for (int sheet = 0; sheet < region.spans().sheets(); sheet++) {
                int q = sheet * frame.size() + cell;
                String place = seed + " at " + x + "," + y + " sheet " + sheet;
                seen[region.kind(q)]++;
                assertEquals(sheet < spans.size(), region.spans().exists(q), place);
                if (sheet >= spans.size()) {
                    assertEquals(Kind.ABSENT, region.kind(q), place);
                    continue;
                }
                assertEquals(spans.get(sheet).floor(), region.elevation(q), 1e-9, place);
                assertEquals(spans.get(sheet).ceiling(), region.spans().ceiling(q), place);
                bodies(place, region, slow, q, x, y);
                if (region.open(q)) {
                    foot(place, region, slow, q, x, y);
                }
                clearance(place, region, slow, q, x, y);
            }
        }
    }

    private static void bodies(String place, Region region, SlowRegion slow, int q, double x, double y) {
        Actor actor = region.actor();
        double floor = region.elevation(q);
        double cell = region.frame().cell();
        boolean tall = region.spans().ceiling(q) - floor >= actor.bodyHeight() - BAND;
        double distance = slow.clearanceOfObstacles(x, y, floor);
        boolean dropped = slow.overDrop(x, y, floor, actor.footRadius() * 1.15);
        for (Ability ability : List.of(Ability.WALK, Ability.SIDESTEP)) {
            if (!actor.abilities().contains(ability)) {
                continue;
            }
            double radius = ability == Ability.WALK
                    ? actor.walk().radius()
                    : actor.sidestep().get().radius();
            boolean usable = (region.abilities(q) & ability.bit()) != 0;
            boolean touched = radius < 0.71 * cell && slow.touched(x, y, cell / 2, floor);
            if (Math.abs(distance - radius) < BAND) {
                continue;
            }
            if (!tall || distance < radius || touched || slow.groundWithin(x, y, floor, radius)) {
                assertFalse(usable, place + ": " + ability + " at clearance " + distance + " of " + radius);
            } else if (!dropped && !slow.groundWithin(x, y, floor, Math.max(1.15 * radius, cell))) {
                assertTrue(usable, place + ": " + ability + " at clearance " + distance + " of " + radius);
            }
        }
    }

    private static void foot(String place, Region region, SlowRegion slow, int q, double x, double y) {
        double floor = region.elevation(q);
        double radius = region.actor().footRadius();
        assertFalse(slow.overDrop(x, y, floor, radius), place + ": open over a drop");
        boolean border = region.kind(q) == Kind.BORDER;
        if (slow.onEdge(x, y, floor, radius)) {
            assertTrue(border, place + ": stable on an edge");
        } else if (!slow.onEdge(x, y, floor, 1.15 * radius + 1e-6)) {
            assertFalse(border, place + ": border without an edge");
        }
    }

    private static void clearance(String place, Region region, SlowRegion slow, int q, double x, double y) {
        double floor = region.elevation(q);
        double exact = slow.clearanceOfObstacles(x, y, floor);
        double clearance = region.clearance(q);
        double cell = region.frame().cell();
        double near = region.actor().walk().radius() + 2 * cell;
        boolean inDitch = floor < -region.actor().stepHeight() - BAND;
        if (inDitch) {
            assertTrue(clearance <= exact + 0.71 * cell + 1e-6, place);
        } else {
            assertEquals(exact, clearance, exact < near ? 1e-5 : 0.71 * cell + 1e-5, place);
        }
    }

    @Test
    void noStepPassesThroughAWallHoweverThinAndWhateverTheRadius() {
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        int steps = 0;
        for (long seed = 1; seed <= 60; seed++) {
            java.util.Random random = new java.util.Random(seed);
            List<Obstacle> walls = new java.util.ArrayList<>();
            for (int i = 0; i < 12; i++) {
                walls.add(thinWall(i, random));
            }
            Scene scene = new Scene("", new troupe.scene.World(4, 4, 0.2), walls, List.of(), List.of(), List.of());
            double radius = seed % 3 == 0 ? 0 : 0.2 * random.nextDouble();
            Region region = Region.of(scene, Actor.walker("w", radius, 0));
            for (int q = 0; q < region.spanCount(); q++) {
                if (!region.open(q) || region.elevation(q) != 0) {
                    continue;
                }
                int n = region.neighbours(q, targets, directions);
                for (int i = 0; i < n; i++) {
                    steps++;
                    String step = "seed " + seed + ": from " + region.x(q) + "," + region.y(q) + " direction "
                            + directions[i];
                    for (Obstacle wall : walls) {
                        assertFalse(passes(wall.outline(), region, q, targets[i]), step + " through " + wall.id());
                    }
                }
            }
        }
        assertTrue(steps > 10_000);
    }

    private static Obstacle thinWall(int i, java.util.Random random) {
        double x = 4 * random.nextDouble();
        double y = 4 * random.nextDouble();
        double dx = 3 * random.nextDouble() - 1.5;
        double dy = i % 3 == 0 ? 0 : 3 * random.nextDouble() - 1.5;
        double thin = 1e-4 / Math.hypot(dx, dy);
        Polygon outline =
                Polygon.of(x, y, x + dx, y + dy, x + dx - thin * dy, y + dy + thin * dx, x - thin * dy, y + thin * dx);
        return new Obstacle("w" + i, "", outline, 0, 3, false, 20, "");
    }

    /** Tells whether the segment between two places holds a point of the polygon's inside, by sampling both ways. */
    private static boolean passes(Polygon outline, Region region, int from, int to) {
        double ax = region.x(from);
        double ay = region.y(from);
        double bx = region.x(to);
        double by = region.y(to);
        for (int i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
            double a = side(ax, ay, bx, by, outline.x(j), outline.y(j));
            double b = side(ax, ay, bx, by, outline.x(i), outline.y(i));
            double c = side(outline.x(j), outline.y(j), outline.x(i), outline.y(i), ax, ay);
            double d = side(outline.x(j), outline.y(j), outline.x(i), outline.y(i), bx, by);
            if (a * b < 0 && c * d < 0) {
                return true;
            }
        }
        return outline.contains((ax + bx) / 2, (ay + by) / 2);
    }

    private static double side(double ax, double ay, double bx, double by, double px, double py) {
        return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
    }
}
