package troupe.app.compare;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import troupe.app.look.Look;
import troupe.app.look.Prose;
import troupe.app.look.Scaling;
import troupe.app.look.widget.ThinScrollBarUI;
import troupe.app.session.Comparison;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.run.Report;

/** Shows the reports of the run that is shown and the one that is kept side by side, with what differs marked. */
final class CompareDialog {
    private static final List<Integer> WIDTHS = List.of(220, 225, 225, 100);

    private final Look look;
    private final ReportWords words;
    private final Session session;
    private final JDialog dialog;
    private final JLabel names;
    private final Model model = new Model();
    private final List<Runnable> leave = new ArrayList<>();

    CompareDialog(JFrame over, Look look, Session session) {
        this.look = look;
        this.session = session;
        this.dialog = new JDialog(over, look.text("compare.title"), false);
        this.names = look.label(" ", Tone.DIM);
        words = new ReportWords(look.texts());
        dialog.setName("compare");
        JTable table = new JTable(model);
        table.setName("compare.table");
        table.setFont(look.font());
        table.setRowHeight(look.px(22));
        table.setShowGrid(false);
        table.setBackground(look.color(Tone.PANEL));
        table.setForeground(look.color(Tone.TEXT));
        table.getTableHeader().setFont(look.font());
        table.getTableHeader().setReorderingAllowed(false);
        table.getTableHeader().setBackground(look.color(Tone.PANEL));
        table.getTableHeader().setForeground(look.color(Tone.DIM));
        table.getTableHeader().setDefaultRenderer(new Head());
        table.setFillsViewportHeight(true);
        table.setDefaultRenderer(Object.class, new Renderer());
        table.getAccessibleContext().setAccessibleName(look.text("compare.title"));
        JPanel all = new JPanel(new BorderLayout(0, 10));
        all.setBackground(look.color(Tone.PANEL));
        all.setBorder(BorderFactory.createEmptyBorder(14, 16, 14, 16));
        all.add(names, BorderLayout.NORTH);
        JScrollPane scroll = ThinScrollBarUI.scroll(table, look);
        // a table gives its pane a frame, unless the pane has a border
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setColumnHeaderView(table.getTableHeader());
        all.add(scroll, BorderLayout.CENTER);
        Prose marks = new Prose(look, look.text("compare.marks"));
        marks.setOpaque(false);
        marks.setForeground(look.color(Tone.DIM));
        all.add(marks, BorderLayout.SOUTH);
        dialog.setContentPane(new Scaling(look::scale).apply(all));
        dialog.setSize(new Dimension(look.px(WIDTHS.stream().mapToInt(w -> w).sum() + 50), look.px(500)));
        dialog.setLocationRelativeTo(over);
        dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
        dialog.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                leave.forEach(Runnable::run);
                leave.clear();
            }
        });
        leave.add(session.plans().add(plan -> refresh()));
        leave.add(session.comparison().listeners().add(c -> refresh()));
        for (int column = 0; column < WIDTHS.size(); column++) {
            table.getColumnModel().getColumn(column).setPreferredWidth(look.px(WIDTHS.get(column)));
        }
        refresh();
    }

    void show() {
        dialog.setVisible(true);
    }

    void close() {
        dialog.dispose();
    }

    private void refresh() {
        Optional<Comparison.Kept> kept = session.comparison().kept();
        if (kept.isEmpty()) {
            dialog.dispose();
            return;
        }
        Report shown =
                session.run().map(run -> run.report()).orElse(Report.builder().build());
        model.show(ReportTable.rows(shown, kept.get().run().report()));
        names.setText(look.texts().format("compare.names", kept.get().name(), model.differing()));
    }

    /** The rows of the table. */
    private final class Model extends AbstractTableModel {
        private transient List<ReportTable.Row> rows = List.of();

        void show(List<ReportTable.Row> other) {
            if (!rows.equals(other)) {
                rows = other;
                fireTableDataChanged();
            }
        }

        long differing() {
            return rows.stream().filter(ReportTable.Row::differs).count();
        }

        @Override
        public int getRowCount() {
            return rows.size();
        }

        @Override
        public int getColumnCount() {
            return 4;
        }

        @Override
        public String getColumnName(int column) {
            return look.text(
                    "compare." + List.of("value", "shown", "kept", "change").get(column));
        }

        @Override
        public Object getValueAt(int row, int column) {
            ReportTable.Row at = rows.get(row);
            return List.of(words.name(at.name()), words.value(at.shown()), words.value(at.kept()), at.change())
                    .get(column);
        }
    }

    /** Shows the words above the columns where those below stand, on a thin line. */
    private final class Head extends DefaultTableCellRenderer {
        @Override
        public Component getTableCellRendererComponent(
                JTable table, Object value, boolean selected, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(table, value, false, false, row, column);
            setHorizontalAlignment(column == 0 ? LEFT : RIGHT);
            setFont(look.font());
            setForeground(look.color(Tone.DIM));
            setBackground(look.color(Tone.PANEL));
            setBorder(BorderFactory.createCompoundBorder(
                    look.line(0, 0, 1, 0),
                    BorderFactory.createEmptyBorder(look.px(4), look.px(8), look.px(5), look.px(8))));
            return this;
        }
    }

    /** Shows numbers at the right, and what differs in bold on a tint. */
    private final class Renderer extends DefaultTableCellRenderer {
        @Override
        public Component getTableCellRendererComponent(
                JTable table, Object value, boolean selected, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(table, value, false, false, row, column);
            boolean differs = model.rows.get(row).differs();
            setHorizontalAlignment(column == 0 ? LEFT : RIGHT);
            setFont(differs ? look.bold() : look.font());
            setForeground(look.color(differs || column != 0 ? Tone.TEXT : Tone.DIM));
            setBackground(differs ? look.selected() : look.color(Tone.PANEL));
            setBorder(BorderFactory.createEmptyBorder(0, look.px(8), 0, look.px(8)));
            setToolTipText(column == 0 ? model.rows.get(row).name() : String.valueOf(value));
            return this;
        }
    }
}
