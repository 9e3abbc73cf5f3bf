package troupe.app.command;

import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;
import troupe.app.look.Icons;
import troupe.app.look.Texts;

/**
 * Something a person can do. Its text, hint, shortcut and icon are those of
 * {@code command.<id>}, {@code .hint}, {@code .key}, {@code .icon} in the texts; in a shortcut
 * {@code menu} stands for the platform's own key, Ctrl or Command. A choice is on or off.
 */
public final class Command extends AbstractAction {
    private final String id;
    private final String menu;
    private final boolean choice;
    private final transient Consumer<Command> action;

    Command(Texts texts, String menu, String id, boolean choice, Consumer<Command> action) {
        this.id = id;
        this.menu = menu;
        this.choice = choice;
        this.action = action;
        putValue(NAME, texts.get("command." + id));
        putValue(ACTION_COMMAND_KEY, id);
        key(texts.get("command." + id + ".key", "")).ifPresent(key -> putValue(ACCELERATOR_KEY, key));
        String shortcut = shortcut();
        String hint = texts.get("command." + id + ".hint", name());
        putValue(SHORT_DESCRIPTION, shortcut.isEmpty() ? hint : hint + "  (" + shortcut + ")");
        String icon = texts.get("command." + id + ".icon", "");
        if (!icon.isEmpty()) {
            putValue(LARGE_ICON_KEY, Icons.of(icon).icon(19));
        }
        if (choice) {
            putValue(SELECTED_KEY, false);
        }
    }

    private static Optional<KeyStroke> key(String text) {
        if (text.isEmpty()) {
            return Optional.empty();
        }
        int mask = GraphicsEnvironment.isHeadless()
                ? InputEvent.CTRL_DOWN_MASK
                : Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx();
        String own = mask == InputEvent.META_DOWN_MASK ? "meta" : "ctrl";
        return Optional.ofNullable(KeyStroke.getKeyStroke(text.replace("menu", own)));
    }

    /** Returns the word by which the command is known. */
    public String id() {
        return id;
    }

    /** Returns the word of the menu it belongs to. */
    public String menu() {
        return menu;
    }

    /** Returns the text. */
    public String name() {
        return (String) getValue(NAME);
    }

    /** Tells whether it is a choice that is on or off. */
    public boolean isChoice() {
        return choice;
    }

    /** Tells whether a choice is on. */
    public boolean isOn() {
        return Boolean.TRUE.equals(getValue(SELECTED_KEY));
    }

    /** Shows a choice as on or off. */
    public void setOn(boolean on) {
        putValue(SELECTED_KEY, on);
    }

    /** Returns the shortcut in words, empty if there is none. */
    public String shortcut() {
        if (!(getValue(ACCELERATOR_KEY) instanceof KeyStroke key)) {
            return "";
        }
        String modifiers = InputEvent.getModifiersExText(key.getModifiers());
        int code = key.getKeyCode();
        String name = code == KeyEvent.VK_COMMA ? "," : KeyEvent.getKeyText(code);
        return modifiers.isEmpty() ? name : modifiers + "+" + name;
    }

    /** Does it, if it can be done now. A choice that is not switched by its button is switched first. */
    public void perform() {
        if (isEnabled()) {
            if (choice) {
                setOn(!isOn());
            }
            actionPerformed(new ActionEvent(this, ActionEvent.ACTION_PERFORMED, id));
        }
    }

    /** Takes over whether another action can be done, and says what it would do. */
    void follow(Action other, Texts texts) {
        Runnable take = () -> {
            setEnabled(other.isEnabled());
            Object step = other.getValue(LONG_DESCRIPTION);
            boolean named = step != null && !step.toString().isEmpty();
            putValue(NAME, named ? texts.format("command." + id + ".named", step) : texts.get("command." + id));
        };
        other.addPropertyChangeListener(e -> take.run());
        take.run();
    }

    @Override
    public void actionPerformed(ActionEvent event) {
        action.accept(this);
    }
}
