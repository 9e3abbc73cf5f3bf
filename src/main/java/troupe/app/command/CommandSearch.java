package troupe.app.command;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.DefaultListModel;
import javax.swing.JLayeredPane;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.app.look.Typed;
import troupe.app.look.widget.ThinScrollBarUI;
import troupe.paint.Tone;

/** Finds commands by their words; Enter does the one that is marked, Escape closes. */
public final class CommandSearch extends JPanel {
    private static final int WIDTH = 380;
    private static final int ROW = 28;
    private static final int ROWS = 9;

    private final transient Look look;
    private final transient Commands commands;
    private final transient Runnable close;
    private final JTextField query = new JTextField();
    private final DefaultListModel<Command> found = new DefaultListModel<>();
    private final JList<Command> list = new JList<>(found) {
        @Override
        protected void paintComponent(Graphics graphics) {
            super.paintComponent(graphics);
            if (found.isEmpty()) {
                Graphics2D g = Look.smooth(graphics);
                g.setFont(look.font());
                g.setColor(look.color(Tone.DIM));
                g.drawString(look.text("search.none"), look.px(10), look.px(ROW / 2.0 + 4));
                g.dispose();
            }
        }
    };

    /** Makes the search; {@code close} takes it off the window. */
    public CommandSearch(Look look, Commands commands, Runnable close) {
        super(new BorderLayout(0, 6));
        this.look = look;
        this.commands = commands;
        this.close = close;
        setName("search");
        setBackground(look.color(Tone.PANEL));
        setBorder(BorderFactory.createCompoundBorder(
                BorderFactory.createLineBorder(look.color(Tone.LINE)), BorderFactory.createEmptyBorder(8, 8, 8, 8)));
        query.setName("search.query");
        query.setFont(look.font());
        query.getAccessibleContext().setAccessibleName(look.text("command.search"));
        query.getDocument().addDocumentListener(new Typed(this::find));
        list.setName("search.list");
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setFixedCellHeight(ROW);
        list.setBackground(look.color(Tone.PANEL));
        list.setCellRenderer(new Renderer());
        list.setFocusable(false);
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                perform();
            }
        });
        add(query, BorderLayout.NORTH);
        add(ThinScrollBarUI.scroll(list, look), BorderLayout.CENTER);
        key("ENTER", this::perform);
        key("ESCAPE", close);
        key("DOWN", () -> mark(1));
        key("UP", () -> mark(-1));
        setSize(new Dimension(look.px(WIDTH), look.px(ROWS * ROW + 60)));
        find();
    }

    /** Opens the search over a window, unless it is open; {@code closed} is run when it is closed. */
    public static void open(JLayeredPane layers, Look look, Commands commands, Runnable closed) {
        for (Component part : layers.getComponentsInLayer(JLayeredPane.POPUP_LAYER)) {
            if (part instanceof CommandSearch) {
                return;
            }
        }
        CommandSearch[] search = new CommandSearch[1];
        search[0] = new CommandSearch(look, commands, () -> {
            layers.remove(search[0]);
            layers.repaint();
            closed.run();
        });
        search[0].setLocation((layers.getWidth() - search[0].getWidth()) / 2, look.px(48));
        layers.add(search[0], JLayeredPane.POPUP_LAYER);
        search[0].validate();
        layers.repaint();
        search[0].query().requestFocusInWindow();
    }

    /** Returns the field for the words. */
    public JTextField query() {
        return query;
    }

    private void key(String stroke, Runnable action) {
        query.getInputMap().put(KeyStroke.getKeyStroke(stroke), "search." + stroke);
        query.getActionMap().put("search." + stroke, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    private void find() {
        found.clear();
        found.addAll(commands.search(query.getText()));
        list.getAccessibleContext().setAccessibleName(look.text(found.isEmpty() ? "search.none" : "command.search"));
        list.repaint();
        list.setSelectedIndex(0);
    }

    private void mark(int by) {
        if (!found.isEmpty()) {
            int index = Math.floorMod(list.getSelectedIndex() + by, found.size());
            list.setSelectedIndex(index);
            list.ensureIndexIsVisible(index);
        }
    }

    private void perform() {
        Command command = list.getSelectedValue();
        if (command != null && command.isEnabled()) {
            close.run();
            command.perform();
        }
    }

    /** Paints a command with its menu and its shortcut. */
    private final class Renderer extends Drawn implements ListCellRenderer<Command> {
        private transient Command command;
        private boolean marked;

        @Override
        public Component getListCellRendererComponent(
                JList<? extends Command> all, Command value, int index, boolean selected, boolean focused) {
            command = value;
            marked = selected;
            getAccessibleContext().setAccessibleName(value.name() + " " + value.shortcut());
            return this;
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            Graphics2D g = Look.smooth(graphics);
            if (marked) {
                g.setColor(look.selected());
                g.fillRoundRect(0, 1, getWidth(), getHeight() - 2, 10, 10);
            }
            g.setFont(look.font());
            int base = getHeight() / 2 + look.px(4);
            g.setColor(command.isEnabled() ? look.color(Tone.TEXT) : look.mix(Tone.DIM, Tone.PANEL, 0.6));
            g.drawString(command.name(), look.px(10), base);
            g.setColor(look.color(Tone.DIM));
            String right = command.shortcut();
            g.drawString(right, getWidth() - look.px(10) - g.getFontMetrics().stringWidth(right), base);
            g.dispose();
        }
    }
}
