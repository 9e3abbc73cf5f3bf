package troupe.unified.search;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Optional;
import troupe.grid.region.Region;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.unified.cost.Descent;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.manipulation.ExpectedPath;
import troupe.unified.obstacle.Movable;

/**
 * Finds the way that an actor expects to go once an obstacle is out of it (Unified section 6.3): down a
 * field from a trigger point. With the cost to go it leads to the goal, so that the obstacle is not put
 * down farther along the same way; in the published order it ends at the first place after the obstacle that
 * is open in the search space. Places are configurations of the guiding region; each has the radius of the
 * ability with which the field goes on from it.
 */
final class ExpectedPaths {
    private static final int UNKNOWN = -2;
    private static final byte MEETS = 1;
    private static final byte MISSES = 2;
    private static final int WALK = Ability.WALK.bit();

    private final Region guide;
    private final Descent descent;
    private final JourneyCosts costs;
    private final boolean published;
    private final int[] next;

    /** For each movable, whether the path from each place is known to meet it or to miss it. */
    private final byte[][] meeting;

    private int[] places = new int[256];
    private int length;

    ExpectedPaths(Region guide, Descent descent, JourneyCosts costs, boolean published, int movables) {
        this.guide = guide;
        this.descent = descent;
        this.costs = costs;
        this.published = published;
        this.next = new int[guide.size()];
        Arrays.fill(next, UNKNOWN);
        this.meeting = new byte[movables][];
    }

    /** Returns the next place; places below an exact one are exact, so what is known stays so. */
    private int next(int place) {
        if (next[place] == UNKNOWN) {
            next[place] = descent.next(place);
        }
        return next[place];
    }

    /** Tells whether the path from one trigger point can be different in different search spaces. */
    boolean dependOnSpace() {
        return published;
    }

    /** Returns the cell of a place. */
    int cell(int place) {
        return guide.cell(place);
    }

    /** Tells whether the goal can be reached from a place at all. */
    boolean leads(int place) {
        return descent.rank(place) < Long.MAX_VALUE;
    }

    /** Returns a number that orders places as the field does. */
    long rank(int place) {
        return descent.rank(place);
    }

    /**
     * Returns the first place on the way from {@code trigger} at which the actor would collide with an
     * obstacle that stands where the scene shows it, -1 if it never would.
     */
    int entry(int trigger, Movable movable) {
        for (int place = trigger; place >= 0; place = next(place)) {
            if (collides(place, movable)) {
                return place;
            }
        }
        return Descent.NONE;
    }

    /**
     * Tells whether the path from a place ever collides with an obstacle that stands where the scene shows it. The
     * place must be exact. What is found out is kept for every place on the path.
     *
     * @param m the place of the obstacle in the list of movables
     */
    boolean meets(int trigger, int m, Movable movable) {
        if (meeting[m] == null) {
            meeting[m] = new byte[guide.size()];
        }
        byte[] known = meeting[m];
        int place = trigger;
        while (place >= 0 && known[place] == 0 && !collides(place, movable)) {
            place = next(place);
        }
        boolean met = place >= 0 && known[place] != MISSES;
        for (int passed = trigger; passed >= 0 && known[passed] == 0; passed = next(passed)) {
            known[passed] = met ? MEETS : MISSES;
            if (passed == place) {
                break;
            }
        }
        return met;
    }

    private boolean collides(int place, Movable movable) {
        int cell = guide.cell(place);
        return movable.meets(guide.elevation(place), guide.actor().bodyHeight())
                && movable.isNear(
                        0, 0, 0, guide.frame().col(cell), guide.frame().row(cell), radius(place));
    }

    /** Returns the expected path from a trigger past an obstacle; empty if it never collides with it. */
    Optional<ExpectedPath> from(SearchSpace space, int trigger, Movable movable) {
        int count = 0;
        boolean collided = false;
        for (int place = trigger; place >= 0; place = next(place)) {
            if (count == places.length) {
                places = Arrays.copyOf(places, 2 * count);
            }
            places[count++] = place;
            boolean collides = (published || !collided) && collides(place, movable);
            if (published && collided && !collides && isOpen(space.region(), place)) {
                break;
            }
            collided |= collides;
        }
        length = count;
        return collided ? Optional.of(path(count)) : Optional.empty();
    }

    /** Returns the spans on the path that was found last. */
    BitSet places() {
        BitSet spans = new BitSet();
        for (int i = 0; i < length; i++) {
            if (places[i] < guide.spanCount()) {
                spans.set(places[i]);
            }
        }
        return spans;
    }

    /** Tells whether a place of the guiding region is open in a space. */
    private boolean isOpen(Region region, int place) {
        if (place < guide.spanCount()) {
            return region.open(place);
        }
        return region.crossing(guide.cell(place), guide.level(place), guide.kind(place)) >= 0;
    }

    private ExpectedPath path(int count) {
        int[] cells = new int[count];
        double[] floors = new double[count];
        double[] radii = new double[count];
        for (int i = 0; i < count; i++) {
            cells[i] = guide.cell(places[i]);
            floors[i] = guide.elevation(places[i]);
            radii[i] = radius(places[i]);
        }
        if (!published && count > 1) {
            radii[count - 1] = radii[count - 2];
        }
        return new ExpectedPath(guide.frame(), guide.actor().bodyHeight(), cells, floors, radii);
    }

    /** Returns the radius in metres of the ability with which the way goes on from a place. */
    private double radius(int place) {
        Actor actor = guide.actor();
        boolean walks;
        if (published) {
            walks = place >= guide.spanCount() || (guide.abilities(place) & WALK) != 0;
        } else {
            int to = next(place);
            byte kind = guide.kind(to >= guide.spanCount() ? to : place);
            walks = to < 0
                    ? (guide.abilities(place) & WALK) != 0
                    : kind == Kind.GAP
                            || kind == Kind.JUMPABLE
                            || costs.ability(kind, guide.abilities(place) & guide.abilities(to)) == Ability.WALK;
        }
        return walks ? actor.walk().radius() : actor.sidestep().orElseThrow().radius();
    }
}
