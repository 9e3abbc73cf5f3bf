package troupe.app.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.app.OnEventThread;
import troupe.app.Scenes;

class SelectionTest {

    @Test
    void tellsOnlyChanges() {
        OnEventThread.run(() -> {
            Selection selection = new Selection();
            int[] told = new int[1];
            selection.listeners().add(s -> told[0]++);
            selection.set(List.of("crate"));
            selection.set(List.of("crate"));
            selection.toggle("post");
            selection.toggle("crate");
            assertEquals(List.of("post"), selection.ids());
            assertEquals(3, told[0]);
        });
    }

    @Test
    void forgetsWhatTheSceneNoLongerHolds() {
        OnEventThread.run(() -> {
            Selection selection = new Selection();
            selection.set(List.of("crate", "gone"));
            assertTrue(selection.single(Scenes.room()).isEmpty());
            selection.retain(Scenes.room());
            assertEquals("crate", selection.single(Scenes.room()).orElseThrow().id());
        });
    }
}
