package troupe.run.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.field.Nf2;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

class GridOverlaysTest {

    @Test
    void tellsStandingPlacesFromForbiddenOnes() {
        Built built = build(box("wall", 2.84, 0, 3.2, 3, 0, 2));
        Overlay.Field kinds = field(built.overlays.kinds(), 0, 1);
        assertEquals(Kind.STABLE, at(kinds, 1, 1));
        assertEquals(Kind.FORBIDDEN, at(kinds, 2.75, 1));
        Overlay.Field region = field(built.overlays.region(), 0, 1);
        assertEquals(0, at(region, 1, 1));
        assertEquals(1, at(region, 2.65, 1), "0.2 m from the wall only sidestepping has room");
        assertTrue(Double.isNaN(at(region, 2.75, 1)));
        Overlay.Field clearance = field(built.overlays.clearance(), 0, 1);
        assertEquals(2.84 - 2.45, at(clearance, 2.45, 1), 1e-5);
    }

    @Test
    void layersThatLieOverEachOtherAreOnStoreysOfTheirOwn() {
        Built built = build(box("deck", 2, 0, 4, 3, 2.5, 0.3), box("table", 4.5, 2, 5.5, 3, 0, 0.8));
        List<Overlay> layers = built.overlays.layers();
        assertEquals(2, layers.size());
        assertEquals(
                3,
                ((Overlay.Categories) ((Overlay.Field) layers.get(0)).scale())
                        .words()
                        .size());
        assertTrue(at(field(layers, 0, 2), 5, 2.5) != at(field(layers, 0, 2), 1, 1));
        assertTrue(Double.isNaN(at(field(layers, 1, 2), 5, 2.5)));
        Overlay.Field upper = field(built.overlays.elevation(), 1, 2);
        assertEquals(2.8, at(upper, 3, 1), 1e-6);
        assertEquals(0, at(field(built.overlays.elevation(), 0, 2), 3, 1));
    }

    /** Two obstacles as high as can be vaulted: the reach is 1 m, so the disc of 0.5 m fits into the block alone. */
    @Test
    void theOpeningTakesAwayWhatIsThin() {
        Built built = build(box("fence", 2, 0, 2.3, 4, 0, 0.9), box("block", 3.4, 1.8, 6, 4, 0, 0.9));
        Overlay.Field steps = field(built.overlays.opening(), 0, 1);
        assertEquals(List.of("core", "regrown", "thin", "vault"), ((Overlay.Categories) steps.scale()).words());
        assertTrue(Double.isNaN(at(steps, 1, 2)), "the floor is not barred");
        assertEquals(3, at(steps, 2.15, 2), "the fence is vaulted");
        assertEquals(0, at(steps, 4.7, 3), "the middle of the block is left by the erosion");
        assertEquals(1, at(steps, 3.45, 3), "its edge comes back");
    }

    @Test
    void withoutVaultingThereIsNoOpening() {
        Actor walker = Actor.standard("anna").without(Set.of(Ability.VAULT));
        Scene scene = new Scene("", new World(6, 4, 0.1), List.of(), List.of(), List.of(walker), List.of());
        RegionBuilder builder = new RegionBuilder(scene, walker);
        assertEquals(List.of(), new GridOverlays(builder.region(), builder.layers()).opening());
    }

    @Test
    void potentialFallsToTheGoalAndHasContours() {
        Built built = build(box("wall", 2.8, 0, 3.2, 3, 0, 2));
        Overlay.Field potential = field(built.overlays.potential(built.nf2), 0, 1);
        assertEquals(0, at(potential, 5.05, 1.05));
        assertTrue(at(potential, 1, 1) > 4);
        Overlay.Continuous scale = (Overlay.Continuous) potential.scale();
        assertTrue(scale.contour() > 0 && scale.max() / scale.contour() <= 12);
        assertEquals("m", scale.unit());
    }

    @Test
    void skeletonLinesPassEveryConfigurationOfTheSkeletonOnce() {
        Built built = build(box("block", 2, 1.2, 4, 2.4, 0, 2));
        Set<List<Double>> passed = new HashSet<>();
        int segments = 0;
        for (Overlay overlay : built.overlays.skeleton(built.nf2)) {
            for (double[] line : ((Overlay.Lines) overlay).lines()) {
                for (int i = 0; i < line.length; i += 2) {
                    passed.add(List.of(line[i], line[i + 1]));
                }
                segments += line.length / 2 - 1;
            }
        }
        int nodes = 0;
        for (int q = 0; q < built.region.size(); q++) {
            if (built.region.open(q) && built.nf2.skeleton(q)) {
                nodes++;
                assertTrue(passed.contains(List.of(built.region.x(q), built.region.y(q))), "misses " + q);
            }
        }
        assertTrue(segments <= nodes + 8, segments + " segments for " + nodes + " configurations");
    }

    @Test
    void withoutFieldThereIsNeitherSkeletonNorPotential() {
        Built built = build();
        assertEquals(List.of(), built.overlays.of("skeleton", null));
        assertEquals(List.of(), built.overlays.of("potential", null));
        for (String key : GridOverlays.KEYS) {
            for (Overlay overlay : built.overlays.of(key, built.nf2)) {
                assertEquals(key, overlay.key());
            }
        }
        assertThrows(IllegalArgumentException.class, () -> built.overlays.of("colour", null));
    }

    @Test
    void contourStepsAreRoundNumbers() {
        assertEquals(0.5, GridOverlays.round(0.3), 1e-12);
        assertEquals(2, GridOverlays.round(1.5), 1e-9);
        assertEquals(10, GridOverlays.round(7), 1e-9);
    }

    private record Built(Region region, GridOverlays overlays, Nf2 nf2) {}

    private static Built build(Obstacle... obstacles) {
        Scene scene = new Scene(
                "",
                new World(6, 4, 0.1),
                List.of(obstacles),
                List.of(),
                List.of(Actor.standard("anna")),
                List.of(Journey.of("go", "anna", Place.of(1, 1), Place.of(5.05, 1.05))));
        RegionBuilder builder = new RegionBuilder(scene, scene.actors().get(0));
        Region region = builder.region();
        Nf2 nf2 = new Nf2(region).compute(region.locate(Place.of(5.05, 1.05)), Journey.Spread.BREADTH);
        return new Built(region, new GridOverlays(region, builder.layers()), nf2);
    }

    private static Obstacle box(String id, double x0, double y0, double x1, double y1, double offset, double height) {
        return new Obstacle(
                id, "", Polygon.rectangle(x0, y0, x1, y1), offset, height, false, Obstacle.DEFAULT_MASS, "");
    }

    private static Overlay.Field field(List<Overlay> overlays, int storey, int count) {
        assertEquals(count, overlays.size());
        assertEquals(storey, overlays.get(storey).layer());
        return (Overlay.Field) overlays.get(storey);
    }

    private static double at(Overlay.Field field, double x, double y) {
        GridFrame frame = field.frame();
        return field.values()[frame.cellAt(x, y)];
    }
}
