package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import troupe.app.look.Texts;
import troupe.scene.Scene;

/** Changes the preferences in their dialog, and looks whether everything still fits. */
class PreferencesRobotTest extends RobotTest {
    /** What is shortened where there is no room, and told in full elsewhere. */
    private static final Set<String> SHORTENED = Set.of("status.hint", "top.title");

    private void resize(int width, int height) {
        OnEventThread.run(() -> studio.window().frame().setSize(width, height));
        Await.until(
                "the window is resized",
                () -> studio.window().canvas().getRootPane().getWidth() == width
                        && studio.window().canvas().getRootPane().getHeight() == height);
    }

    private void choose(String name, String key, String value) {
        studio.click(name);
        Await.until(
                name + " is remembered", () -> value.equals(studio.settings().get(key)));
    }

    @Test
    void everyChoiceHoldsAtOnceAndIsRemembered() {
        studio.keys(KeyEvent.VK_CONTROL, KeyEvent.VK_COMMA);
        Await.until("the preferences are shown", () -> studio.shows("preferences.theme.dark"));
        choose("preferences.theme.dark", "theme", "dark");
        assertEquals(
                "dark", OnEventThread.get(() -> studio.window().look().theme().key()));
        choose("preferences.language.zh-TW", "language", "zh-TW");
        assertEquals("檔案", OnEventThread.get(() -> studio.window().look().text("menu.file")));
        choose("preferences.live", "live", "false");
        assertFalse(OnEventThread.get(() -> studio.session().isLive()));
        choose("preferences.snapping", "snapping", "false");
        assertFalse(OnEventThread.get(() -> studio.window().canvas().isSnapping()));
        choose("preferences.opening.page", "opening", "page");
        int tools = studio.find("tools").getWidth();
        choose("preferences.scale.125", "scale", "125");
        Await.until("the tools are larger", () -> studio.find("tools").getWidth() == Math.round(tools * 1.25f));
        studio.keys(KeyEvent.VK_ESCAPE);
        Await.until("the dialog is closed", () -> !studio.shows("preferences.theme.dark"));
    }

    @Test
    void thingsAreDraggedWhereTheyAreSeenAtAnyScale() {
        OnEventThread.run(() -> studio.window().scale(150));
        resize(1_280, 720);
        Scene before = studio.scene();
        studio.drag(studio.window().canvas(), studio.pixel(8.125, 7.6), studio.pixel(5.5, 9.5));
        Await.until("moved", () -> studio.session().document().isUnsaved());
        assertNotEquals(before.element("crate"), studio.scene().element("crate"));
    }

    @Test
    void nothingIsTruncatedAtAnyScaleInAnyLanguage() {
        for (int scale : List.of(100, 200)) {
            for (Locale language : Texts.LANGUAGES) {
                OnEventThread.run(() -> {
                    studio.window().show(new Texts(language));
                    studio.window().scale(scale);
                });
                resize(1_280 * scale / 100, 720 * scale / 100);
                studio.awaitPlan();
                OnEventThread.run(() -> {
                    studio.window().frame().validate();
                    List<String> cut = new ArrayList<>();
                    truncated(studio.window().frame(), cut);
                    assertEquals(List.of(), cut, scale + " % in " + language);
                });
            }
        }
    }

    private static void truncated(Container in, List<String> cut) {
        for (Component part : in.getComponents()) {
            boolean shortened = SHORTENED.contains(String.valueOf(part.getName()));
            if (!shortened && part.isShowing() && part.getWidth() < needed(part)) {
                cut.add(words((JComponent) part) + ": " + part.getWidth() + " of " + needed(part));
            }
            if (part instanceof Container inner) {
                truncated(inner, cut);
            }
        }
    }

    /** Returns the width that a text needs, whatever size its component asks for; 0 for what has no text. */
    private static int needed(Component part) {
        if (part instanceof JLabel label && !label.getText().isEmpty()) {
            int text = label.getFontMetrics(label.getFont()).stringWidth(label.getText());
            return text + label.getInsets().left + label.getInsets().right;
        }
        boolean button = part instanceof AbstractButton b && b.getText() != null;
        return button && !words((JComponent) part).isEmpty() ? part.getPreferredSize().width : 0;
    }

    private static String words(JComponent part) {
        return part instanceof JLabel label ? label.getText() : ((AbstractButton) part).getText();
    }
}
