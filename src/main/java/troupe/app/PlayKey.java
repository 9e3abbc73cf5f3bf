package troupe.app;

import java.awt.Component;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.function.Predicate;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.MenuSelectionManager;
import javax.swing.text.JTextComponent;

/**
 * Plays and pauses with the space key wherever the focus is in a window, except where the key has a meaning
 * of its own: in texts, on buttons and in menus. A key that is held plays once. Belongs to the event thread.
 */
final class PlayKey implements KeyEventDispatcher, AutoCloseable {
    /** How soon in ms after a release a press is the repetition of a held key. */
    private static final long REPEAT_MS = 20;

    private final Predicate<Component> inWindow;
    private final Runnable play;
    private boolean down;
    private long released = Long.MIN_VALUE / 2;

    /** Makes the key; it works once it is {@linkplain #install() installed}. */
    PlayKey(Predicate<Component> inWindow, Runnable play) {
        this.inWindow = inWindow;
        this.play = play;
    }

    /** Listens to the keys of the program until closed. */
    PlayKey install() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(this);
        return this;
    }

    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        boolean space = event.getKeyCode() == KeyEvent.VK_SPACE || event.getKeyChar() == ' ';
        if (!space || event.getModifiersEx() != 0 || !isFree(event.getComponent())) {
            return false;
        }
        if (event.getID() == KeyEvent.KEY_PRESSED) {
            boolean repeated = down || event.getWhen() - released < REPEAT_MS;
            down = true;
            if (!repeated) {
                play.run();
            }
        } else if (event.getID() == KeyEvent.KEY_RELEASED) {
            down = false;
            released = event.getWhen();
        }
        return true;
    }

    private boolean isFree(Component focused) {
        return inWindow.test(focused)
                && !(focused instanceof JTextComponent)
                && !(focused instanceof AbstractButton)
                && !(focused instanceof JComboBox)
                && MenuSelectionManager.defaultManager().getSelectedPath().length == 0;
    }

    @Override
    public void close() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(this);
    }
}
