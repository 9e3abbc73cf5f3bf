package troupe.app;

import java.awt.BorderLayout;
import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import troupe.app.canvas.Canvas;
import troupe.app.command.Commands;
import troupe.app.document.SceneEdits;
import troupe.app.look.Look;
import troupe.app.look.widget.ThinDivider;
import troupe.app.panel.AspectBar;
import troupe.app.panel.ChipBar;
import troupe.app.panel.HistoryPanel;
import troupe.app.panel.OutlinePanel;
import troupe.app.panel.StatusBar;
import troupe.app.panel.ToolStrip;
import troupe.app.panel.inspector.InspectorPanel;
import troupe.app.panel.inspector.ProblemsSection;
import troupe.app.panel.timeline.TimelinePanel;
import troupe.app.problem.Diagnosis;
import troupe.app.session.Session;
import troupe.app.settings.StudioSettings;
import troupe.app.solid.Eye;
import troupe.app.solid.SolidDeck;
import troupe.app.solid.SolidMode;
import troupe.app.solid.SolidView;
import troupe.app.tool.Tool;
import troupe.geometry.Box;
import troupe.paint.Viewport;

/**
 * Lays out what a person works with: the canvas, and around it the tools, the outline, the inspector, the timeline
 * and the status. Built anew for each look over the same session. Belongs to the event thread.
 */
final class Workbench {
    private final Look look;
    private final Session session;
    private final Canvas canvas;
    private final SolidView solid;
    private final SolidDeck deck;
    private final StudioCommands commands;
    private final OutlinePanel outline;
    private final HistoryPanel history;
    private final InspectorPanel inspector;
    private final TimelinePanel timeline;
    private final JPanel pane = new JPanel(new BorderLayout());
    private final List<Runnable> closing;

    /**
     * Builds everything for the look that a window has now.
     *
     * @param eye from where the view in three dimensions is seen
     */
    Workbench(StudioWindow window, StudioSettings settings, Diagnosis diagnosis, Eye eye, Executor eventThread) {
        look = window.look();
        session = window.session();
        canvas = new Canvas(look, session, eventThread);
        canvas.setSnapping(settings.snapping());
        commands = new StudioCommands(window, look, canvas);
        outline = new OutlinePanel(look, session, this::zoomTo);
        history = new HistoryPanel(look, session);
        outline.add(history, BorderLayout.SOUTH);
        ProblemsSection problems = new ProblemsSection(look, session, diagnosis, this::zoomTo);
        inspector = new InspectorPanel(look, session, List.of(problems));
        Runnable unmark = diagnosis.listeners().add(canvas::show);
        canvas.show(diagnosis.findings());
        timeline = new TimelinePanel(look, session, transport());
        StatusBar status = new StatusBar(look, session);
        ChipBar chips = new ChipBar(look, session);
        AspectBar aspects = new AspectBar(look, session);
        layOverCanvas(chips, aspects);
        tell(status);
        solid = new SolidView(look, session, eye, eventThread);
        deck = new SolidDeck(look, canvas, solid, () -> window.wantSolid(SolidMode.HIDDEN));
        pane.add(window.pages().around(body()), BorderLayout.CENTER);
        pane.add(status, BorderLayout.SOUTH);
        closing = List.of(
                canvas::close,
                solid::close,
                commands::close,
                outline::close,
                history::close,
                unmark,
                inspector::close,
                timeline::close,
                status::close,
                chips::close,
                aspects::close);
    }

    private List<Action> transport() {
        Commands all = commands.commands();
        return List.of(all.get("first"), all.get("back"), all.get("play"), all.get("forward"), all.get("loop"));
    }

    private void layOverCanvas(ChipBar chips, AspectBar aspects) {
        chips.setBorder(BorderFactory.createEmptyBorder(10, 6, 10, 6));
        aspects.setBorder(BorderFactory.createEmptyBorder(10, 6, 10, 12));
        JPanel above = new JPanel(new BorderLayout());
        above.setOpaque(false);
        above.add(chips, BorderLayout.CENTER);
        above.add(aspects, BorderLayout.EAST);
        canvas.setLayout(new BorderLayout());
        canvas.add(above, BorderLayout.NORTH);
    }

    private void tell(StatusBar status) {
        canvas.pointers().add(status::pointAt);
        canvas.views().add(view -> status.zoom(canvas.zoomShare()));
        status.zoom(canvas.zoomShare());
        Consumer<Tool> hint = tool ->
                status.hint(tool.message().isEmpty() ? look.text("tool." + tool.key() + ".hint") : tool.message());
        commands.onTool(hint);
        canvas.gestures().add(hint);
    }

    private JComponent body() {
        JSplitPane right = ThinDivider.split(JSplitPane.HORIZONTAL_SPLIT, deck, inspector, 1, look);
        JSplitPane both = ThinDivider.split(JSplitPane.HORIZONTAL_SPLIT, outline, right, 0, look);
        JPanel middle = new JPanel(new BorderLayout());
        middle.add(new ToolStrip(look, commands.tools()), BorderLayout.WEST);
        middle.add(both, BorderLayout.CENTER);
        return ThinDivider.split(JSplitPane.VERTICAL_SPLIT, middle, timeline, 1, look);
    }

    /** Returns the whole, for a window to show. */
    JComponent pane() {
        return pane;
    }

    /** Returns the canvas. */
    Canvas canvas() {
        return canvas;
    }

    /** Returns the commands. */
    Commands commands() {
        return commands.commands();
    }

    /** Returns from where the view in three dimensions is seen. */
    Eye eye() {
        return solid.eye();
    }

    /** Shows the view in three dimensions beside the canvas, instead of it, or not at all. */
    void showSolid(SolidMode mode) {
        deck.show(mode);
        for (SolidMode each : SolidMode.values()) {
            if (each != SolidMode.HIDDEN) {
                commands().get("solid." + each.key()).setOn(each == mode);
            }
        }
    }

    /** Shows or hides the steps of the history, below the outline. */
    void showHistory(boolean on) {
        history.setVisible(on);
    }

    /** Shows or hides the outline. */
    void showOutline(boolean on) {
        commands().get("outline").setOn(on);
        show(outline, on);
    }

    /** Shows or hides the inspector. */
    void showInspector(boolean on) {
        show(inspector, on);
    }

    /** Shows or hides the timeline. */
    void showTimeline(boolean on) {
        show(timeline, on);
    }

    private static void show(JComponent part, boolean on) {
        if (part.isVisible() != on) {
            if (part.getParent() instanceof JSplitPane split) {
                ThinDivider.show(split, part, on);
            } else {
                part.setVisible(on);
            }
        }
    }

    private void zoomTo(String id) {
        SceneEdits.outline(session.document().shown(), id)
                .ifPresent(outline -> zoomTo(outline.bounds().grown(1.5)));
    }

    private void zoomTo(Box box) {
        canvas.show(Viewport.fit(box, (int) canvas.wide(), (int) canvas.high(), 60));
    }

    /** Lets go of the session. */
    void close() {
        closing.forEach(Runnable::run);
    }
}
