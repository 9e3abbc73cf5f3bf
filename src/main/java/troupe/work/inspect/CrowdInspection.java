package troupe.work.inspect;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import troupe.crowd.Beginning;
import troupe.crowd.flock.Kin;
import troupe.crowd.ground.Ground;
import troupe.crowd.ground.Terrain;
import troupe.crowd.ground.Way;
import troupe.geometry.Box;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Looks at where each group of a crowd begins and where it goes: goals at which nobody can stand, spawn outlines in
 * obstacles, without a way or without room; these keep the crowd from beginning. Odd is an outline most of which is
 * barred.
 */
final class CrowdInspection {
    private final Scene scene;
    private final Crowd crowd;
    private final Ground ground;
    private final List<SceneInspection.Fault> faults = new ArrayList<>();
    private final List<SceneInspection.Fault> oddities = new ArrayList<>();
    private final Set<String> told = new HashSet<>();

    private CrowdInspection(Scene scene, Crowd crowd) {
        this.scene = scene;
        this.crowd = crowd;
        this.ground = new Ground(scene, crowd);
    }

    /** What the cells of a spawn outline are like; the first at which nobody can stand, and what is there. */
    private record Outline(int cells, int free, int leading, Optional<Place> barred, Optional<Obstacle> by) {}

    /** Looks at all groups. Cost: that of the ground, of placing everybody, and O(cells of the spawn outlines). */
    static CrowdInspection of(Scene scene, Crowd crowd) {
        CrowdInspection inspection = new CrowdInspection(scene, crowd);
        List<Optional<String>> begin = Beginning.faults(scene, crowd, inspection.ground);
        List<Kin.Leaf> leaves = new Kin(crowd).leaves();
        for (int number = 0; number < leaves.size(); number++) {
            inspection.look(leaves.get(number), begin.get(number));
        }
        return inspection;
    }

    /** Returns what keeps groups from beginning, in document order. */
    List<SceneInspection.Fault> faults() {
        return faults;
    }

    /** Returns what is odd about groups that can begin. */
    List<SceneInspection.Fault> oddities() {
        return oddities;
    }

    private void look(Kin.Leaf leaf, Optional<String> fault) {
        Optional<Way> way = ground.way(leaf.goal(), leaf.members().radius());
        if (way.isEmpty()) {
            goal(leaf);
            return;
        }
        String id = leaf.group().id();
        Outline outline = outline(leaf.members(), way.get());
        if (outline.leading() == 0 && onTop(way.get().terrain(), way.get().goal(), leaf.goal())) {
            goal(leaf);
            return;
        }
        String where = outline.by()
                .map(o -> ": obstacle '" + o.id() + "' is at "
                        + SceneInspection.text(outline.barred().orElseThrow()))
                .orElse("");
        if (outline.cells() > 0 && outline.free() == 0) {
            add(faults, "nobody of '" + id + "' can stand in its spawn outline" + where, "move it into the open");
        } else if (outline.cells() > 0 && outline.leading() == 0) {
            double gap = 2 * leaf.members().radius() + scene.world().cell();
            add(
                    faults,
                    "walls keep the spawn outline of '" + id + "' and its goal " + SceneInspection.text(leaf.goal())
                            + " apart",
                    String.format(Locale.ROOT, "leave a gap of at least %.2f m for them", gap));
        } else if (fault.isPresent()) {
            split(fault.get());
        } else if (outline.free() * 2 < outline.cells() && !where.isEmpty()) {
            add(
                    oddities,
                    "less than half of the spawn outline of '" + id + "' is free" + where,
                    "move it into the open, or leave it if that is meant");
        }
    }

    private void goal(Kin.Leaf leaf) {
        Place goal = leaf.goal();
        Optional<Obstacle> around = holding(goal.x(), goal.y(), goal.z().orElse(0));
        if (around.isPresent()) {
            add(
                    faults,
                    "the goal " + SceneInspection.text(goal) + " of '"
                            + leaf.group().id() + "' is inside obstacle '"
                            + around.get().id() + "'",
                    "move the goal into the open");
        } else {
            split(Ground.unreachable(leaf.group().id(), goal, leaf.members().radius()));
        }
    }

    /** Takes a fault as the planner says it: what, a semicolon, and the cure. */
    private void split(String fault) {
        String[] parts = fault.split("; ", 2);
        add(faults, parts[0], parts.length > 1 ? parts[1] : "");
    }

    private void add(List<SceneInspection.Fault> to, String message, String cure) {
        if (told.add(message)) {
            to.add(new SceneInspection.Fault(message, cure));
        }
    }

    private Outline outline(CrowdGroup.Members members, Way way) {
        Terrain terrain = way.terrain();
        Box box = members.spawn().bounds();
        double cell = scene.world().cell();
        int cells = 0;
        int free = 0;
        int leading = 0;
        Place barred = null;
        Obstacle by = null;
        for (double y = box.minY() + cell / 2; y < box.maxY(); y += cell) {
            for (double x = box.minX() + cell / 2; x < box.maxX(); x += cell) {
                if (!members.spawn().contains(x, y)) {
                    continue;
                }
                cells++;
                int q = terrain.stand(new Place(x, y, members.floor()));
                boolean leads = q >= 0 && way.reaches(q);
                boolean stands = leads || q >= 0 && !onTop(terrain, q, new Place(x, y, members.floor()));
                free += stands ? 1 : 0;
                leading += leads ? 1 : 0;
                if (!stands && by == null) {
                    by = holding(x, y, members.floor().orElse(0)).orElse(null);
                    barred = by == null ? barred : Place.of(rounded(x), rounded(y));
                }
            }
        }
        return new Outline(cells, free, leading, Optional.ofNullable(barred), Optional.ofNullable(by));
    }

    /** Tells whether a place without elevation came to lie on top of an obstacle, for want of a floor below. */
    private boolean onTop(Terrain terrain, int span, Place place) {
        return place.z().isEmpty()
                && terrain.elevation(span) > crowd.manner().stepHeight()
                && holding(place.x(), place.y(), 0).isPresent();
    }

    private static double rounded(double metres) {
        return Math.rint(metres * 100) / 100;
    }

    /** Finds the first obstacle over a place that reaches into the stretch of a body on a floor. */
    private Optional<Obstacle> holding(double x, double y, double floor) {
        return scene.obstacles().stream()
                .filter(o -> o.offset() < floor + crowd.manner().bodyHeight()
                        && o.top() > floor + crowd.manner().stepHeight())
                .filter(o -> o.outline().contains(x, y))
                .findFirst();
    }
}
