package troupe.app.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.app.Scenes;
import troupe.geometry.Polygon;
import troupe.scene.Element;
import troupe.scene.Journey;
import troupe.scene.Scene;

/** Arranges, copies and pastes the things of a small room: a crate at 4..5, 3..4 and a post at 7..7.5, 6..6.5. */
class ArrangingTest {
    private static final List<String> BOTH = List.of("crate", "post");
    private final Scene scene = Scenes.room();

    private static Polygon outline(Scene scene, String id) {
        return scene.obstacle(id).orElseThrow().outline();
    }

    private static List<String> ids(List<? extends Element> all) {
        return all.stream().map(Element::id).toList();
    }

    @Test
    void alignsToEachSideOfTheBoxAroundAll() {
        assertEquals(
                Polygon.rectangle(4, 6, 4.5, 6.5),
                outline(Arranging.aligned(scene, BOTH, Arranging.Side.LEFT), "post"));
        assertEquals(
                Polygon.rectangle(6.5, 3, 7.5, 4),
                outline(Arranging.aligned(scene, BOTH, Arranging.Side.RIGHT), "crate"));
        assertEquals(
                Polygon.rectangle(4, 5.5, 5, 6.5),
                outline(Arranging.aligned(scene, BOTH, Arranging.Side.TOP), "crate"));
        assertEquals(
                Polygon.rectangle(7, 3, 7.5, 3.5),
                outline(Arranging.aligned(scene, BOTH, Arranging.Side.BOTTOM), "post"));
        Scene middle = Arranging.aligned(scene, BOTH, Arranging.Side.MIDDLE);
        assertEquals(Polygon.rectangle(5.25, 3, 6.25, 4), outline(middle, "crate"));
        assertEquals(Polygon.rectangle(5.5, 6, 6, 6.5), outline(middle, "post"));
    }

    @Test
    void spreadsMiddlesEvenly() {
        Scene three = NewElements.with(scene, Scenes.box("stone", 0, 0, 1));
        Scene spread = Arranging.spread(three, List.of("crate", "post", "stone"), true);
        assertEquals(Polygon.rectangle(0, 0, 1, 1), outline(spread, "stone"));
        assertEquals(Polygon.rectangle(3.375, 3, 4.375, 4), outline(spread, "crate"));
        assertEquals(outline(scene, "post"), outline(spread, "post"));
    }

    @Test
    void ordersKeepingTheOrderOfWhatMoves() {
        Scene four = scene;
        for (String id : List.of("c", "d")) {
            four = NewElements.with(four, Scenes.box(id, 0, 0, 1));
        }
        List<String> first = List.of("crate", "post");
        assertEquals(
                List.of("c", "d", "crate", "post"),
                ids(Arranging.ordered(four, first, Arranging.Order.FRONT).obstacles()));
        assertEquals(
                List.of("c", "crate", "post", "d"),
                ids(Arranging.ordered(four, first, Arranging.Order.FORWARD).obstacles()));
        assertEquals(
                List.of("crate", "c", "d", "post"),
                ids(Arranging.ordered(four, List.of("c", "d"), Arranging.Order.BACKWARD)
                        .obstacles()));
        assertEquals(
                List.of("d", "crate", "post", "c"),
                ids(Arranging.ordered(four, List.of("d"), Arranging.Order.BACK).obstacles()));
    }

    @Test
    void pastesUnderFreeIdsAndLabelsBesideWhatIsThere() {
        Scene part = Pasting.extract(scene, List.of("crate", "ann", "there"));
        assertEquals(List.of("crate"), ids(part.obstacles()));
        Pasting.Pasted pasted = Pasting.into(scene, part, "");
        assertEquals(List.of("crate-1", "ann-1", "there-1"), pasted.ids());
        assertEquals(Polygon.rectangle(4.5, 2.5, 5.5, 3.5), outline(pasted.scene(), "crate-1"));
        assertEquals("ann-1", ((Journey) pasted.scene().task("there-1").orElseThrow()).actor());
        Pasting.Pasted again = Pasting.into(pasted.scene(), part, "");
        assertEquals(Polygon.rectangle(5, 2, 6, 3), outline(again.scene(), "crate-2"));
        Scene named = scene.with(scene.obstacle("crate").orElseThrow().named("crate", "Crate"));
        Pasting.Pasted second = Pasting.into(named, Pasting.extract(named, List.of("crate")), "");
        assertEquals("Crate 2", second.scene().obstacle("crate-1").orElseThrow().label());
    }

    @Test
    void pastesInPlaceWhereNothingLiesThere() {
        Scene part = Pasting.extract(scene, BOTH);
        Pasting.Pasted pasted = Pasting.into(SceneEdits.removed(scene, BOTH), part, "");
        assertEquals(BOTH, pasted.ids());
        assertTrue(pasted.scene().obstacles().containsAll(scene.obstacles()));
    }
}
