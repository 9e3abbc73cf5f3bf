package troupe.app.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.Action;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import troupe.app.look.Texts;

/** Holds all commands in the order of the menus. */
public final class Commands {
    private final Texts texts;
    private final List<Command> all = new ArrayList<>();
    private final List<Command> groups = new ArrayList<>();

    /** Makes an empty list. */
    public Commands(Texts texts) {
        this.texts = texts;
    }

    /** Adds a command to a menu. */
    public Command add(String menu, String id, Runnable action) {
        Command command = new Command(texts, menu, id, false, c -> action.run());
        all.add(command);
        return command;
    }

    /** Adds a choice to a menu; {@code action} is told whether it is on now. */
    public Command addChoice(String menu, String id, boolean on, Consumer<Boolean> action) {
        Command command = new Command(texts, menu, id, true, c -> action.accept(c.isOn()));
        command.setOn(on);
        all.add(command);
        return command;
    }

    /** Adds a command that stands for an action which knows by itself whether it can be done. */
    public Command add(String menu, String id, Action action) {
        Command command = add(menu, id, () -> action.actionPerformed(null));
        command.follow(action, texts);
        return command;
    }

    /** Begins a new group: a line in the menu above what is added next. */
    public void separate() {
        if (!all.isEmpty()) {
            groups.add(all.get(all.size() - 1));
        }
    }

    /** Returns all commands. */
    public List<Command> all() {
        return List.copyOf(all);
    }

    /**
     * Returns the command of an id.
     *
     * @throws IllegalArgumentException if there is none
     */
    public Command get(String id) {
        return all.stream()
                .filter(c -> c.id().equals(id))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no command '" + id + "'"));
    }

    /** Returns the commands whose text or menu holds every word of a query, those that begin with it first. */
    public List<Command> search(String query) {
        String wanted = query.strip().toLowerCase(Locale.ROOT);
        List<Command> begin = new ArrayList<>();
        List<Command> hold = new ArrayList<>();
        for (Command command : all) {
            String text = command.name().toLowerCase(Locale.ROOT);
            String place =
                    (texts.get("menu." + command.menu()) + " " + text + " " + command.id()).toLowerCase(Locale.ROOT);
            if (text.startsWith(wanted)) {
                begin.add(command);
            } else if (List.of(wanted.split("\\s+")).stream().allMatch(place::contains)) {
                hold.add(command);
            }
        }
        begin.addAll(hold);
        return begin;
    }

    /** Makes the menus. */
    public List<JMenu> menus() {
        List<JMenu> menus = new ArrayList<>();
        JMenu menu = null;
        Command before = null;
        for (Command command : all) {
            if (menu == null || !command.menu().equals(menu.getName().substring("menu.".length()))) {
                menu = new JMenu(texts.get("menu." + command.menu()));
                menu.setName("menu." + command.menu());
                menus.add(menu);
            } else if (groups.contains(before)) {
                menu.addSeparator();
            }
            JMenuItem item = command.isChoice() ? new JCheckBoxMenuItem(command) : new JMenuItem(command);
            item.setName("command." + command.id());
            item.setIcon(null);
            item.setIconTextGap(24);
            item.setToolTipText(null);
            menu.add(item);
            before = command;
        }
        return menus;
    }
}
