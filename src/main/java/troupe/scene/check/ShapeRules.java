package troupe.scene.check;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import troupe.geometry.Box;
import troupe.geometry.Overlap;
import troupe.geometry.Polygon;
import troupe.geometry.SelfIntersection;
import troupe.scene.Numbers;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.check.SceneChecks.Findings;

/** Checks obstacles and ditches: their outlines, heights and overlaps. */
final class ShapeRules {
    /** Overlaps of this many metres or less come from rounding and are not reported. */
    private static final double TOUCH = 1e-6;

    /** An obstacle rests on another if its bottom is that near to the other's top, in metres. */
    private static final double RESTS = 1e-9;

    /** After so many overlaps no more are looked for: the scene is then one heap, and the list is long enough. */
    private static final int MAX_OVERLAPS = 100;

    /** Pairs of edges that are compared before the search for overlaps gives up, about a second's worth. */
    private static final long MAX_EDGE_PAIRS = 20_000_000;

    private ShapeRules() {}

    static void outlines(Scene scene, Findings findings) {
        SelfIntersection.Work work = new SelfIntersection.Work(MAX_EDGE_PAIRS);
        scene.obstacles().forEach(o -> outline(scene.world(), o.id(), o.outline(), work, findings));
        scene.ditches().forEach(d -> outline(scene.world(), d.id(), d.outline(), work, findings));
        if (work.isSpent()) {
            findings.warning(
                    "",
                    "not every outline was checked for meeting itself",
                    "give the outlines fewer corners, or shorter edges");
        }
    }

    private static void outline(
            World world, String id, Polygon outline, SelfIntersection.Work work, Findings findings) {
        if (!isPlaced(outline)) {
            String most = Numbers.text(SceneChecks.LARGEST);
            findings.error(
                    id, "a corner is not a place", "give every corner finite numbers from -" + most + " to " + most);
            return;
        }
        if (outline.size() < 3) {
            findings.error(id, "the polygon has " + outline.size() + " corners", "give it at least 3");
            return;
        }
        SelfIntersection.find(outline, work)
                .ifPresent(edges -> findings.error(
                        id,
                        edges.first() == edges.second()
                                ? "corners " + (edges.first() + 1) + " and the next are the same"
                                : "the outline meets itself: its edges " + (edges.first() + 1) + " and "
                                        + (edges.second() + 1),
                        edges.first() == edges.second() ? "take one of them away" : "move a corner of one of them"));
        if (outline.signedArea() == 0) {
            findings.error(id, "the polygon has no area", "move a corner off the line");
        }
        Box box = outline.bounds();
        if (box.maxX() <= 0 || box.maxY() <= 0 || box.minX() >= world.width() || box.minY() >= world.depth()) {
            findings.error(id, "the polygon lies outside the world", "move it inside, or take it away");
        } else if (box.minX() < -TOUCH
                || box.minY() < -TOUCH
                || box.maxX() > world.width() + TOUCH
                || box.maxY() > world.depth() + TOUCH) {
            findings.warning(
                    id,
                    "the polygon sticks out of the world",
                    "move it inside; what is outside counts as solid anyway");
        }
    }

    private static boolean isPlaced(Polygon outline) {
        for (int i = 0; i < outline.size(); i++) {
            if (!(Math.abs(outline.x(i)) <= SceneChecks.LARGEST && Math.abs(outline.y(i)) <= SceneChecks.LARGEST)) {
                return false;
            }
        }
        return true;
    }

    static void stretches(Scene scene, Findings findings) {
        for (Obstacle obstacle : scene.obstacles()) {
            findings.number(obstacle.id(), "height", obstacle.height(), 0, false);
            findings.number(obstacle.id(), "offset", obstacle.offset(), 0, true);
            findings.number(obstacle.id(), "mass", obstacle.mass(), 0, false);
        }
        scene.ditches().forEach(ditch -> findings.number(ditch.id(), "depth", ditch.depth(), 0, false));
    }

    /** Sweeps over x, so that scenes of thousands of separate obstacles stay cheap; the work is bounded. */
    static void overlaps(Scene scene, Findings findings) {
        List<Obstacle> order = new ArrayList<>(scene.obstacles());
        order.removeIf(o -> !isPlaced(o.outline()) || o.outline().size() < 3);
        order.sort(Comparator.comparingDouble(o -> o.outline().bounds().minX()));
        List<Obstacle> open = new ArrayList<>();
        int found = 0;
        long work = 0;
        for (Obstacle next : order) {
            Box box = next.outline().bounds();
            open.removeIf(o -> o.outline().bounds().maxX() <= box.minX() + TOUCH);
            for (Obstacle other : open) {
                boolean near = boxesShareSpace(other, next);
                work += near ? (long) other.outline().size() * next.outline().size() : 1;
                if (found == MAX_OVERLAPS || work > MAX_EDGE_PAIRS) {
                    findings.warning(
                            next.id(), "overlaps from here on were not looked for", "cure those that are named first");
                    return;
                }
                if (near && Overlap.of(other.outline(), next.outline())) {
                    found++;
                    findings.warning(
                            next.id(),
                            "it fills the same space as '" + other.id() + "'" + stuck(next, other),
                            "move one of them, or leave it if that is meant");
                }
            }
            open.add(next);
        }
    }

    /** Says which of two that overlap is movable and yet cannot be moved. */
    private static String stuck(Obstacle one, Obstacle other) {
        if (one.movable() && other.movable()) {
            return ", so neither can be moved";
        }
        if (one.movable()) {
            return ", so it cannot be moved";
        }
        return other.movable() ? ", so '" + other.id() + "' cannot be moved" : "";
    }

    /**
     * Warns of movable obstacles on which another rests; a carrier is named once, and the work is bounded
     * as that of {@link #overlaps}.
     */
    static void carrying(Scene scene, Findings findings) {
        List<Obstacle> sound = new ArrayList<>(scene.obstacles());
        sound.removeIf(o -> !isPlaced(o.outline()) || o.outline().size() < 3);
        long work = 0;
        for (Obstacle carrier : sound) {
            for (Obstacle load : sound) {
                if (!rests(load, carrier)) {
                    continue;
                }
                work += (long) carrier.outline().size() * load.outline().size();
                if (work > MAX_EDGE_PAIRS) {
                    return;
                }
                if (Overlap.of(carrier.outline(), load.outline())) {
                    findings.warning(
                            carrier.id(),
                            "it carries '" + load.id() + "' and counts as not movable while it does",
                            "take the load off, or leave it if that is meant");
                    break;
                }
            }
        }
    }

    /** Tells whether a load may rest on a movable carrier, as far as heights and boxes tell. */
    private static boolean rests(Obstacle load, Obstacle carrier) {
        return carrier.movable()
                && load != carrier
                && Math.abs(load.offset() - carrier.top()) <= RESTS
                && overlapDeeply(load.outline().bounds(), carrier.outline().bounds());
    }

    private static boolean boxesShareSpace(Obstacle a, Obstacle b) {
        return Math.min(a.top(), b.top()) - Math.max(a.offset(), b.offset()) > TOUCH
                && overlapDeeply(a.outline().bounds(), b.outline().bounds());
    }

    private static boolean overlapDeeply(Box a, Box b) {
        return Math.min(a.maxX(), b.maxX()) - Math.max(a.minX(), b.minX()) > TOUCH
                && Math.min(a.maxY(), b.maxY()) - Math.max(a.minY(), b.minY()) > TOUCH;
    }
}
