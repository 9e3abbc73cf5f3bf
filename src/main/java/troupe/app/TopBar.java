package troupe.app;

import java.awt.Dimension;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import troupe.app.command.Command;
import troupe.app.command.Commands;
import troupe.app.look.Look;
import troupe.app.look.widget.FlatButton;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.scene.Task;

/** The bar at the top: menus, the name of the document, the task, the search, live planning. */
final class TopBar extends JMenuBar {
    /** After start page, new and open. */
    private static final int RECENT_AT = 3;

    private final transient Look look;
    private final transient Session session;
    private final JLabel title = new JLabel("", SwingConstants.CENTER);
    private final FlatButton task;
    private transient Runnable leave = () -> {};

    TopBar(Look look, Session session, Commands commands, JMenu recent, Runnable search) {
        this.look = look;
        this.session = session;
        setName("top");
        setBackground(look.color(Tone.PANEL));
        setBorder(BorderFactory.createCompoundBorder(
                look.line(0, 0, 1, 0), BorderFactory.createEmptyBorder(0, 12, 0, 12)));
        setPreferredSize(new Dimension(100, 41));
        JLabel name = look.label("Troupe", Tone.TEXT);
        name.setFont(look.bold(13));
        add(name);
        add(Box.createHorizontalStrut(12));
        for (JMenu menu : commands.menus()) {
            menu.setFont(look.font());
            if (menu.getName().equals("menu.file")) {
                menu.add(recent, RECENT_AT);
            }
            add(menu);
        }
        title.setFont(look.font());
        title.setForeground(look.color(Tone.DIM));
        title.setName("top.title");
        title.setMinimumSize(new Dimension(0, 20));
        add(Box.createHorizontalGlue());
        add(title);
        add(Box.createHorizontalGlue());
        task = new FlatButton(look, FlatButton.Style.PILL);
        task.setName("top.task");
        task.setHint("\u25be");
        task.addActionListener(e -> chooseTask());
        add(fixed(task));
        add(Box.createHorizontalStrut(8));
        add(fixed(searchButton(commands.get("search"), search)));
        add(Box.createHorizontalStrut(8));
        FlatButton live = new FlatButton(look, FlatButton.Style.ACCENT, commands.get("live"));
        live.setIcon(null);
        live.setName("top.live");
        add(fixed(live));
    }

    private FlatButton searchButton(Command command, Runnable search) {
        FlatButton button = new FlatButton(look, FlatButton.Style.PILL);
        button.setText(command.name());
        button.setHint(command.shortcut());
        button.setName("top.search");
        button.addActionListener(e -> {
            button.setSelected(false);
            search.run();
        });
        return button;
    }

    private static FlatButton fixed(FlatButton button) {
        button.setMaximumSize(new Dimension(320, 28));
        return button;
    }

    @Override
    public void addNotify() {
        super.addNotify();
        leave = session.document().listeners().add(change -> refresh());
        refresh();
    }

    @Override
    public void removeNotify() {
        leave.run();
        super.removeNotify();
    }

    private void refresh() {
        title.setText(FileWords.name(session.document(), look.texts()));
        Optional<Task> shown = session.document().shownTask();
        task.setText(shown.map(t -> look.texts().get("task." + t.kind(), t.kind()) + ": " + t.name())
                .orElse(look.text("task.none")));
        task.setMaximumSize(task.getPreferredSize());
        if (SwingUtilities.getWindowAncestor(this) instanceof javax.swing.JFrame frame) {
            frame.setTitle(FileWords.title(session.document(), look.texts()));
        }
        revalidate();
    }

    private void chooseTask() {
        task.setSelected(false);
        JPopupMenu menu = new JPopupMenu();
        for (Task offered : session.document().scene().tasks()) {
            boolean on = offered.id().equals(session.document().task());
            JRadioButtonMenuItem item = new JRadioButtonMenuItem(offered.name(), on);
            item.setName("task." + offered.id());
            item.addActionListener(e -> session.document().lookAt(offered.id()));
            menu.add(item);
        }
        menu.show(task, 0, task.getHeight() + 4);
    }
}
