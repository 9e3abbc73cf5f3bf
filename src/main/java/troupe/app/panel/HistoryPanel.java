package troupe.app.panel;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractListModel;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import troupe.app.document.UndoHistory;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.app.look.widget.ThinScrollBarUI;
import troupe.app.session.Session;
import troupe.paint.Tone;

/** Lists the steps of the undo history, those that were taken back dim; a click, or an arrow key, goes there. */
public final class HistoryPanel extends Panel {
    private static final int ROW = 22;
    private final Steps steps = new Steps();
    private final JList<String> list = new JList<>(steps);
    private boolean showing;

    /** Makes the list. */
    public HistoryPanel(Look look, Session session) {
        super(look, session, new BorderLayout());
        setName("history");
        setPreferredSize(new Dimension(100, 240));
        setBorder(look.line(1, 0, 0, 0));
        JLabel heading = look.label(look.text("history.name"), Tone.DIM);
        heading.setFont(look.bold(11.5f));
        heading.setBorder(BorderFactory.createEmptyBorder(8, 14, 4, 14));
        add(heading, BorderLayout.NORTH);
        list.setName("history.list");
        list.setBackground(look.color(Tone.PANEL));
        list.setFixedCellHeight(ROW);
        list.setFixedCellWidth(100);
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new Renderer());
        list.getAccessibleContext().setAccessibleName(look.text("history.name"));
        list.addListSelectionListener(e -> {
            if (!showing && !e.getValueIsAdjusting() && list.getSelectedIndex() >= 0) {
                session.document().history().jump(list.getSelectedIndex());
            }
        });
        add(ThinScrollBarUI.scroll(list, look), BorderLayout.CENTER);
        observing(session.document().history().listeners().add(h -> refresh()));
        refresh();
    }

    private void refresh() {
        UndoHistory history = session().document().history();
        showing = true;
        List<String> names = new ArrayList<>();
        names.add(look().text("history.begin"));
        names.addAll(history.names());
        steps.show(names);
        list.setSelectedIndex(history.position());
        list.ensureIndexIsVisible(history.position());
        showing = false;
        list.repaint();
    }

    /** Holds the names of the steps. */
    private static final class Steps extends AbstractListModel<String> {
        private List<String> names = List.of();

        void show(List<String> changed) {
            int before = names.size();
            names = changed;
            fireContentsChanged(this, 0, Math.max(before, names.size()));
        }

        @Override
        public int getSize() {
            return names.size();
        }

        @Override
        public String getElementAt(int index) {
            return names.get(index);
        }
    }

    /** Paints one step. */
    private final class Renderer extends Drawn implements ListCellRenderer<String> {
        private String step = "";
        private boolean present;
        private boolean undone;

        @Override
        public Component getListCellRendererComponent(
                JList<? extends String> all, String value, int index, boolean selected, boolean focused) {
            step = value;
            present = selected;
            undone = index > list.getSelectedIndex();
            getAccessibleContext().setAccessibleName(value);
            return this;
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            Graphics2D g = Look.smooth(graphics);
            if (present) {
                g.setColor(look().selected());
                g.fillRect(0, 0, getWidth(), getHeight());
            }
            g.setFont(look().font());
            g.setColor(undone ? look().mix(Tone.DIM, Tone.PANEL, 0.6) : look().color(Tone.TEXT));
            g.drawString(
                    Ellipsis.fit(step, g.getFontMetrics(), getWidth() - look().px(28)),
                    look().px(14),
                    getHeight() / 2 + look().px(4));
            g.dispose();
        }
    }
}
