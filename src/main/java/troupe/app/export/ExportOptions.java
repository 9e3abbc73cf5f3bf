package troupe.app.export;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListSelectionModel;
import troupe.app.look.Look;
import troupe.app.look.widget.FlatButton;
import troupe.app.look.widget.NumberField;
import troupe.exchange.Formats;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.Exporter;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.picture.Picture;
import troupe.paint.solid.Camera;

/** Lets a format be chosen, and what concerns it: instant, width, rate, theme, and from where it is seen. */
final class ExportOptions {
    private static final Set<String> STILL = Set.of("svg", "png");
    private static final Set<String> MOVING = Set.of("gif", "pngs");
    private static final double MOST_RATE = 50;

    private final Look look;
    private final Runnable changed;
    private final double duration;
    private final Camera.Angle angle;
    private final JPanel panel = new JPanel(new BorderLayout(0, 12));
    private final JPanel fields = new JPanel(new GridBagLayout());
    private final JList<Exporter> formats = new JList<>(Formats.exporters().toArray(new Exporter[0]));
    private ExportSettings settings;

    /** Makes the options; {@code changed} is told after each choice. */
    ExportOptions(Look look, ExportSettings first, double duration, Runnable changed) {
        this.look = look;
        this.changed = changed;
        this.duration = duration;
        this.angle = first.angle().orElse(Camera.Angle.DEFAULT);
        this.settings = new ExportSettings(
                first.time(),
                first.width(),
                first.density(),
                first.rate(),
                first.theme(),
                first.overlays(),
                Optional.empty(),
                first.stopped());
        formats.setName("export.formats");
        formats.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        formats.setFixedCellHeight(30);
        formats.setBackground(look.color(Tone.PANEL));
        formats.setCellRenderer(new Renderer());
        formats.getAccessibleContext().setAccessibleName(look.text("export.format"));
        formats.setSelectedValue(Formats.exporter("png"), false);
        formats.addListSelectionListener(e -> {
            if (!e.getValueIsAdjusting()) {
                refresh();
                changed.run();
            }
        });
        panel.setOpaque(false);
        panel.setPreferredSize(new Dimension(340, 300));
        fields.setOpaque(false);
        panel.add(formats, BorderLayout.CENTER);
        panel.add(fields, BorderLayout.SOUTH);
        refresh();
    }

    /** Returns the part to show. */
    JComponent panel() {
        return panel;
    }

    /** Returns the format chosen. */
    Exporter exporter() {
        return formats.getSelectedValue() == null ? Formats.exporter("png") : formats.getSelectedValue();
    }

    /** Returns the settings chosen. */
    ExportSettings settings() {
        return settings;
    }

    /** Returns how many pictures the export makes. */
    int pictures() {
        return MOVING.contains(exporter().name()) ? (int) Math.ceil(duration * settings.rate()) + 1 : 1;
    }

    private void refresh() {
        fields.removeAll();
        String name = exporter().name();
        if (STILL.contains(name)) {
            add("export.time", number("s", 2, settings.time(), 0, duration, v -> settings.at(v)));
        }
        if (MOVING.contains(name)) {
            add("export.rate", number("/ s", 0, settings.rate(), 1, MOST_RATE, v -> settings.every(v)));
        }
        if (Preview.PICTURES.contains(name)) {
            add(
                    "export.width",
                    number(
                            "px",
                            0,
                            settings.width(),
                            Picture.MIN_WIDTH,
                            Picture.MAX_WIDTH,
                            v -> settings.wide((int) Math.round(v))));
            add(
                    "export.theme",
                    choice(
                            "theme",
                            settings.theme() == Theme.DARK ? 1 : 0,
                            List.of("light", "dark"),
                            k -> settings.in(k == 1 ? Theme.DARK : Theme.LIGHT)));
            add(
                    "export.view",
                    choice("view", settings.angle().isPresent() ? 1 : 0, List.of("plan", "solid"), this::seen));
        }
        fields.revalidate();
        fields.repaint();
    }

    private ExportSettings seen(int k) {
        return new ExportSettings(
                settings.time(),
                settings.width(),
                settings.density(),
                settings.rate(),
                settings.theme(),
                settings.overlays(),
                k == 1 ? Optional.of(angle) : Optional.empty(),
                settings.stopped());
    }

    private void take(ExportSettings other) {
        settings = other;
        changed.run();
    }

    private void add(String key, JComponent field) {
        JLabel label = look.label(look.text(key), Tone.DIM);
        label.setLabelFor(field);
        GridBagConstraints at = new GridBagConstraints();
        at.gridx = 0;
        at.gridy = fields.getComponentCount();
        at.anchor = GridBagConstraints.WEST;
        at.insets = new Insets(3, 0, 3, 12);
        fields.add(label, at);
        at.gridx = 1;
        at.weightx = 1;
        at.fill = GridBagConstraints.HORIZONTAL;
        at.insets = new Insets(3, 0, 3, 0);
        field.getAccessibleContext().setAccessibleName(look.text(key));
        field.setName(key);
        fields.add(field, at);
    }

    private interface Taken {
        ExportSettings of(double value);
    }

    private NumberField number(String unit, int decimals, double shown, double least, double most, Taken taken) {
        NumberField field = new NumberField(look, unit, decimals);
        field.onNumber(v -> v >= least && v <= most, v -> take(taken.of(v)));
        field.show(shown);
        return field;
    }

    private interface Chosen {
        ExportSettings of(int index);
    }

    private JComponent choice(String group, int on, List<String> words, Chosen chosen) {
        JPanel row = new JPanel(new FlowLayout(FlowLayout.LEFT, 6, 0));
        row.setOpaque(false);
        for (int k = 0; k < words.size(); k++) {
            int index = k;
            FlatButton chip = new FlatButton(look, FlatButton.Style.CHIP);
            chip.setText(look.text("export." + group + "." + words.get(k)));
            chip.setName("export." + group + "." + words.get(k));
            chip.setSelected(k == on);
            chip.addActionListener(e -> {
                for (Component other : row.getComponents()) {
                    ((FlatButton) other).setSelected(other == chip);
                }
                take(chosen.of(index));
            });
            row.add(chip);
        }
        return row;
    }

    /** Shows a format with what it is for. */
    private final class Renderer extends DefaultListCellRenderer {
        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object value, int index, boolean selected, boolean focused) {
            Exporter exporter = (Exporter) value;
            super.getListCellRendererComponent(list, value, index, false, false);
            String about = look.texts().get("export.about." + exporter.name(), exporter.about());
            setText("<html><nobr><b>" + exporter.name().toUpperCase(Locale.ROOT) + "</b>&nbsp;&nbsp;" + about
                    + "</nobr></html>");
            setToolTipText(about);
            setFont(look.font());
            setOpaque(true);
            setForeground(look.color(Tone.TEXT));
            setBackground(selected ? look.selected() : look.color(Tone.PANEL));
            setBorder(BorderFactory.createEmptyBorder(0, look.px(10), 0, look.px(8)));
            return this;
        }
    }
}
