package troupe.unified.search;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.region.Region;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Ordering;
import troupe.scene.Place;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.search.Outcome;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.cost.JourneyQuery;

class JourneySearchTest {
    private static final double CELL = 0.5;

    private static Obstacle wall(String id, double x0, double y0, double x1, double y1) {
        return new Obstacle(id, "", Polygon.rectangle(x0, y0, x1, y1), 0, 3, false, Obstacle.DEFAULT_MASS, "");
    }

    private static Region region(Actor actor, Obstacle... obstacles) {
        World world = new World(10, 8, CELL);
        return Region.of(new Scene("", world, List.of(obstacles), List.of(), List.of(actor), List.of()), actor);
    }

    private static Region walkedRegion() {
        return region(Actor.walker("a", 0.25, 0.1), wall("upright", 4, 0, 4.5, 6), wall("across", 6, 3, 10, 3.5));
    }

    private static JourneySearch search(Region region, Ordering ordering, Preferences preferences, long limit) {
        int start = region.locate(Place.of(1.25, 1.25));
        int goal = region.locate(Place.of(8.25, 1.25));
        JourneyCosts costs = new JourneyCosts(region.actor(), preferences, CELL);
        JourneyQuery query = new JourneyQuery(start, goal, ordering, JourneyQuery.Potential.NONE, limit);
        return new JourneySearch(new JourneyWorkspace(region), costs, query);
    }

    private static JourneySearch search(Region region) {
        return search(region, Ordering.OPTIMAL, Preferences.NEUTRAL, Long.MAX_VALUE);
    }

    @Test
    void walksStraightOnOpenGroundAndExpandsOnlyTheWay() {
        JourneySearch search = search(region(Actor.walker("a", 0.25, 0.1)));
        assertTrue(search.step(Long.MAX_VALUE).isFound());
        JourneyPath path = search.path().orElseThrow();
        assertEquals(14, Ways.steps(path));
        assertEquals(7.0, path.length(), 1e-12);
        assertEquals(7.0, path.cost(), 1e-12);
        assertEquals(7.0, path.energy(), 1e-12);
        assertEquals(0, path.takeOffs());
        assertTrue(path.abilities().stream().allMatch(a -> a == Ability.WALK));
        assertEquals(15, search.expanded());
    }

    @Test
    void walksAroundWallsWithoutCuttingTheirCorners() {
        JourneySearch search = search(walkedRegion());
        search.step(Long.MAX_VALUE);
        JourneyPath path = search.path().orElseThrow();
        // up to the wall's end 5 + 5, over it 2 + 0, down to the other's 5 + 2, to the goal 2 + 3 steps
        assertEquals(CELL * (14 + 10 * Math.sqrt(2)), path.length(), 1e-12);
        assertEquals(24, Ways.steps(path));
        Region region = walkedRegion();
        for (int i = 0; i < Ways.steps(path); i++) {
            int from = Ways.configurations(path)[i];
            int to = Ways.configurations(path)[i + 1];
            assertTrue(region.open(to));
            assertTrue(Math.abs(region.x(to) - region.x(from)) < CELL + 1e-9);
            assertTrue(Math.abs(region.y(to) - region.y(from)) < CELL + 1e-9);
        }
    }

    @Test
    void slicedInAnyWayFindsTheSameAfterTheSameWork() {
        int[] whole = null;
        for (Ordering ordering : List.of(Ordering.OPTIMAL, new Ordering.Bounded(1.5), new Ordering.Paper(1, 1))) {
            long expanded = -1;
            for (long budget : new long[] {Long.MAX_VALUE, 1, 7}) {
                JourneySearch search = search(walkedRegion(), ordering, Preferences.NEUTRAL, Long.MAX_VALUE);
                while (search.step(budget).isRunning()) {
                    assertTrue(search.path().isEmpty());
                }
                int[] way = Ways.configurations(search.path().orElseThrow());
                if (expanded < 0) {
                    whole = way;
                    expanded = search.expanded() + search.estimated();
                }
                assertArrayEquals(whole, way);
                assertEquals(expanded, search.expanded() + search.estimated());
            }
        }
    }

    @Test
    void interleavedSearchesEqualEachAlone() {
        JourneySearch one = search(walkedRegion());
        JourneySearch other = search(walkedRegion(), new Ordering.Paper(0, 1), Preferences.NEUTRAL, Long.MAX_VALUE);
        while (one.step(3).isRunning() | other.step(2).isRunning()) {
            assertTrue(one.expanded() <= one.generated());
        }
        JourneySearch alone = search(walkedRegion());
        alone.step(Long.MAX_VALUE);
        assertArrayEquals(
                Ways.configurations(alone.path().orElseThrow()),
                Ways.configurations(one.path().orElseThrow()));
        assertEquals(one.path().orElseThrow().cost(), other.path().orElseThrow().cost(), 1e-9);
    }

    @Test
    void runsOutOfItsLimitInsteadOfSayingThereIsNoWay() {
        JourneySearch search = search(walkedRegion(), Ordering.OPTIMAL, Preferences.NEUTRAL, 5);
        assertSame(Outcome.EXHAUSTED, search.step(Long.MAX_VALUE));
        assertEquals(5, search.expanded());
        assertTrue(search.path().isEmpty());
    }

    @Test
    void saysThatThereIsNoWayThroughAClosedWall() {
        Region region = region(Actor.walker("a", 0.25, 0.1), wall("closed", 4, 0, 4.5, 8));
        for (Ordering ordering : List.of(Ordering.OPTIMAL, new Ordering.Bounded(2), new Ordering.Paper(1, 1))) {
            JourneySearch search = search(region, ordering, Preferences.NEUTRAL, Long.MAX_VALUE);
            assertInstanceOf(Outcome.Infeasible.class, search.step(Long.MAX_VALUE));
            assertTrue(search.path().isEmpty());
        }
    }

    @Test
    void takesTheCheaperOfWalkingAndSidesteppingWhereBothFit() {
        Region region = region(Actor.standard("a"));
        JourneySearch walks = search(region);
        walks.step(Long.MAX_VALUE);
        assertSame(Ability.WALK, walks.path().orElseThrow().abilities().get(0));
        JourneySearch sidesteps =
                search(region, Ordering.OPTIMAL, Preferences.NEUTRAL.with(Ability.WALK, 5), Long.MAX_VALUE);
        sidesteps.step(Long.MAX_VALUE);
        JourneyPath path = sidesteps.path().orElseThrow();
        assertTrue(path.abilities().stream().allMatch(a -> a == Ability.SIDESTEP));
        assertEquals(14.0, path.cost(), 1e-9);
        assertEquals(14.0, path.energyByAbility()[Ability.SIDESTEP.ordinal()], 1e-9);
    }

    @Test
    void cancelsForGood() {
        JourneySearch search = search(walkedRegion());
        search.step(3);
        search.cancel();
        assertSame(Outcome.CANCELLED, search.step(100));
    }

    @Test
    void refusesAWorkspaceThatAnotherSearchHasTakenOver() {
        Region region = walkedRegion();
        JourneyWorkspace work = new JourneyWorkspace(region);
        JourneyCosts costs = new JourneyCosts(region.actor(), Preferences.NEUTRAL, CELL);
        int start = region.locate(Place.of(1.25, 1.25));
        JourneySearch old = new JourneySearch(work, costs, JourneyQuery.optimal(start, start));
        new JourneySearch(work, costs, JourneyQuery.optimal(start, start));
        assertThrows(IllegalStateException.class, () -> old.step(1));
    }

    @Test
    void refusesPlacesWhereTheActorCannotStand() {
        Region region = walkedRegion();
        JourneyWorkspace work = new JourneyWorkspace(region);
        JourneyCosts costs = new JourneyCosts(region.actor(), Preferences.NEUTRAL, CELL);
        String message = assertThrows(
                        IllegalArgumentException.class,
                        () -> new JourneySearch(work, costs, JourneyQuery.optimal(-1, 0)))
                .getMessage();
        assertTrue(message.startsWith("start=-1"), message);
    }
}
