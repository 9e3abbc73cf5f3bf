package troupe.unified.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.geometry.Line;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Obstacle;
import troupe.unified.body.SweptBody;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.search.JourneyPath;

/**
 * Makes of a way over one search space the stretches that an actor travels: consecutive steps of one ability
 * are one smoothed stretch, each crossing is a stretch of its own, straight between the two standing
 * configurations.
 */
final class WayBuilder {
    private final JourneyPath.Way way;
    private final Region region;
    private final JourneyCosts costs;
    private final SweptBody body;

    /** Prepares the stretches of a way; {@code body} knows where everything stands in its search space. */
    WayBuilder(JourneyPath.Way way, JourneyCosts costs, SweptBody body) {
        this.way = way;
        this.region = way.region();
        this.costs = costs;
        this.body = body;
    }

    /** Returns the stretches; without a step none, or if {@code always} one of a single point. */
    List<Stretch> stretches(boolean always) {
        int[] all = way.configurations();
        List<Ability> abilities = way.abilities();
        List<Stretch> route = new ArrayList<>();
        if (all.length == 1 && always) {
            route.add(standing(all, Ability.WALK));
        }
        int begin = 0;
        for (int i = 1; i < all.length; i++) {
            boolean ends = i == all.length - 1
                    || abilities.get(i) != abilities.get(i - 1)
                    || isCrossing(all[i - 1]) && !isCrossing(all[i])
                    || !isCrossing(all[i]) && isCrossing(all[i + 1]);
            if (ends) {
                int[] part = Arrays.copyOfRange(all, begin, i + 1);
                Ability ability = abilities.get(i - 1);
                route.add(isCrossing(part[1]) ? crossing(part, ability) : standing(part, ability));
                begin = i;
            }
        }
        return route;
    }

    private boolean isCrossing(int q) {
        byte kind = region.kind(q);
        return kind == Kind.GAP || kind == Kind.JUMPABLE;
    }

    private Stretch standing(int[] part, Ability ability) {
        return new Stretch(
                ability, "", metres(part) * costs.energy(ability), new Smoothing(region, body).smoothed(part, ability));
    }

    private Stretch crossing(int[] part, Ability ability) {
        int begin = part[0];
        int end = part[part.length - 1];
        Line line = new Line(region.x(begin), region.y(begin), region.x(end), region.y(end));
        double from = region.elevation(begin);
        double to = region.elevation(end);
        CrossingArc arc = new CrossingArc(body, region.actor());
        double energy = metres(part) * costs.energy(ability) + costs.takeOff(ability);
        if (ability == Ability.STRIDE) {
            return new Stretch(ability, "", energy, arc.stride(line, from, to));
        }
        double most = from + region.actor().vault().orElseThrow().maxHeight() + SweptBody.SLACK;
        // what cannot be vaulted is no nearer to either end of a step, but may be so to its middle
        List<Obstacle> over =
                body.inTheWay(line, from).stream().filter(o -> o.top() <= most).toList();
        return new Stretch(ability, vaulted(line, over), energy, arc.vault(line, from, to, over));
    }

    /** Returns the id of the highest obstacle under the line, or of the highest beside it, empty if there is none. */
    private static String vaulted(Line line, List<Obstacle> over) {
        return over.stream()
                .filter(o -> line.crosses(o.outline()))
                .findFirst()
                .or(() -> over.stream().findFirst())
                .map(Obstacle::id)
                .orElse("");
    }

    /** Returns the metres along the grid; straight and diagonal steps are counted, so that sums do not drift. */
    private double metres(int[] part) {
        GridFrame frame = region.frame();
        int diagonal = 0;
        for (int i = 1; i < part.length; i++) {
            int a = region.cell(part[i - 1]);
            int b = region.cell(part[i]);
            diagonal += frame.col(a) != frame.col(b) && frame.row(a) != frame.row(b) ? 1 : 0;
        }
        return (part.length - 1 - diagonal + diagonal * Math.sqrt(2)) * frame.cell();
    }
}
