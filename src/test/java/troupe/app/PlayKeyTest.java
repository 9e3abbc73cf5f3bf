package troupe.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;

class PlayKeyTest {
    private final Component panel = new JPanel();
    private final Component elsewhere = new JPanel();
    private int played;
    private final PlayKey key = new PlayKey(focused -> focused != elsewhere, () -> played++);

    private boolean press(Component focused, long when, int modifiers) {
        return key.dispatchKeyEvent(
                new KeyEvent(focused, KeyEvent.KEY_PRESSED, when, modifiers, KeyEvent.VK_SPACE, ' '));
    }

    private void release(long when) {
        key.dispatchKeyEvent(new KeyEvent(panel, KeyEvent.KEY_RELEASED, when, 0, KeyEvent.VK_SPACE, ' '));
    }

    @Test
    void playsWithEachPress() {
        assertTrue(press(panel, 1_000, 0));
        release(1_080);
        assertTrue(press(panel, 1_300, 0));
        assertEquals(2, played);
    }

    @Test
    void aHeldKeyPlaysOnceHoweverItsRepetitionIsTold() {
        press(panel, 1_000, 0);
        press(panel, 1_030, 0);
        release(1_060);
        press(panel, 1_060, 0);
        release(1_090);
        assertEquals(1, played);
    }

    @Test
    void textsButtonsOtherWindowsAndShortcutsKeepTheirSpace() {
        assertFalse(press(new JTextField(), 1_000, 0));
        assertFalse(press(new JButton(), 1_000, 0));
        assertFalse(press(elsewhere, 1_000, 0));
        assertFalse(press(panel, 1_000, InputEvent.CTRL_DOWN_MASK));
        assertFalse(key.dispatchKeyEvent(new KeyEvent(panel, KeyEvent.KEY_PRESSED, 1, 0, KeyEvent.VK_F6, '\uffff')));
        assertEquals(0, played);
    }
}
