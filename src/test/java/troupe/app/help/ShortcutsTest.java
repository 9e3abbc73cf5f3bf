package troupe.app.help;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import troupe.app.command.Commands;
import troupe.app.look.Texts;

class ShortcutsTest {
    private final Texts texts = new Texts(Locale.ENGLISH);

    private List<Shortcuts.Line> lines() {
        Commands commands = new Commands(texts);
        commands.add("file", "open", () -> {});
        commands.add("file", "quit", () -> {});
        commands.add("help", "about", () -> {});
        return Shortcuts.of(commands, texts);
    }

    @Test
    void everyCommandWithAShortcutIsListedAndThenThePlan() {
        List<Shortcuts.Line> lines = lines();
        assertEquals(
                List.of("Open\u2026", "Quit"),
                lines.stream().limit(2).map(Shortcuts.Line::name).toList());
        assertEquals("Ctrl+O", lines.get(0).keys());
        assertEquals("In the plan", lines.get(2).menu());
    }

    @Test
    void wordsAreFoundInAnyColumn() {
        assertEquals(2, Shortcuts.matching(lines(), "file").size());
        assertEquals(List.of("Quit"), names("ctrl q"));
        assertEquals(List.of("No snapping"), names("  SNAP "));
        assertEquals(List.of(), names("nothing like it"));
    }

    private List<String> names(String query) {
        return Shortcuts.matching(lines(), query).stream()
                .map(Shortcuts.Line::name)
                .toList();
    }
}
