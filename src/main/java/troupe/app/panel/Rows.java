package troupe.app.panel;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.GridLayout;
import java.awt.Insets;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import troupe.app.look.Look;
import troupe.app.look.Prose;
import troupe.paint.Tone;

/** Lays out rows of a dim label and its field, under a heading. */
public final class Rows {
    private static final int LABEL = 96;
    private static final int HEIGHT = 29;
    private final JPanel panel;
    private final Look look;
    private int row;

    /** Begins the rows of a panel; what it held is removed. */
    public Rows(JPanel panel, Look look) {
        this.panel = panel;
        this.look = look;
        panel.removeAll();
        panel.setLayout(new GridBagLayout());
    }

    /** Adds a heading, in as many lines as it takes. */
    public Rows heading(String text) {
        Prose heading = new Prose(look, text);
        heading.setFont(look.bold(13));
        heading.setColumns(8);
        heading.setOpaque(false);
        heading.setFocusable(false);
        heading.getAccessibleContext().setAccessibleName(text);
        add(heading, 0, 2, new Insets(0, 0, 8, 0));
        return this;
    }

    /** Adds a small heading of a group of rows. */
    public Rows subheading(String text) {
        JLabel label = look.label(text, Tone.DIM);
        label.setFont(look.bold(11.5f));
        add(label, 0, 2, new Insets(8, 0, 2, 0));
        return this;
    }

    /** Adds a label with the fields that belong to it. */
    public Rows field(String text, JComponent... fields) {
        JLabel label = look.label(text, Tone.DIM);
        label.setLabelFor(fields[0]);
        fields[0].getAccessibleContext().setAccessibleName(text);
        Look.sized(label, LABEL, HEIGHT);
        GridBagConstraints at = new GridBagConstraints();
        at.gridx = 0;
        at.gridy = row;
        at.anchor = GridBagConstraints.WEST;
        panel.add(label, at);
        JPanel group = new JPanel(new GridLayout(1, fields.length, 6, 0));
        group.setOpaque(false);
        for (JComponent field : fields) {
            group.add(field);
        }
        group.setPreferredSize(new Dimension(60, fields[0].getPreferredSize().height));
        add(group, 1, 1, new Insets(0, 0, 0, 0));
        return this;
    }

    /** Adds a part as wide as the panel. */
    public Rows wide(Component part, int below) {
        add(part, 0, 2, new Insets(0, 0, below, 0));
        return this;
    }

    private void add(Component part, int column, int width, Insets insets) {
        GridBagConstraints at = new GridBagConstraints();
        at.gridx = column;
        at.gridy = row;
        at.gridwidth = width;
        at.weightx = 1;
        at.fill = GridBagConstraints.HORIZONTAL;
        at.insets = insets;
        panel.add(part, at);
        row++;
    }
}
