package troupe.app.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.app.Scenes;
import troupe.run.view.Overlay;

class ViewsTest {
    private static final Overlay A = new Overlay.Points("a", 0, new double[] {1, 1});
    private static final Overlay UPPER_A = new Overlay.Points("a", 1, new double[] {1, 1});
    private static final Overlay OTHER_A = new Overlay.Points("a", 0, new double[] {2, 2});
    private static final Overlay B = new Overlay.Points("b", 0, new double[] {3, 3});
    private static final Overlay C = new Overlay.Points("c", 0, new double[] {4, 4});

    private static Views all(Overlay... overlays) {
        return Views.of(Scenes.room(), List.of(overlays), List.of());
    }

    private static Views some(Overlay... overlays) {
        return Views.some(Scenes.room(), List.of(overlays), List.of());
    }

    @Test
    void allViewsTakeThePlaceOfEarlierOnes() {
        Views all = all(B);
        assertSame(all, all.over(all(A, C)));
    }

    @Test
    void someViewsTakeThePlaceOfTheirKindOnAllLayers() {
        Views merged = some(OTHER_A, C).over(all(A, UPPER_A, B));
        assertEquals(List.of(OTHER_A, B, C), merged.overlays());
        assertEquals(2, merged.layers().size());
        assertFalse(merged.current());
    }

    @Test
    void whereThereAreNoneTheEarlierOnesStayTheSameList() {
        Views earlier = all(A, B);
        Views kept = Views.NONE.over(earlier);
        assertSame(earlier.overlays(), kept.overlays());
        assertFalse(kept.current());
        assertSame(kept, Views.NONE.over(kept));
    }
}
