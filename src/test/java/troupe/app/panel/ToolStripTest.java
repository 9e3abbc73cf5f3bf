package troupe.app.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import javax.swing.Action;
import org.junit.jupiter.api.Test;
import troupe.app.OnEventThread;
import troupe.app.command.Commands;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.paint.Theme;

class ToolStripTest {
    private static ToolStrip strip(int height) {
        Texts texts = new Texts(Locale.ENGLISH);
        Commands commands = new Commands(texts);
        List<Action> tools = List.<Action>of(
                commands.addChoice("scene", "select", true, on -> {}),
                commands.addChoice("scene", "polygon", false, on -> {}),
                commands.addChoice("scene", "rectangle", false, on -> {}),
                commands.addChoice("scene", "measure", false, on -> {}));
        ToolStrip strip = new ToolStrip(new Look(Theme.LIGHT, texts), tools);
        strip.setSize(46, height);
        strip.doLayout();
        return strip;
    }

    private static List<String> shown(ToolStrip strip) {
        return Arrays.stream(strip.getComponents())
                .filter(Component::isVisible)
                .map(Component::getName)
                .toList();
    }

    @Test
    void allToolsAreShownWhereThereIsRoom() {
        OnEventThread.run(() -> assertEquals(
                List.of("tool.select", "tool.polygon", "tool.rectangle", "tool.measure"), shown(strip(200))));
    }

    @Test
    void thoseWithoutRoomAreBehindTheLastButtonAndNothingIsCut() {
        OnEventThread.run(() -> {
            ToolStrip strip = strip(130);
            assertEquals(List.of("tool.select", "tool.polygon", "tool.more"), shown(strip));
            for (Component part : strip.getComponents()) {
                assertTrue(!part.isVisible() || part.getY() + part.getHeight() <= 130, part.getName());
            }
            strip.setSize(46, 400);
            strip.doLayout();
            assertFalse(shown(strip).contains("tool.more"));
        });
    }
}
