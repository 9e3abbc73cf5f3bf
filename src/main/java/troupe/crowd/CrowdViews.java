package troupe.crowd;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import troupe.crowd.flock.Kin;
import troupe.crowd.ground.Ground;
import troupe.grid.field.Nf2;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.run.view.Aspect;
import troupe.run.view.GridOverlays;
import troupe.run.view.Overlay;
import troupe.scene.CrowdGroup;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Shows the ground of a crowd: the views of the grid for agents of one radius, and the potential of NF2 to one goal,
 * for a choice of goal and radius. What a crowd that may split adds to the potential is not in it. Keeps what it has
 * made, as nothing of it changes while the crowd moves. One thread at a time.
 */
final class CrowdViews {
    private final Scene scene;
    private final Ground ground;
    private final List<Target> targets = new ArrayList<>();
    private final Map<Integer, GridOverlays> grids = new TreeMap<>();
    private final Map<Integer, Nf2> fields = new TreeMap<>();
    private final Map<String, List<Overlay>> made = new TreeMap<>();

    /** A goal, the radius of those who go there, and the groups that they are of. */
    private record Target(Place goal, double radius, List<String> groups) {}

    /** Prepares the views; nothing is computed yet. */
    CrowdViews(Scene scene, Kin kin, Ground ground) {
        this.scene = scene;
        this.ground = ground;
        for (Kin.Leaf leaf : kin.leaves()) {
            double radius = leaf.members().radius();
            Target target = targets.stream()
                    .filter(t -> t.goal().equals(leaf.goal()) && t.radius() == radius)
                    .findFirst()
                    .orElse(null);
            if (target == null) {
                target = new Target(leaf.goal(), radius, new ArrayList<>());
                targets.add(target);
            }
            target.groups().add(name(leaf.group()));
        }
    }

    private static String name(CrowdGroup group) {
        return group.label().isEmpty() ? group.id() : group.label();
    }

    /** Returns the choice of a goal, if there is more than one goal or radius. */
    List<Aspect> aspects() {
        if (targets.size() < 2) {
            return List.of();
        }
        return List.of(
                new Aspect("goal", targets.stream().map(CrowdViews::choice).toList(), GridOverlays.KEYS));
    }

    private static Aspect.Choice choice(Target target) {
        String where = String.format(
                Locale.ROOT, "%.1f, %.1f", target.goal().x(), target.goal().y());
        int more = target.groups().size() - 1;
        return Aspect.Choice.of("goal", target.groups().get(0) + (more > 0 ? " +" + more : "") + " (" + where + ")");
    }

    /** Returns the wanted views of a choice. Cost of the first time: that of a region, and of a potential. */
    List<Overlay> overlays(List<Integer> chosen, Predicate<String> wanted) {
        List<Aspect> aspects = aspects();
        int choice = aspects.isEmpty() ? 0 : aspects.get(0).chosen(chosen, 0);
        List<Overlay> all = new ArrayList<>();
        for (String key : GridOverlays.KEYS) {
            if (wanted.test(key)) {
                all.addAll(made.computeIfAbsent(choice + key, none -> make(choice, key)));
            }
        }
        return all;
    }

    private List<Overlay> make(int choice, String key) {
        Target target = targets.get(choice);
        Region region = ground.terrain(target.radius()).region();
        GridOverlays grid = grids.computeIfAbsent(
                choice, none -> new GridOverlays(region, new RegionBuilder(scene, region.actor()).layers()));
        boolean leads = key.equals("skeleton") || key.equals("potential");
        return grid.of(key, leads ? fields.computeIfAbsent(choice, none -> field(region, target.goal())) : null);
    }

    private static Nf2 field(Region region, Place goal) {
        return new Nf2(region).compute(region.locate(goal), Journey.Spread.BREADTH);
    }
}
