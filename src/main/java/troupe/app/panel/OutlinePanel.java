package troupe.app.panel;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import javax.swing.BorderFactory;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.app.look.widget.ThinScrollBarUI;
import troupe.app.session.Session;
import troupe.paint.Tone;

/** Lists what the scene holds: layers, actors, obstacles, tasks, problems. A click selects. */
public final class OutlinePanel extends Panel {
    private static final int ROW = 26;
    private static final int INDENT = 14;
    private final DefaultListModel<OutlineRow> rows = new DefaultListModel<>();
    private final JList<OutlineRow> list = new JList<>(rows);
    private final transient Consumer<String> zoom;
    private boolean showing;

    /** Makes the outline; {@code zoom} shows the element of an id. */
    public OutlinePanel(Look look, Session session, Consumer<String> zoom) {
        super(look, session, new BorderLayout());
        this.zoom = zoom;
        setName("outline");
        setBorder(look.line(0, 0, 0, 1));
        setMinimumSize(new Dimension(150, 100));
        setPreferredSize(new Dimension(228, 100));
        list.setName("outline.list");
        list.setBackground(look.color(Tone.PANEL));
        list.setBorder(BorderFactory.createEmptyBorder(2, 0, 8, 0));
        list.setSelectionMode(ListSelectionModel.MULTIPLE_INTERVAL_SELECTION);
        list.setCellRenderer(new Renderer());
        list.getAccessibleContext().setAccessibleName(look.text("outline.name"));
        list.addListSelectionListener(e -> {
            if (!showing && !e.getValueIsAdjusting()) {
                choose(list.getSelectedValuesList());
            }
        });
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                OutlineRow row = list.getSelectedValue();
                if (event.getClickCount() == 2 && row != null && !row.ids().isEmpty()) {
                    zoom.accept(row.ids().get(0));
                }
            }
        });
        add(ThinScrollBarUI.scroll(list, look), BorderLayout.CENTER);
        observing(session.document().listeners().add(change -> refresh()));
        observing(session.plans().add(plan -> refresh()));
        observing(session.selection().listeners().add(s -> mark()));
        observing(session.overlays().listeners().add(o -> mark()));
        refresh();
    }

    private void choose(List<OutlineRow> chosen) {
        session()
                .selection()
                .set(chosen.stream()
                        .filter(row -> row.kind() == OutlineRow.Kind.THING || row.kind() == OutlineRow.Kind.TASK)
                        .flatMap(row -> row.ids().stream())
                        .toList());
        for (OutlineRow row : chosen) {
            switch (row.kind()) {
                case TASK -> session().document().lookAt(row.ids().get(0));
                case LAYER -> session().overlays().lookAt(row.layer());
                case PROBLEM -> {
                    if (!row.ids().isEmpty()) {
                        session().selection().set(row.ids());
                        zoom.accept(row.ids().get(0));
                    }
                }
                default -> {
                    // headings choose nothing
                }
            }
        }
        mark();
    }

    private void refresh() {
        List<OutlineRow> now = OutlineRow.of(session(), look());
        List<OutlineRow> before =
                IntStream.range(0, rows.size()).mapToObj(rows::get).toList();
        if (!now.equals(before)) {
            showing = true;
            rows.clear();
            rows.addAll(now);
            showing = false;
        }
        mark();
    }

    /** Marks the rows of what is selected in the session. */
    private void mark() {
        showing = true;
        int[] marked = IntStream.range(0, rows.size())
                .filter(i -> isSelected(rows.get(i)))
                .toArray();
        list.setSelectedIndices(marked);
        if (marked.length == 1) {
            Rectangle cell = list.getCellBounds(marked[0], marked[0]);
            if (cell != null && list.isShowing() && !list.getVisibleRect().contains(cell)) {
                list.scrollRectToVisible(cell);
            }
        }
        showing = false;
        list.repaint();
    }

    private boolean isSelected(OutlineRow row) {
        return row.kind() != OutlineRow.Kind.PROBLEM
                && !row.ids().isEmpty()
                && row.ids().stream().allMatch(session().selection()::contains);
    }

    /** Tells whether the row is what is looked at, though not selected: the task, the layer. */
    private boolean current(OutlineRow row) {
        return switch (row.kind()) {
            case TASK -> row.ids().contains(session().document().task());
            case LAYER -> row.layer() == session().overlays().layer();
            default -> false;
        };
    }

    /** Paints one row. */
    private final class Renderer extends Drawn implements ListCellRenderer<OutlineRow> {
        private transient OutlineRow row;
        private boolean selected;
        private boolean marked;

        @Override
        public Component getListCellRendererComponent(
                JList<? extends OutlineRow> all, OutlineRow value, int index, boolean chosen, boolean focused) {
            row = value;
            selected = chosen || current(value);
            marked = focused && all.isFocusOwner();
            boolean heading = value.kind() == OutlineRow.Kind.HEADING;
            setPreferredSize(new Dimension(100, look().px(heading ? ROW + 6 : ROW)));
            getAccessibleContext().setAccessibleName(value.name() + " " + value.note());
            setToolTipText(value.kind() == OutlineRow.Kind.PROBLEM ? value.hint() : value.name());
            return this;
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            Graphics2D g = Look.smooth(graphics);
            int base = getHeight() / 2 + look().px(4);
            if (row.kind() == OutlineRow.Kind.HEADING) {
                g.setFont(look().bold(11.5f));
                g.setColor(look().color(Tone.DIM));
                g.drawString(row.name(), look().px(14), base + look().px(3));
                g.dispose();
                return;
            }
            if (selected) {
                g.setColor(look().selected());
                g.fillRect(0, 0, getWidth(), getHeight());
            }
            if (marked) {
                g.setColor(look().color(Tone.ACCENT));
                g.drawRect(0, 0, getWidth() - 1, getHeight() - 1);
            }
            g.translate(look().px(row.depth() * INDENT), 0);
            paintSwatch(g, row.color(), row.round());
            g.translate(-look().px(row.depth() * INDENT), 0);
            g.setFont(look().font());
            g.setColor(look().color(Tone.DIM));
            int noteWidth = g.getFontMetrics().stringWidth(row.note());
            g.drawString(row.note(), getWidth() - look().px(14) - noteWidth, base);
            g.setColor(look().color(Tone.TEXT));
            int left = 34 + row.depth() * INDENT;
            int room = getWidth() - noteWidth - look().px(14 + 4 + left);
            g.drawString(Ellipsis.fit(row.name(), g.getFontMetrics(), room), look().px(left), base);
            g.dispose();
        }

        private void paintSwatch(Graphics2D graphics, Color color, boolean round) {
            Graphics2D g = (Graphics2D) graphics.create();
            g.translate(look().px(15), getHeight() / 2.0 - look().px(5));
            g.scale(look().scale(), look().scale());
            g.setColor(color);
            g.fillRoundRect(0, 0, 11, 11, round ? 11 : 5, round ? 11 : 5);
            if (color.equals(look().color(Tone.FLOOR))) {
                g.setColor(look().color(Tone.DIM));
                g.drawRoundRect(0, 0, 10, 10, 5, 5);
            }
            g.dispose();
        }
    }
}
