package troupe.app;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.concurrent.ForkJoinPool;
import troupe.app.command.Commands;
import troupe.app.help.AboutPanel;
import troupe.app.help.GuidePanel;
import troupe.app.help.HelpDialog;
import troupe.app.help.ShortcutsPanel;
import troupe.app.look.Look;

/** Adds the commands that help: the tour, the guide, the shortcuts, and what the program is. */
final class HelpCommands {
    private static final Dimension GUIDE = new Dimension(960, 660);
    private static final Dimension KEYS = new Dimension(440, 620);
    private static final Dimension ABOUT = new Dimension(440, 240);

    private final StudioWindow window;
    private final Look look;

    HelpCommands(StudioWindow window, Look look) {
        this.window = window;
        this.look = look;
    }

    /** Adds them to the list. */
    void add(Commands commands) {
        commands.add("help", "tour", window.pages()::tour);
        commands.add(
                "help",
                "guide",
                () -> HelpDialog.open(
                        window.frame(),
                        look,
                        "guide",
                        new GuidePanel(look, ForkJoinPool.commonPool(), EventQueue::invokeLater),
                        GUIDE));
        commands.add(
                "help",
                "shortcuts",
                () -> HelpDialog.open(window.frame(), look, "shortcuts", new ShortcutsPanel(look, commands), KEYS));
        commands.separate();
        commands.add(
                "help", "about", () -> HelpDialog.open(window.frame(), look, "about", new AboutPanel(look), ABOUT));
    }
}
