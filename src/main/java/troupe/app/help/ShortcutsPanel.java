package troupe.app.help;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.List;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListCellRenderer;
import troupe.app.command.Commands;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.app.look.Typed;
import troupe.app.look.widget.ThinScrollBarUI;
import troupe.paint.Tone;

/** Shows the shortcuts under the headings of their menus, those that hold the words typed above. */
public final class ShortcutsPanel extends JPanel {
    private static final int ROW = 26;

    private final transient Look look;
    private final transient List<Shortcuts.Line> lines;
    private final SearchField query;
    private final DefaultListModel<Shortcuts.Line> found = new DefaultListModel<>();

    /** Makes the panel of these commands. */
    public ShortcutsPanel(Look look, Commands commands) {
        super(new BorderLayout(0, 10));
        this.look = look;
        this.lines = Shortcuts.of(commands, look.texts());
        setName("shortcuts.panel");
        setOpaque(false);
        query = new SearchField(look, "shortcuts.query", look.text("shortcuts.find"));
        query.getDocument().addDocumentListener(new Typed(this::find));
        add(query, BorderLayout.NORTH);
        JList<Shortcuts.Line> list = new JList<>(found);
        list.setName("shortcuts.list");
        list.getAccessibleContext().setAccessibleName(look.text("shortcuts.title"));
        list.setBackground(look.color(Tone.PANEL));
        list.setFixedCellHeight(ROW);
        list.setCellRenderer(new Renderer());
        add(ThinScrollBarUI.scroll(list, look), BorderLayout.CENTER);
        find();
    }

    private void find() {
        found.clear();
        String menu = "";
        for (Shortcuts.Line line : Shortcuts.matching(lines, query.getText())) {
            if (!line.menu().equals(menu)) {
                menu = line.menu();
                found.addElement(new Shortcuts.Line(menu, "", ""));
            }
            found.addElement(line);
        }
        if (found.isEmpty()) {
            found.addElement(new Shortcuts.Line(look.text("search.none"), "", ""));
        }
    }

    /** Paints a heading, or a name with its keys to the right. */
    private final class Renderer extends Drawn implements ListCellRenderer<Shortcuts.Line> {
        private transient Shortcuts.Line line;
        private boolean marked;

        @Override
        public Component getListCellRendererComponent(
                JList<? extends Shortcuts.Line> all, Shortcuts.Line value, int index, boolean selected, boolean focus) {
            line = value;
            marked = selected && !value.name().isEmpty();
            setPreferredSize(new Dimension(100, look.px(ROW)));
            getAccessibleContext()
                    .setAccessibleName(value.name().isEmpty() ? value.menu() : value.name() + ", " + value.keys());
            return this;
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            Graphics2D g = Look.smooth(graphics);
            if (marked) {
                g.setColor(look.selected());
                g.fillRoundRect(0, 1, getWidth(), getHeight() - 2, look.px(10), look.px(10));
            }
            int base = getHeight() / 2 + look.px(5);
            if (line.name().isEmpty()) {
                g.setFont(look.bold());
                g.setColor(look.color(Tone.DIM));
                g.drawString(line.menu(), look.px(6), base);
            } else {
                g.setFont(look.font());
                g.setColor(look.color(Tone.TEXT));
                g.drawString(line.name(), look.px(18), base);
                int right = getWidth() - look.px(12) - g.getFontMetrics().stringWidth(line.keys());
                g.setColor(look.color(Tone.DIM));
                g.drawString(line.keys(), right, base);
            }
            g.dispose();
        }
    }
}
