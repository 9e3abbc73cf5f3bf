package troupe.app.settings;

import java.awt.FlowLayout;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.look.widget.FlatButton;
import troupe.app.look.widget.Switch;
import troupe.paint.Theme;
import troupe.paint.Tone;

/** Shows a person's choices and changes them at once. Belongs to the event thread. */
public final class PreferencesPanel extends JPanel {

    /**
     * Who is told what is chosen, and remembers it.
     *
     * @param scale is given percent
     */
    public record Takers(
            Consumer<Theme> theme,
            Consumer<Locale> language,
            Consumer<Integer> scale,
            Consumer<Boolean> live,
            Consumer<Boolean> snapping,
            Consumer<Opening> opening) {}

    private final transient Look look;
    private int row;

    /** Makes the panel of these settings. */
    public PreferencesPanel(Look look, StudioSettings settings, Takers takers) {
        super(new GridBagLayout());
        this.look = look;
        setName("preferences.panel");
        setOpaque(false);
        choice("theme", List.of(Theme.values()), t -> look.text("preferences.theme." + t.key()), settings.theme())
                .accept(takers.theme());
        choice(
                        "language",
                        Texts.LANGUAGES,
                        l -> look.text("preferences.language." + l.toLanguageTag()),
                        settings.language())
                .accept(takers.language());
        choice("scale", StudioSettings.SCALES, s -> s + " %", settings.scale()).accept(takers.scale());
        toggle("live", settings.live(), takers.live());
        toggle("snapping", settings.snapping(), takers.snapping());
        choice(
                        "opening",
                        List.of(Opening.values()),
                        o -> look.text("preferences.opening." + o.key()),
                        settings.opening())
                .accept(takers.opening());
    }

    /** Adds a row of buttons of which one is on, and returns what is given whom to tell. */
    private <T> Consumer<Consumer<T>> choice(String key, List<T> values, Function<T, String> words, T now) {
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.LEFT, 6, 0));
        buttons.setOpaque(false);
        buttons.setBorder(BorderFactory.createEmptyBorder(0, -6, 0, 0));
        ButtonGroup group = new ButtonGroup();
        String label = look.text("preferences." + key);
        List<FlatButton> made = values.stream()
                .map(value -> {
                    FlatButton button = new FlatButton(look, FlatButton.Style.CHIP);
                    button.setText(words.apply(value));
                    button.setName("preferences." + key + "." + word(value));
                    button.getAccessibleContext().setAccessibleName(label + ": " + words.apply(value));
                    button.setSelected(value.equals(now));
                    group.add(button);
                    buttons.add(button);
                    return button;
                })
                .toList();
        row(label, buttons);
        return taker -> {
            for (int i = 0; i < made.size(); i++) {
                T value = values.get(i);
                made.get(i).addActionListener(e -> taker.accept(value));
            }
        };
    }

    private static String word(Object value) {
        if (value instanceof Locale locale) {
            return locale.toLanguageTag();
        }
        return value.toString().toLowerCase(Locale.ROOT);
    }

    private void toggle(String key, boolean on, Consumer<Boolean> taker) {
        Switch toggle = new Switch(look);
        String label = look.text("preferences." + key);
        toggle.setName("preferences." + key);
        toggle.getAccessibleContext().setAccessibleName(label);
        toggle.setSelected(on);
        toggle.addActionListener(e -> taker.accept(toggle.isSelected()));
        row(label, toggle);
    }

    private void row(String text, JComponent field) {
        JLabel label = look.label(text, Tone.DIM);
        label.setLabelFor(field);
        GridBagConstraints at = new GridBagConstraints();
        at.gridy = row++;
        at.gridx = 0;
        at.anchor = GridBagConstraints.WEST;
        at.insets = new Insets(8, 0, 8, 28);
        add(label, at);
        at.gridx = 1;
        at.weightx = 1;
        at.insets = new Insets(8, 0, 8, 0);
        add(field, at);
    }
}
