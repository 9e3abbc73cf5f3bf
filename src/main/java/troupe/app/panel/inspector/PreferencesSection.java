package troupe.app.panel.inspector;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GridBagLayout;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.SwingConstants;
import troupe.app.document.SceneEdits;
import troupe.app.look.Look;
import troupe.app.look.widget.NumberField;
import troupe.app.look.widget.Switch;
import troupe.app.look.widget.ThinSliderUI;
import troupe.app.panel.Panel;
import troupe.app.panel.Rows;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Preferences;
import troupe.scene.Scene;

/**
 * Shows a slider for what each ability costs the actor of the task: the factor on its energy, from a
 * tenth to ten times on a logarithmic scale, and off at the right end (walking stays). Dragging replans;
 * letting go makes one edit. Below them: how an actor that can moves things.
 */
public final class PreferencesSection extends Panel {
    private static final int DECADE = 100;
    private static final int OFF = DECADE + 12;

    private final transient Map<Ability, JSlider> sliders = new EnumMap<>(Ability.class);
    private final transient Map<Ability, JLabel> factors = new EnumMap<>(Ability.class);
    private final Switch grip;
    private final NumberField headings;
    private Object shown = "";
    private boolean showing;

    PreferencesSection(Look look, Session session) {
        super(look, session, new GridBagLayout());
        setName("preferences");
        grip = new Switch(look);
        grip.setName("manipulation.grip");
        grip.setToolTipText(look.text("manipulation.grip.hint"));
        grip.addActionListener(e -> commit(
                "edit.manipulation",
                j -> j.with(grip.isSelected() ? Journey.Manipulation.GRIP : Journey.Manipulation.FREE)));
        headings = new NumberField(look, "", 0);
        headings.setName("manipulation.headings");
        headings.setToolTipText(look.text("manipulation.headings.hint"));
        headings.onNumber(
                v -> v == Math.rint(v) && v >= 1 && v <= Journey.MOST_HEADINGS,
                v -> commit("edit.headings", j -> j.withHeadings((int) v)));
        observing(session.document().listeners().add(c -> refresh()));
        refresh();
    }

    /** Returns the factor of a position of a slider. */
    public static double factor(int position) {
        if (position > DECADE) {
            return Preferences.OFF;
        }
        double factor = Math.pow(10, position / (double) DECADE);
        return Double.parseDouble(String.format(Locale.ROOT, "%.2g", factor));
    }

    /** Returns the position nearest to a factor. */
    public static int position(double factor) {
        if (factor == Preferences.OFF) {
            return OFF;
        }
        return (int) Math.max(-DECADE, Math.min(DECADE, Math.rint(Math.log10(factor) * DECADE)));
    }

    private Optional<Journey> journey(Scene scene) {
        return scene.task(session().document().task()).map(t -> t instanceof Journey j ? j : null);
    }

    private void refresh() {
        Scene scene = session().document().shown();
        Optional<Journey> journey = journey(scene);
        Optional<Actor> actor = journey.flatMap(j -> scene.actor(j.actor()));
        Set<Ability> abilities = actor.map(Actor::abilities).orElse(Set.of());
        String name = actor.map(Actor::name).orElse("");
        Object now = java.util.List.of(name, abilities);
        if (!now.equals(shown)) {
            shown = now;
            build(name, abilities);
        }
        setVisible(actor.isPresent());
        journey.ifPresent(j -> {
            show(j.preferences());
            grip.setSelected(j.manipulation() == Journey.Manipulation.GRIP);
            if (!headings.isFocusOwner()) {
                headings.show(j.headings());
            }
        });
    }

    private void build(String name, Set<Ability> abilities) {
        sliders.clear();
        factors.clear();
        Rows rows = new Rows(this, look());
        rows.heading(look().texts().format("inspector.prefers", name));
        for (Ability ability : Ability.values()) {
            JSlider slider = slider(ability);
            slider.setEnabled(abilities.contains(ability));
            JLabel factor = look().label("", Tone.DIM);
            factor.setHorizontalAlignment(SwingConstants.RIGHT);
            Look.sized(factor, 38, 20);
            JPanel line = new JPanel(new BorderLayout(4, 0));
            line.setOpaque(false);
            line.add(slider, BorderLayout.CENTER);
            line.add(factor, BorderLayout.EAST);
            line.setPreferredSize(new Dimension(100, 26));
            rows.field(look().text("preference." + ability.key()), line);
            slider.getAccessibleContext().setAccessibleName(look().text("preference." + ability.key()));
            sliders.put(ability, slider);
            factors.put(ability, factor);
        }
        if (abilities.contains(Ability.MOVE)) {
            rows.field(look().text("manipulation.grip"), grip);
            rows.field(look().text("manipulation.headings"), headings);
        }
        revalidate();
    }

    private JSlider slider(Ability ability) {
        JSlider slider = new JSlider(-DECADE, OFF, 0);
        slider.setName("preference." + ability.key());
        slider.setUI(new ThinSliderUI(slider, look()));
        slider.setOpaque(false);
        slider.setFocusable(true);
        slider.setToolTipText(look().text("preference.hint"));
        slider.addChangeListener(e -> {
            if (!showing) {
                change(ability, slider);
            }
        });
        return slider;
    }

    private void change(Ability ability, JSlider slider) {
        Scene scene = session().document().scene();
        Optional<Journey> journey = journey(scene);
        if (journey.isEmpty()) {
            return;
        }
        int most = ability == Ability.WALK ? DECADE : OFF;
        double factor = factor(Math.min(most, slider.getValue()));
        Preferences preferences = journey.get().preferences().with(ability, factor);
        Scene changed = SceneEdits.preferring(scene, journey.get(), preferences);
        if (slider.getValueIsAdjusting()) {
            session().document().preview(changed);
        } else {
            String word = look().text("word." + ability.key());
            session().document().commit(look().texts().format("edit.preference", word), changed);
        }
    }

    private void commit(String name, UnaryOperator<Journey> change) {
        Scene scene = session().document().scene();
        journey(scene).ifPresent(j -> session().document().commit(look().text(name), scene.with(change.apply(j))));
    }

    private void show(Preferences preferences) {
        showing = true;
        for (Ability ability : Ability.values()) {
            JSlider slider = sliders.get(ability);
            double factor = preferences.of(ability);
            if (!slider.getValueIsAdjusting()) {
                slider.setValue(position(factor));
            }
            factors.get(ability).setText(word(factor, slider.isEnabled()));
        }
        showing = false;
    }

    private String word(double factor, boolean enabled) {
        if (!enabled) {
            return "\u2013";
        }
        return factor == Preferences.OFF
                ? look().text("preference.off")
                : "\u00d7" + String.format(Locale.ROOT, factor < 1 ? "%.2f" : factor < 10 ? "%.1f" : "%.0f", factor);
    }

    @Override
    public Dimension getMaximumSize() {
        return new Dimension(Integer.MAX_VALUE, getPreferredSize().height);
    }
}
