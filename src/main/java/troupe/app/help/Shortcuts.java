package troupe.app.help;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import troupe.app.command.Command;
import troupe.app.command.Commands;
import troupe.app.look.Texts;

/** Lists every shortcut: those of the commands, by their menus, and what keys and mouse do in the plan. Pure. */
public final class Shortcuts {
    private static final List<String> PLAN = List.of(
            "zoom", "pan", "add", "angles", "free", "close", "last", "escape", "nudge", "corner", "play", "frames");

    private Shortcuts() {}

    /** One line: {@code menu} is the heading under which it stands. */
    public record Line(String menu, String name, String keys) {}

    /** Lists the lines of all commands that have a shortcut, in the order of the menus, and then those of the plan. */
    public static List<Line> of(Commands commands, Texts texts) {
        List<Line> all = new ArrayList<>();
        for (Command command : commands.all()) {
            if (!command.shortcut().isEmpty()) {
                all.add(new Line(texts.get("menu." + command.menu()), command.name(), command.shortcut()));
            }
        }
        for (String key : PLAN) {
            all.add(new Line(
                    texts.get("shortcuts.plan"), texts.get("shortcut." + key), texts.get("shortcut." + key + ".keys")));
        }
        return all;
    }

    /** Returns the lines that hold every word of a query in any of their columns. */
    public static List<Line> matching(List<Line> lines, String query) {
        List<String> words = Stream.of(query.strip().toLowerCase(Locale.ROOT).split("\\s+"))
                .filter(w -> !w.isEmpty())
                .toList();
        return lines.stream()
                .filter(line -> {
                    String all = (line.menu() + " " + line.name() + " " + line.keys()).toLowerCase(Locale.ROOT);
                    return words.stream().allMatch(all::contains);
                })
                .toList();
    }
}
