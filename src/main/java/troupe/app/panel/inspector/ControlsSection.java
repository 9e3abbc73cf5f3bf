package troupe.app.panel.inspector;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.GridBagLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.SwingConstants;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.look.widget.ThinSliderUI;
import troupe.app.panel.Panel;
import troupe.app.panel.Rows;
import troupe.app.plan.Plan;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.run.Run;
import troupe.run.Simulation;

/**
 * Shows a slider for each value that can be set while a simulation runs. Moving one takes hold of the simulation at
 * the moment shown; what comes after it is simulated anew. A double click gives back the value of the scene.
 */
final class ControlsSection extends Panel {
    private static final int STEPS = 400;

    private final transient Map<String, JSlider> sliders = new LinkedHashMap<>();
    private final transient Map<String, JLabel> values = new LinkedHashMap<>();
    private transient List<Simulation.Control> shown = List.of();
    /** What was given until the moment shown last; null where the sliders have to be set in any case. */
    private transient Map<String, Double> told;

    private boolean showing;
    private boolean held;

    ControlsSection(Look look, Session session) {
        super(look, session, new GridBagLayout());
        setName("controls");
        observing(session.plans().add(this::refresh));
        observing(session.playback().listeners().add(p -> session.plan().ifPresent(this::refresh)));
        setVisible(false);
        session.plan().ifPresent(this::refresh);
    }

    private void refresh(Plan plan) {
        List<Simulation.Control> controls = plan.live().controls().stream()
                .filter(c -> !c.key().startsWith("avatar."))
                .toList();
        if (!controls.equals(shown)) {
            shown = controls;
            build();
        }
        setVisible(!shown.isEmpty());
        if (!held) {
            plan.run().ifPresent(this::show);
        }
    }

    private void build() {
        told = null;
        sliders.clear();
        values.clear();
        Rows rows = new Rows(this, look());
        rows.heading(look().text("inspector.controls"));
        String group = "";
        for (Simulation.Control control : shown) {
            String[] parts = control.key().split("\\.");
            String depth = parts.length == 3 ? parts[1] : "";
            if (!depth.equals(group)) {
                rows.subheading(look().texts().format("control.depth", depth));
                group = depth;
            }
            JSlider slider = slider(control);
            JLabel value = look().label("", Tone.DIM);
            value.setHorizontalAlignment(SwingConstants.RIGHT);
            Look.sized(value, 38, 20);
            JPanel line = new JPanel(new BorderLayout(4, 0));
            line.setOpaque(false);
            line.add(slider, BorderLayout.CENTER);
            line.add(value, BorderLayout.EAST);
            line.setPreferredSize(new Dimension(100, 26));
            String word = look().texts().get("control." + parts[parts.length - 1], control.key());
            rows.field(word, line);
            slider.getAccessibleContext().setAccessibleName(depth.isEmpty() ? word : word + " " + depth);
            sliders.put(control.key(), slider);
            values.put(control.key(), value);
        }
        revalidate();
    }

    private JSlider slider(Simulation.Control control) {
        JSlider slider = new JSlider(0, STEPS, position(control, control.value()));
        slider.setName("control." + control.key());
        slider.setUI(new ThinSliderUI(slider, look()));
        slider.setOpaque(false);
        slider.setToolTipText(look().text("control.hint"));
        slider.addChangeListener(e -> {
            if (!showing) {
                change(control, slider);
            }
        });
        slider.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                if (event.getClickCount() == 2) {
                    slider.setValue(position(control, control.value()));
                }
            }
        });
        return slider;
    }

    private void change(Simulation.Control control, JSlider slider) {
        if (!held) {
            held = true;
            told = null;
            session().grab();
        }
        double value = value(control, slider.getValue());
        session().steer(control.key(), value);
        values.get(control.key()).setText(Texts.number(value, 2));
        if (!slider.getValueIsAdjusting()) {
            held = false;
            session().release();
        }
    }

    /** Returns the position of a value: the slider is finer at its lower end, where most values lie. */
    private static int position(Simulation.Control control, double value) {
        double share = (value - control.min()) / Math.max(1e-12, control.max() - control.min());
        return (int) Math.rint(Math.sqrt(share) * STEPS);
    }

    private static double value(Simulation.Control control, int position) {
        double share = (double) position / STEPS;
        return control.min() + (control.max() - control.min()) * share * share;
    }

    /** Shows the values that hold at the moment shown. */
    private void show(Run run) {
        long step = Math.round(session().playback().time() * run.frames().rate());
        Map<String, Double> now = new LinkedHashMap<>();
        for (Run.Input input : run.inputs()) {
            if (input.step() <= step + 1) {
                now.put(input.key(), input.value());
            }
        }
        if (now.equals(told)) {
            return;
        }
        told = now;
        showing = true;
        for (Simulation.Control control : shown) {
            double value = now.getOrDefault(control.key(), control.value());
            sliders.get(control.key()).setValue(position(control, value));
            values.get(control.key()).setText(Texts.number(value, 2));
        }
        showing = false;
    }

    @Override
    public Dimension getMaximumSize() {
        return new Dimension(Integer.MAX_VALUE, getPreferredSize().height);
    }
}
