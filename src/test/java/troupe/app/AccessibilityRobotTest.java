package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JSlider;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import troupe.app.command.Command;
import troupe.app.look.Drawn;
import troupe.app.look.Texts;

/** Asks every part of the window that can be worked for its name, and goes through the window by keys alone. */
class AccessibilityRobotTest extends RobotTest {
    private static final List<String> PANELS =
            List.of("top", "tools", "outline", "chips", "canvas", "inspector", "timeline");

    private static boolean isInteractive(Component part) {
        return part instanceof AbstractButton
                || part instanceof JTextComponent
                || part instanceof JSlider
                || part instanceof JList<?>
                || part instanceof JComboBox<?>
                || part instanceof JTable
                || part instanceof Drawn && part.isFocusable() && part.isShowing() && hasKeys((JComponent) part);
    }

    private static boolean hasKeys(JComponent part) {
        return part.getInputMap().size() > 0;
    }

    private static int nameless(Container in, List<String> found) {
        int asked = 0;
        for (Component part : in.getComponents()) {
            if (isInteractive(part) && part.isVisible()) {
                asked++;
                AccessibleContext context = ((Accessible) part).getAccessibleContext();
                String name = context.getAccessibleName();
                boolean arrow = part.getClass().getName().startsWith("javax.swing.plaf")
                        || part.getParent() instanceof javax.swing.JScrollBar;
                if (!arrow && (name == null || name.isBlank())) {
                    found.add(part.getClass().getName() + " '" + part.getName() + "' in "
                            + part.getParent().getName());
                }
            }
            if (part instanceof Container inner) {
                asked += nameless(inner, found);
            }
        }
        return asked;
    }

    private int check(String where, Container in) {
        return OnEventThread.get(() -> {
            List<String> found = new ArrayList<>();
            int asked = nameless(in, found);
            assertEquals(List.of(), found, where);
            return asked;
        });
    }

    @Test
    void everythingThatCanBeWorkedHasANameInEveryLanguage() {
        for (Locale language : Texts.LANGUAGES) {
            OnEventThread.run(() -> studio.window().show(new Texts(language)));
            studio.awaitPlan();
            assertTrue(check("window in " + language, studio.window().frame()) > 60);
            OnEventThread.run(() -> studio.session().selection().set(List.of("crate")));
            check("with a selection in " + language, studio.window().frame());
            OnEventThread.run(() -> studio.window().pages().showStart());
            Await.until("the examples are shown", () -> studio.shows("example.unified.courtyard"));
            check("start page in " + language, studio.window().frame());
            OnEventThread.run(() -> studio.window().pages().showScene());
            dialog("new", "new.room", language);
            dialog("preferences", "preferences.theme.dark", language);
        }
    }

    private void dialog(String command, String part, Locale language) {
        SwingUtilities.invokeLater(() -> studio.window().commands().get(command).perform());
        Await.until("the dialog is shown", () -> studio.shows(part));
        for (Window dialog : studio.window().frame().getOwnedWindows()) {
            if (dialog.isShowing()) {
                assertTrue(check(command + " in " + language, dialog) > 3);
                OnEventThread.run(dialog::dispose);
            }
        }
    }

    private String panelOfFocus() {
        Component owner = studio.window().frame().getFocusOwner();
        String found = "";
        for (Component part = owner; part != null && found.isEmpty(); part = part.getParent()) {
            found = part.getName() != null && PANELS.contains(part.getName()) ? part.getName() : "";
        }
        return found;
    }

    @Test
    void everyPanelIsReachedByF6AndBack() {
        OnEventThread.run(() -> studio.window().wantOutline(true));
        Set<String> reached = new LinkedHashSet<>();
        String before = OnEventThread.get(this::panelOfFocus);
        assertEquals("canvas", before);
        for (int i = 0; i < PANELS.size() + 2; i++) {
            studio.keys(KeyEvent.VK_F6);
            reached.add(OnEventThread.get(this::panelOfFocus));
        }
        assertEquals(
                Set.copyOf(PANELS),
                Set.copyOf(reached).stream().filter(PANELS::contains).collect(java.util.stream.Collectors.toSet()));
        OnEventThread.run(() -> studio.window().canvas().requestFocusInWindow());
        Await.until("the canvas has the keys", () -> studio.window().canvas().isFocusOwner());
        studio.keys(KeyEvent.VK_F6);
        String next = OnEventThread.get(this::panelOfFocus);
        studio.keys(KeyEvent.VK_SHIFT, KeyEvent.VK_F6);
        assertTrue(!next.equals("canvas"));
        Await.until("back on the canvas", () -> panelOfFocus().equals("canvas"));
    }

    @Test
    void noTwoCommandsShareAShortcut() {
        Map<String, String> taken = new HashMap<>();
        for (Command command :
                OnEventThread.get(() -> studio.window().commands().all())) {
            String shortcut = command.shortcut();
            String other = shortcut.isEmpty() ? null : taken.put(shortcut, command.id());
            assertEquals(null, other, shortcut + " is also that of " + command.id());
        }
    }
}
