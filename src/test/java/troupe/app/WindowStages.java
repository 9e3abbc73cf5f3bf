package troupe.app;

import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import troupe.app.document.SceneEdits;
import troupe.geometry.Polygon;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;

/**
 * Leads the studio through everything that it can show: scenes of each kind, selections, problems, no way, the start
 * page, dialogs, the search, a comparison. At each stage somebody looks at a part of the screen.
 */
final class WindowStages {
    private final StudioFixture studio;
    private final BiConsumer<String, Container> looker;

    /** Makes the way through; {@code looker} is told the name of each stage and what to look at, on the event thread. */
    WindowStages(StudioFixture studio, BiConsumer<String, Container> looker) {
        this.studio = studio;
        this.looker = looker;
    }

    /** Goes through all stages. The window shows the courtyard when this begins. */
    void walk() throws Exception {
        OnEventThread.run(() -> {
            studio.window().wantOutline(true);
            studio.window().wantHistory(true);
        });
        studio.awaitPlan();
        look("courtyard");
        for (String id : List.of("crate", "canal", "ann", "to-the-fountain")) {
            select(id);
        }
        OnEventThread.run(() -> studio.session().selection().set(List.of("crate", "bench")));
        look("two selected");
        simulations();
        comparison();
        troubles();
        OnEventThread.run(() -> studio.window().pages().showStart());
        Await.until("the examples are shown", () -> studio.shows("example.crowd.fork"));
        look("start page");
        OnEventThread.run(() -> studio.window().pages().showScene());
        OnEventThread.run(() -> studio.window().search());
        look("search");
        dialog("new", "new.room");
        dialog("preferences", "preferences.theme.dark");
        dialog("export", "export.target");
        new DialogStages(studio, looker).walk();
    }

    private void select(String id) {
        OnEventThread.run(() -> studio.session().selection().set(List.of(id)));
        look(id + " selected");
    }

    private void look(String stage) {
        OnEventThread.run(() -> {
            studio.window().frame().validate();
            looker.accept(stage, studio.window().frame());
        });
    }

    private void open(Scene scene) {
        OnEventThread.run(() -> studio.session().document().open(scene, Optional.empty()));
    }

    private static Scene read(String name) throws Exception {
        return SceneXml.read(Path.of("scenes/" + name + ".xml")).scene();
    }

    private void simulations() throws Exception {
        for (String name : List.of("risk/crossing", "crowd/fork")) {
            open(read(name));
            Await.until("the simulation has ended", () -> studio.session()
                    .run()
                    .filter(run ->
                            run.scene().equals(studio.session().document().scene()))
                    .filter(run -> !run.outcome().isRunning())
                    .isPresent());
            OnEventThread.run(() -> studio.session().playback().seek(2));
            look(name);
            select(studio.scene().tasks().get(0).id());
        }
    }

    private void comparison() throws Exception {
        open(read("unified/courtyard"));
        studio.awaitPlan();
        OnEventThread.run(() -> studio.window().commands().get("keep").perform());
        dialog("compare", "compare.table");
    }

    /** Shows a scene with much that is wrong, and one without a way. */
    private void troubles() throws Exception {
        Scene scene = read("unified/courtyard");
        Journey journey = (Journey) scene.task("to-the-fountain").orElseThrow();
        open(SceneEdits.startingAt(scene, journey, Place.of(8.1, 5.5)));
        Await.until("its start is in a wall", () -> studio.shows("fix.start"));
        look("start in a wall");
        Obstacle crate = scene.obstacle("crate").orElseThrow();
        open(scene.with(crate.withOutline(Polygon.of(1, 1, 2, 2, 2, 1, 1, 2))));
        Await.until("the outline is wrong", () -> studio.shows("fix.untangle"));
        look("tangled outline");
        open(scene.with(
                new Obstacle(crate.id(), crate.label(), crate.outline(), 0, 3, false, crate.mass(), crate.colour())));
        Await.until("the way is shut", () -> studio.shows("fix.movable"));
        look("no way");
        OnEventThread.run(() -> studio.window().commands().get("undo").perform());
    }

    private void dialog(String command, String part) throws SceneException {
        SwingUtilities.invokeLater(() -> studio.window().commands().get(command).perform());
        Await.until("the dialog " + command, () -> studio.shows(part));
        OnEventThread.run(() -> {
            for (Window dialog : studio.window().frame().getOwnedWindows()) {
                if (dialog.isShowing()) {
                    looker.accept(command, dialog);
                    dialog.dispose();
                }
            }
        });
    }

    /** Adds what a part of the window says without painting it: names and tips, the items of menus, heads of tables. */
    static List<String> unpainted(Component part) {
        List<String> all = new ArrayList<>();
        if (part instanceof Accessible accessible) {
            AccessibleContext context = accessible.getAccessibleContext();
            add(all, context.getAccessibleName());
            add(all, context.getAccessibleDescription());
        }
        if (part instanceof JComponent component) {
            add(all, component.getToolTipText());
        }
        if (part instanceof JTable table) {
            for (int column = 0; column < table.getColumnCount(); column++) {
                add(all, table.getColumnName(column));
                for (int row = 0; row < table.getRowCount(); row++) {
                    add(all, String.valueOf(table.getValueAt(row, column)));
                }
            }
        }
        if (part instanceof JMenu menu) {
            for (Component item : menu.getMenuComponents()) {
                all.addAll(unpainted(item));
            }
        }
        if (part instanceof JMenuItem item) {
            add(all, item.getText());
        }
        if (part instanceof Container container) {
            for (Component inner : container.getComponents()) {
                all.addAll(unpainted(inner));
            }
        }
        return all;
    }

    private static void add(List<String> all, String text) {
        if (text != null && !text.isBlank()) {
            all.add(text);
        }
    }
}
