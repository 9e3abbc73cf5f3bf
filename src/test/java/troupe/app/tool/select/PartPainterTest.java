package troupe.app.tool.select;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import troupe.app.PaintedTexts;
import troupe.app.document.Selection;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.geometry.Box;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.paint.Viewport;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Task;
import troupe.scene.xml.SceneXml;

class PartPainterTest {

    /** Returns where each text is painted; a text is painted more than once, on a trace of the floor's colour. */
    private static Map<String, PaintedTexts.Text> texts(Task task, Box shown) {
        Look look = new Look(Theme.LIGHT, new Texts(Locale.ENGLISH));
        Viewport view = Viewport.fit(shown, 600, 500, 40);
        Map<String, PaintedTexts.Text> last = new LinkedHashMap<>();
        PaintedTexts.of(600, 500, g -> PartPainter.paint(g, view, look, task, new Selection()))
                .forEach(text -> last.put(text.words(), text));
        return last;
    }

    private static void assertApart(Map<String, PaintedTexts.Text> texts) {
        List<PaintedTexts.Text> all = new ArrayList<>(texts.values());
        for (int i = 0; i < all.size(); i++) {
            for (int k = 0; k < i; k++) {
                assertFalse(all.get(i).box().intersects(all.get(k).box()), all.get(k) + " over " + all.get(i));
            }
        }
    }

    @Test
    void namesOfGroupsThatStandInOnePlaceDoNotOverlap() {
        List<CrowdGroup> groups = new ArrayList<>();
        for (String id : List.of("a", "b", "c", "d")) {
            CrowdGroup.Members members = CrowdGroup.Members.of(5, Polygon.rectangle(2, 2, 8, 8));
            groups.add(CrowdGroup.of(id, Place.of(9, 9), members));
        }
        Map<String, PaintedTexts.Text> texts = texts(Crowd.of("crowd", groups), new Box(0, 0, 10, 10));
        assertEquals(List.of("a \u00b7 5", "b \u00b7 5", "c \u00b7 5", "d \u00b7 5"), List.copyOf(texts.keySet()));
        assertApart(texts);
    }

    @Test
    void namesOfGroupsSideBySideDoNotOverlap() throws Exception {
        Task fork =
                SceneXml.read(Path.of("scenes/crowd/fork.xml")).scene().tasks().get(0);
        for (double size : new double[] {20, 40, 80}) {
            assertApart(texts(fork, new Box(0, 0, size, size)));
        }
    }
}
