package troupe.app.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JMenu;
import org.junit.jupiter.api.Test;
import troupe.app.OnEventThread;
import troupe.app.look.Texts;

class CommandsTest {
    private final List<String> done = new ArrayList<>();

    private Commands commands() {
        Commands commands = new Commands(new Texts(Locale.ENGLISH));
        commands.add("file", "open", () -> done.add("open"));
        commands.separate();
        commands.add("file", "save", () -> done.add("save"));
        commands.addChoice("view", "dark", false, on -> done.add("dark " + on));
        return commands;
    }

    @Test
    void performsAndSwitches() {
        Commands commands = commands();
        commands.get("open").perform();
        commands.get("dark").perform();
        commands.get("dark").perform();
        commands.get("save").setEnabled(false);
        commands.get("save").perform();
        assertEquals(List.of("open", "dark true", "dark false"), done);
        assertThrows(IllegalArgumentException.class, () -> commands.get("nothing"));
    }

    @Test
    void findsByWordsThoseThatBeginFirst() {
        Commands commands = commands();
        assertEquals(List.of("save"), ids(commands.search("sav")));
        assertEquals(List.of("open", "save"), ids(commands.search("file")));
        assertEquals(List.of("dark"), ids(commands.search("THEME view")));
        assertEquals(3, commands.search("").size());
        assertEquals(List.of(), ids(commands.search("zzz")));
    }

    private static List<String> ids(List<Command> commands) {
        return commands.stream().map(Command::id).toList();
    }

    @Test
    void buildsMenusInOrder() {
        OnEventThread.run(() -> {
            List<JMenu> menus = commands().menus();
            assertEquals(
                    List.of("File", "View"), menus.stream().map(JMenu::getText).toList());
            assertEquals(3, menus.get(0).getMenuComponentCount());
            menus.get(0).getItem(2).doClick();
            assertEquals(List.of("save"), done);
        });
    }

    @Test
    void followsAnActionThatKnowsItsState() {
        Commands commands = new Commands(new Texts(Locale.ENGLISH));
        Action undo = new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                done.add("undo");
            }
        };
        undo.setEnabled(false);
        Command command = commands.add("edit", "undo", undo);
        assertFalse(command.isEnabled());
        assertEquals("Undo", command.name());
        undo.setEnabled(true);
        undo.putValue(Action.LONG_DESCRIPTION, "Move Crate");
        assertTrue(command.isEnabled());
        assertEquals("Undo Move Crate", command.name());
        command.perform();
        assertEquals(List.of("undo"), done);
    }
}
