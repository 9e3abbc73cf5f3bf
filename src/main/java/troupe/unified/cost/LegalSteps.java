package troupe.unified.cost;

import troupe.grid.region.Region;
import troupe.grid.region.ground.Kind;

/**
 * Decides whether a label may step to a neighbour, and what it carries on: {@code STABLE} and {@code
 * LEGAL} of Unified figure 7, with counters in metres instead of cells. The answer to the last {@link
 * #check} that held is read from the getters; nothing is allocated.
 *
 * <ul>
 *   <li>On a border the metres travelled there may not pass the limit; a stable place sets them back to 0.
 *   <li>A crossing begins at a stable place where one can walk, on exactly its take-off floor.
 *   <li>Inside, the metres travelled since its beginning may not pass the limit of its kind.
 *   <li>It ends at a stable place where one can walk, if a straight crossing leads there from its beginning.
 * </ul>
 */
public final class LegalSteps {
    private static final int NONE = -1;

    private final Region region;
    private final JourneyCosts costs;
    private final int spans;
    private final double straight;
    private final double diagonal;

    private long cost;
    private double used;
    private int begin;

    /** Makes the rules for a region. */
    public LegalSteps(Region region, JourneyCosts costs) {
        this.region = region;
        this.costs = costs;
        spans = region.spanCount();
        straight = region.frame().stepLength(0);
        diagonal = region.frame().stepLength(4);
    }

    /**
     * Tells whether a step to a neighbour is legal.
     *
     * @param from where the label stands
     * @param usedUp the metres it has travelled on unstable places since the last stable one
     * @param begun where its crossing began, or -1 outside of crossings
     * @param to a neighbour of {@code from}
     * @param direction the direction of the step
     */
    public boolean check(int from, double usedUp, int begun, int to, int direction) {
        if (to < spans) {
            return from < spans ? stands(from, usedUp, to, direction) : lands(from, begun, to, direction);
        }
        return from < spans ? takesOff(from, to, direction) : crosses(usedUp, begun, to, direction);
    }

    private boolean stands(int from, double usedUp, int to, int direction) {
        begin = NONE;
        used = region.kind(to) == Kind.BORDER ? usedUp + length(direction) : 0;
        cost = costs.standing(region.abilities(from) & region.abilities(to), direction);
        return cost < JourneyCosts.BLOCKED && used <= costs.limit(Kind.BORDER);
    }

    private boolean takesOff(int from, int to, int direction) {
        byte kind = region.kind(to);
        begin = from;
        used = length(direction);
        cost = costs.crossing(kind, direction) + costs.takeOffUnits(kind);
        return region.takesOff(from)
                && region.elevation(from) == region.elevation(to)
                && cost < JourneyCosts.BLOCKED
                && used <= costs.limit(kind);
    }

    private boolean crosses(double usedUp, int begun, int to, int direction) {
        byte kind = region.kind(to);
        begin = begun;
        used = usedUp + length(direction);
        cost = costs.crossing(kind, direction);
        return cost < JourneyCosts.BLOCKED && used <= costs.limit(kind);
    }

    private boolean lands(int from, int begun, int to, int direction) {
        byte kind = region.kind(from);
        begin = NONE;
        used = 0;
        cost = costs.crossing(kind, direction);
        return region.takesOff(to) && cost < JourneyCosts.BLOCKED && region.straight(begun, to, kind);
    }

    private double length(int direction) {
        return direction < 4 ? straight : diagonal;
    }

    /** Returns the cost in units of the step that was legal. */
    public long cost() {
        return cost;
    }

    /** Returns the metres travelled on unstable places after the step that was legal. */
    public double used() {
        return used;
    }

    /** Returns where the crossing that is under way after the step began, or -1 for none. */
    public int begin() {
        return begin;
    }
}
