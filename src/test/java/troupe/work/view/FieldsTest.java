package troupe.work.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InterruptedIOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import troupe.run.view.Aspect;
import troupe.run.view.Overlay;
import troupe.scene.Scene;
import troupe.scene.xml.SceneXml;

class FieldsTest {
    private static Scene scene;

    @BeforeAll
    static void read() throws Exception {
        scene = SceneXml.read(Path.of("scenes/unified/two-ways.xml")).scene();
    }

    private static Fields of(List<String> keys, Map<String, Integer> choices) throws InterruptedIOException {
        return Fields.of(scene, "to-the-hall", keys, choices, () -> false);
    }

    private static Overlay.Field field(Fields fields) {
        return (Overlay.Field) fields.overlays().get(0).get(0);
    }

    @Test
    void showsTheSearchSpaceThatIsChosen() throws InterruptedIOException {
        Fields drawn = of(List.of("region"), Map.of("space", 1));
        assertEquals("space", drawn.aspects().get(0).key());
        assertEquals(
                Aspect.Choice.of("moved", "Cabinet"),
                drawn.aspects().get(0).choices().get(1));
        Fields moved = of(List.of("region"), Map.of("space", 2));
        assertTrue(Arrays.equals(
                field(drawn).values(), field(of(List.of("region"), Map.of())).values()));
        // the middle of the cabinet before it was moved
        int cell = field(drawn).frame().cellAt(4.7, 4.9);
        assertTrue(Float.isNaN(field(drawn).values()[cell]));
        assertFalse(Float.isNaN(field(moved).values()[cell]));
    }

    @Test
    void showsWhereTheCabinetIsTakenHoldOfAndWhereItMayNotStand() throws InterruptedIOException {
        List<String> keys = List.of("triggers", "expected-path", "instance");
        Fields fields = of(keys, Map.of());
        assertEquals(
                keys,
                fields.overlays().stream().map(views -> views.get(0).key()).toList());
        assertEquals(List.of(), fields.missing());
        Overlay.Field poses = (Overlay.Field) fields.overlays().get(2).get(0);
        assertEquals(0, poses.values()[poses.frame().cellAt(4.7, 4.9)]);
        Fields turned = of(List.of("instance"), Map.of("heading", 7));
        assertEquals("degrees 90", turned.aspects().get(2).choices().get(6).text());
        assertNotEquals(
                Arrays.hashCode(poses.values()), Arrays.hashCode(field(turned).values()));
    }

    @Test
    void refusesWhatCannotBeChosen() {
        String key = assertThrows(Fields.ChoiceException.class, () -> of(List.of("region"), Map.of("hue", 1)))
                .getMessage();
        assertEquals("hue; needs one of space, instance, heading", key);
        String number = assertThrows(Fields.ChoiceException.class, () -> of(List.of("region"), Map.of("heading", 25)))
                .getMessage();
        assertEquals("heading=25; needs 1 to 24", number);
    }
}
