package troupe.unified.cost;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.region.Region;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.search.JourneyWorkspace;
import troupe.unified.search.SlowJourney;
import troupe.unified.search.SmallWorlds;

/** Compares the cost to go with a plain search over the region without limits, settled or not. */
class CostToGoTest {
    private static final long FIRST_SEED = Long.getLong("troupe.seed", 1);

    @Test
    void settledPlacesAreExactAndOthersBoundedFromBelowAtEveryMoment() {
        int checked = 0;
        for (long seed = FIRST_SEED; seed < FIRST_SEED + 150; seed++) {
            Actor actor = SmallWorlds.actor(seed, true, true, true);
            Region region = Region.of(SmallWorlds.scene(seed), actor);
            Preferences preferences = SmallWorlds.preferences(seed);
            int goal = openPlace(region, seed);
            int start = openPlace(region, seed + 1);
            if (goal < 0 || start < 0) {
                continue;
            }
            JourneyCosts costs = new JourneyCosts(actor, preferences, 0.25);
            JourneyWorkspace work = new JourneyWorkspace(region);
            CostToGo toGo = new CostToGo(new FieldMemory(region, false), costs, start, CostToGo.Ends.at(goal));
            SlowJourney reference = new SlowJourney(region, preferences, true);
            toGo.want(start, CostToGo.UNREACHABLE);
            while (!toGo.hasAnswered()) {
                toGo.advance(25);
                checked += check(region, costs, toGo, reference, goal, seed);
            }
            toGo.want(openPlace(region, seed + 2), CostToGo.UNREACHABLE);
            toGo.advance(Long.MAX_VALUE);
            checked += check(region, costs, toGo, reference, goal, seed);
        }
        assertTrue(checked > 500, "checked " + checked);
    }

    private static int check(
            Region region, JourneyCosts costs, CostToGo toGo, SlowJourney reference, int goal, long seed) {
        int checked = 0;
        for (int q = 0; q < region.spanCount(); q += 17) {
            if (region.open(q)) {
                OptionalDouble least = reference.leastCost(q, goal);
                String name = "seed " + seed + ", configuration " + q;
                if (least.isEmpty()) {
                    assertTrue(!toGo.isSettled(q) || toGo.bound(q) == CostToGo.UNREACHABLE, name);
                } else if (toGo.isSettled(q)) {
                    assertEquals(least.getAsDouble(), costs.joules(toGo.bound(q)), 1e-8, name);
                    checked++;
                } else {
                    assertTrue(costs.joules(toGo.bound(q)) <= least.getAsDouble() + 1e-8, name);
                }
            }
        }
        return checked;
    }

    @Test
    void aStartBehindAClosedWallIsKnownToBeUnreachable() {
        Polygon outline = Polygon.rectangle(1.5, 0, 1.75, 2);
        Obstacle wall = new Obstacle("wall", "", outline, 0, 3, false, Obstacle.DEFAULT_MASS, "");
        Actor actor = Actor.walker("a", 0.2, 0.1);
        World world = new World(3, 2, 0.25);
        Region region = Region.of(new Scene("", world, List.of(wall), List.of(), List.of(), List.of()), actor);
        int start = region.locate(Place.of(0.6, 1));
        int goal = region.locate(Place.of(2.6, 1));
        JourneyCosts costs = new JourneyCosts(actor, Preferences.NEUTRAL, 0.25);
        JourneyWorkspace work = new JourneyWorkspace(region);
        CostToGo toGo = new CostToGo(new FieldMemory(region, false), costs, start, CostToGo.Ends.at(goal));
        toGo.want(start, CostToGo.UNREACHABLE);
        assertFalse(toGo.hasAnswered());
        toGo.advance(Long.MAX_VALUE);
        assertTrue(toGo.hasAnswered());
        assertEquals(CostToGo.UNREACHABLE, toGo.bound(start));
        assertEquals(0, toGo.bound(goal));
    }

    /** Returns some place where the actor can stand, -1 if there is none. */
    private static int openPlace(Region region, long seed) {
        for (int i = 0; i < region.spanCount(); i++) {
            int q = (int) ((seed * 7919 + i) % region.spanCount());
            if (region.open(q)) {
                return q;
            }
        }
        return -1;
    }
}
