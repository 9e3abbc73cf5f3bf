package troupe.grid.region;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.layer.Layers;
import troupe.grid.region.ground.Kind;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

class LayeredRegionTest {
    private static final Actor ACTOR = Actor.standard("a");

    private static Obstacle block(
            String id, double minX, double minY, double maxX, double maxY, double offset, double height) {
        return new Obstacle(id, "", Polygon.rectangle(minX, minY, maxX, maxY), offset, height, false, 20, "");
    }

    private static Scene bridge() {
        List<Obstacle> parts = new ArrayList<>();
        for (int i = 0; i < 11; i++) {
            parts.add(block("s" + i, 0.5 + i * 0.3, 2, 0.8 + i * 0.3, 3.5, 0, 0.2 * (i + 1)));
        }
        parts.add(block("deck", 3.8, 2, 8, 3.5, 2.0, 0.2));
        return new Scene("", new World(9, 6, 0.1), parts, List.of(), List.of(), List.of());
    }

    @Test
    void bridgeHasSpansOverAndUnderItsDeck() {
        Region region = Region.of(bridge(), ACTOR);
        assertEquals(2, region.spans().sheets());
        int under = region.locate(Place.of(6, 2.5));
        int over = region.locate(Place.of(6, 2.5, 2));
        assertEquals(0, region.elevation(under));
        assertEquals(2.2, region.elevation(over), 1e-12);
        assertTrue(region.open(under));
        assertTrue(region.open(over));
        assertEquals(Kind.BORDER, region.kind(region.locate(Place.of(1.15, 2.75))), "the foot holds a stair's edge");
        assertEquals(Kind.STABLE, region.kind(region.locate(Place.of(1.25, 2.75))));
    }

    @Test
    void deckAndStairsAreOneLayerWithTheGroundExceptUnderTheDeck() {
        RegionBuilder builder = new RegionBuilder(bridge(), ACTOR);
        Layers layers = builder.layers();
        Region region = builder.region();
        assertEquals(0, layers.layer(region.locate(Place.of(0.25, 0.25))));
        assertEquals(0, layers.lowest(0));
        int under = layers.layer(region.locate(Place.of(6, 2.75)));
        int over = layers.layer(region.locate(Place.of(6, 2.75, 2)));
        assertTrue(under != over);
        assertEquals(2.2, layers.highest(over), 1e-12);
    }

    @Test
    void stairsLeadOntoTheOtherSheetOfTheDeck() {
        Region region = Region.of(bridge(), ACTOR);
        int top = region.locate(Place.of(3.75, 2.75));
        assertEquals(2.2, region.elevation(top), 1e-12);
        assertFalse(region.plain(top));
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        int n = region.neighbours(top, targets, directions);
        assertEquals(8, n);
        assertEquals(region.locate(Place.of(3.85, 2.75, 2)), targets[0]);
        Reach reach = Reach.from(region, region.locate(Place.of(0.25, 5)));
        assertTrue(reach.reached(region.locate(Place.of(7, 2.75, 2))));
        assertTrue(reach.reached(region.locate(Place.of(7, 2.75))));
    }

    @Test
    void tableTopCarriesAndStandsInTheWayOfWhoIsBeside() {
        Scene scene = new Scene(
                "",
                new World(4, 4, 0.1),
                List.of(block("t", 1, 1, 3, 3, 0.7, 0.05)),
                List.of(new Ditch("d", "", Polygon.rectangle(1.5, 1.5, 2.5, 2.5), 1.2)),
                List.of(),
                List.of());
        Region region = Region.of(scene, ACTOR.without(java.util.Set.of(troupe.scene.Ability.VAULT)));
        assertEquals(0.75, region.elevation(region.locate(Place.of(1.25, 1.25))), "0.7 m under the table hold no one");
        assertEquals(-1.2, region.elevation(region.locate(Place.of(2, 2))), "the ditch under the table does");
        assertTrue(region.open(region.locate(Place.of(2.05, 2.05))));
        assertFalse(region.open(region.locate(Place.of(0.85, 2.05))), "0.15 m from the table's edge");
        assertTrue(region.open(region.locate(Place.of(0.75, 2.05))));
        assertFalse(region.open(region.locate(Place.of(1.65, 2.05))), "the ditch's wall is 0.15 m away");
    }

    @Test
    void shallowDitchIsSteppedInto() {
        Scene scene = new Scene(
                "",
                new World(4, 4, 0.1),
                List.of(),
                List.of(
                        new Ditch("a", "", Polygon.rectangle(1, 0, 2, 4), 0.2),
                        new Ditch("b", "", Polygon.rectangle(2, 0, 3, 4), 0.2)),
                List.of(),
                List.of());
        Region region = Region.of(scene, ACTOR);
        assertEquals(Kind.BORDER, region.kind(region.locate(Place.of(0.95, 2.05))));
        assertEquals(Kind.BORDER, region.kind(region.locate(Place.of(1.05, 2.05))));
        assertEquals(Kind.STABLE, region.kind(region.locate(Place.of(1.95, 2.05))), "two ditches join without an edge");
        assertTrue(Reach.from(region, region.locate(Place.of(0.5, 2))).reached(region.locate(Place.of(3.5, 2))));
    }
}
