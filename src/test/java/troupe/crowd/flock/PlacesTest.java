package troupe.crowd.flock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.crowd.ground.Ground;
import troupe.crowd.ground.Terrain;
import troupe.crowd.ground.Way;
import troupe.geometry.Polygon;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

class PlacesTest {
    private static Way way() {
        CrowdGroup group =
                CrowdGroup.of("all", Place.of(10, 10), CrowdGroup.Members.of(30, Polygon.rectangle(1, 1, 6, 19)));
        Crowd crowd = Crowd.of("crowd", List.of(group));
        Scene scene = new Scene("", new World(20, 20, 0.1), List.of(), List.of(), List.of(), List.of(crowd));
        return new Ground(scene, crowd).way(Place.of(10, 10), 0.2).orElseThrow();
    }

    @Test
    void fillsFromTheGoalOutwardsOnTheSideOfWhoComes() {
        Way way = way();
        Terrain terrain = way.terrain();
        Places places = new Places(way, 0.2, 4);
        assertEquals(way.goal(), places.span(places.next(2, 10)));
        double goalX = terrain.region().x(way.goal());
        double goalY = terrain.region().y(way.goal());
        double last = 0;
        for (int k = 0; k < 40; k++) {
            int p = places.next(goalX - 8, goalY);
            assertTrue(terrain.region().x(places.span(p)) <= goalX, "place " + k);
            double along = goalX - terrain.region().x(places.span(p));
            double depth = along + 0.7 * Math.abs(terrain.region().y(places.span(p)) - goalY);
            assertTrue(depth >= last - 1e-6, depth + " after " + last);
            last = depth;
            places.take(p);
        }
        assertTrue(terrain.region().x(places.span(places.next(18, 10))) >= 9.94);
    }

    @Test
    void placesLieApartAndRunOut() {
        Way way = way();
        Terrain terrain = way.terrain();
        Places places = new Places(way, 0.2, 2);
        List<Integer> given = new ArrayList<>();
        for (int p = places.next(2, 3); p >= 0; p = places.next(2, 3)) {
            places.take(p);
            for (int other : given) {
                double apart = Math.hypot(
                        terrain.region().x(places.span(p)) - terrain.region().x(other),
                        terrain.region().y(places.span(p)) - terrain.region().y(other));
                assertTrue(apart > 2 * 0.2, "places " + apart + " m apart");
            }
            given.add(places.span(p));
        }
        assertTrue(given.size() > 20, given.size() + " places");
    }

    @Test
    void holdsAsMuchGroundAsIsAskedFor() {
        Way way = way();
        double reach = way.holding(12);
        assertTrue(way.around(reach).length * 0.01 >= 12, "ground within " + reach);
        assertTrue(way.around(reach - 0.11).length * 0.01 < 12, "ground within less than " + reach);
        assertEquals(1, way.around(0).length);
    }
}
