package troupe.app.start;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.ActionEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import troupe.app.look.Failures;
import troupe.app.look.Look;
import troupe.app.look.widget.FlatButton;
import troupe.app.look.widget.ThinScrollBarUI;
import troupe.paint.Tone;
import troupe.scene.Scene;

/**
 * Shows where to begin: new scenes and the files opened last to the left, the example scenes as pictures to the
 * right. Belongs to the event thread.
 */
public final class StartPage extends JPanel {

    /**
     * What the page can do.
     *
     * @param open opens a file
     * @param copy opens a file as a new document, so that the file stays as it is
     * @param create opens a new scene
     * @param choose asks for a file
     * @param tour begins the tour
     * @param back returns to the scene
     */
    public record Deeds(
            Consumer<Path> open,
            Consumer<Path> copy,
            Consumer<Scene> create,
            Runnable choose,
            Runnable tour,
            Runnable back) {}

    private static final int SIDE = 286;

    private final transient Look look;
    private final transient Deeds deeds;
    private final transient ScenePictures pictures;
    private final transient Executor eventThread;
    private final JPanel recent = column();
    private final JPanel gallery = new ScrolledColumn();
    private boolean closed;

    /** Makes the page; {@code files} are those opened last, the last first. */
    public StartPage(Look look, ScenePictures pictures, List<Path> files, Deeds deeds, Executor eventThread) {
        super(new BorderLayout());
        this.look = look;
        this.deeds = deeds;
        this.pictures = pictures;
        this.eventThread = eventThread;
        setName("start");
        setBackground(look.color(Tone.PANEL));
        getAccessibleContext().setAccessibleName(look.text("command.startpage"));
        JScrollPane side = ThinScrollBarUI.scroll(side(), look);
        side.setBorder(look.line(0, 0, 0, 1));
        side.setPreferredSize(new Dimension(SIDE, 100));
        add(side, BorderLayout.WEST);
        gallery.setBackground(look.color(Tone.PANEL));
        gallery.setBorder(BorderFactory.createEmptyBorder(20, 26, 20, 16));
        add(ThinScrollBarUI.scroll(gallery, look), BorderLayout.CENTER);
        getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ESCAPE"), "back");
        getActionMap().put("back", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                deeds.back().run();
            }
        });
        pictures.inBackground(() -> list(files));
    }

    private static JPanel column() {
        JPanel column = new JPanel();
        column.setLayout(new BoxLayout(column, BoxLayout.Y_AXIS));
        column.setOpaque(false);
        return column;
    }

    private JComponent side() {
        JPanel side = new ScrolledColumn();
        side.setBackground(look.color(Tone.PANEL));
        side.setBorder(BorderFactory.createEmptyBorder(20, 20, 20, 18));
        side.add(heading("start.tour", 0));
        side.add(aligned(button("command.tour", "start.tour", deeds.tour())));
        side.add(heading("start.new", 22));
        side.add(aligned(new NewScenePanel(look, deeds.create())));
        side.add(heading("start.file", 22));
        side.add(aligned(button("command.open", "start.open", deeds.choose())));
        side.add(Box.createVerticalStrut(6));
        side.add(aligned(button("start.back", "start.back", deeds.back())));
        side.add(aligned(recent));
        return side;
    }

    private FlatButton button(String text, String name, Runnable action) {
        FlatButton button = new FlatButton(look, FlatButton.Style.PILL);
        button.setText(look.text(text));
        button.setName(name);
        button.setMaximumSize(new Dimension(Short.MAX_VALUE, 28));
        button.addActionListener(e -> {
            button.setSelected(false);
            action.run();
        });
        return button;
    }

    private static <C extends JComponent> C aligned(C part) {
        part.setAlignmentX(LEFT_ALIGNMENT);
        part.setMaximumSize(new Dimension(Short.MAX_VALUE, part.getMaximumSize().height));
        return part;
    }

    private JLabel heading(String key, int above) {
        JLabel label = look.label(look.text(key), Tone.TEXT);
        label.setFont(look.bold(13));
        label.setBorder(BorderFactory.createEmptyBorder(above, 0, 10, 0));
        label.setAlignmentX(LEFT_ALIGNMENT);
        return label;
    }

    private void list(List<Path> files) {
        List<Path> there = files.stream().filter(Files::isRegularFile).toList();
        eventThread.execute(() -> showRecent(there));
        try {
            Map<String, List<Path>> groups = Examples.find();
            eventThread.execute(() -> showExamples(groups));
        } catch (IOException e) {
            eventThread.execute(() -> {
                gallery.add(look.label(look.texts().tell(Failures.line(e)), Tone.DIM));
                gallery.revalidate();
            });
        }
    }

    private void showRecent(List<Path> files) {
        if (closed || files.isEmpty()) {
            return;
        }
        recent.add(heading("start.recent", 22));
        for (Path file : files) {
            RecentRow row = new RecentRow(look, file);
            row.addActionListener(e -> deeds.open().accept(file));
            recent.add(row);
        }
        recent.revalidate();
    }

    private void showExamples(Map<String, List<Path>> groups) {
        if (closed) {
            return;
        }
        JLabel title = heading("start.examples", 0);
        title.setFont(look.bold(18));
        gallery.add(title);
        groups.forEach((folder, files) -> {
            JLabel name = look.label(look.texts().get("start.group." + folder, folder), Tone.DIM);
            name.setBorder(BorderFactory.createEmptyBorder(4, 0, 8, 0));
            name.setAlignmentX(LEFT_ALIGNMENT);
            gallery.add(name);
            JPanel cards = new JPanel(new WrapLayout(14, 14));
            cards.setOpaque(false);
            cards.setAlignmentX(LEFT_ALIGNMENT);
            files.forEach(file -> cards.add(card(folder, file)));
            gallery.add(cards);
            gallery.add(Box.createVerticalStrut(16));
        });
        gallery.revalidate();
        gallery.repaint();
    }

    private SceneCard card(String folder, Path file) {
        String name = file.getFileName().toString().replace(".xml", "");
        String key = "example." + folder + "." + name;
        SceneCard card = new SceneCard(look, look.texts().get(key, name));
        card.setName(key);
        card.addActionListener(e -> deeds.copy().accept(file));
        double screen = getGraphicsConfiguration() == null
                ? 1
                : getGraphicsConfiguration().getDefaultTransform().getScaleX();
        double density = Math.max(1, Math.min(4, screen * look.scale()));
        ScenePictures.Wanted wanted =
                new ScenePictures.Wanted(file, look.theme(), SceneCard.WIDTH, SceneCard.HEIGHT, density);
        pictures.request(wanted, made -> card.show(made, density / look.scale()));
        return card;
    }

    /** Gives the keys to the first example, or to whatever there is. */
    @Override
    public boolean requestFocusInWindow() {
        Component first = getFocusTraversalPolicy() == null
                ? null
                : getFocusTraversalPolicy().getDefaultComponent(this);
        return first == null ? super.requestFocusInWindow() : first.requestFocusInWindow();
    }

    /** Takes nothing in any more of what is still being made. */
    public void close() {
        closed = true;
    }
}
