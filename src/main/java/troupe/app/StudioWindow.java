package troupe.app;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Toolkit;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import troupe.app.canvas.Canvas;
import troupe.app.command.CommandSearch;
import troupe.app.command.Commands;
import troupe.app.document.SceneEdits;
import troupe.app.look.Look;
import troupe.app.look.Scaling;
import troupe.app.look.SwingTheme;
import troupe.app.look.Texts;
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
import troupe.app.play.Playback;
import troupe.app.problem.Diagnosis;
import troupe.app.recovery.KeptFiles;
import troupe.app.recovery.Recovery;
import troupe.app.session.Session;
import troupe.app.settings.StudioSettings;
import troupe.app.solid.Eye;
import troupe.app.solid.SolidDeck;
import troupe.app.solid.SolidMode;
import troupe.app.solid.SolidView;
import troupe.app.tool.Tool;
import troupe.app.tour.TourGuide;
import troupe.geometry.Box;
import troupe.paint.Theme;
import troupe.paint.Viewport;

/**
 * Shows a session in a window. Another theme or language builds the window's content anew over the same
 * session. Belongs to the event thread.
 */
final class StudioWindow {
    private static final int FRAME_MS = 16;
    private static final int NARROW = 1_280;

    private final Session session;
    private final StudioSettings settings;
    private final Executor eventThread;
    private final JFrame frame = new JFrame();
    private final Timer clock;
    private final PlayKey playKey;
    private final Pages pages;
    private final Scaling scaling = new Scaling(() -> look().scale());
    private final Diagnosis diagnosis;
    private final Recovery recovery;
    private final TourGuide tour;
    private long ticked;
    private Look look;
    private Content content;
    private Eye eye = Eye.DEFAULT;
    private Optional<Boolean> outlineWanted = Optional.empty();
    private boolean historyWanted;

    /** What is built for one look. */
    private record Content(
            Canvas canvas,
            SolidView solid,
            SolidDeck deck,
            Commands commands,
            List<Runnable> closing,
            OutlinePanel outline,
            HistoryPanel history,
            InspectorPanel inspector,
            TimelinePanel timeline,
            StatusBar status) {}

    StudioWindow(Session session, StudioSettings settings, Executor eventThread) {
        this.session = session;
        this.settings = settings;
        this.eventThread = eventThread;
        this.diagnosis = new Diagnosis(session, new Studio.Steps(), eventThread);
        this.clock = new Timer(FRAME_MS, e -> tick());
        this.look = new Look(settings.theme(), new Texts(settings.language()), settings.scale() / 100.0);
        scaling.apply(frame.getLayeredPane());
        frame.setName("studio");
        frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                close();
            }
        });
        frame.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                showOutline();
            }
        });
        session.playback().listeners().add(this::runClock);
        if (!settings.live()) {
            session.setLive(false);
        }
        pages = new Pages(this, settings, eventThread);
        recovery =
                new Recovery(session, new KeptFiles(settings.recoveryFolder()), eventThread, look.theme(), this::offer);
        frame.setTransferHandler(new SceneDrop(pages::open));
        tour = new TourGuide(frame, session, settings);
        tour.among(this::look, this::canvas, this::commands);
        build();
        playKey = new PlayKey(
                        focused -> SwingUtilities.getWindowAncestor(focused) == frame,
                        () -> content.commands().get("play").perform())
                .install();
    }

    /** Opens the window, as large as the screen allows up to 1440 by 900. */
    void open() {
        Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();
        frame.setSize(Math.min(look.px(1_440), screen.width), Math.min(look.px(900), screen.height));
        frame.setMinimumSize(new Dimension(800, 560));
        frame.setLocationRelativeTo(null);
        frame.setVisible(true);
        content.canvas().requestFocusInWindow();
        List<Path> known = new ArrayList<>(settings.recent());
        session.document().file().ifPresent(known::add);
        recovery.look(known);
    }

    private void offer(Recovery.Offer offer) {
        RecoveryQuestion.ask(this, recovery, offer);
    }

    /** Returns the frame. */
    JFrame frame() {
        return frame;
    }

    /** Returns the session. */
    Session session() {
        return session;
    }

    /** Returns the pages: the scene and the start page. */
    Pages pages() {
        return pages;
    }

    /** Returns what leads through the window. */
    TourGuide tour() {
        return tour;
    }

    /** Returns the canvas that is shown now. */
    Canvas canvas() {
        return content.canvas();
    }

    /** Returns the commands that are shown now. */
    Commands commands() {
        return content.commands();
    }

    /** Returns the looks that are shown now. */
    Look look() {
        return look;
    }

    private void build() {
        Optional<Viewport> view = Optional.empty();
        if (content != null) {
            view = content.canvas().isFitted()
                    ? Optional.empty()
                    : Optional.of(content.canvas().view());
            eye = content.solid().eye();
            dispose(content);
        }
        SwingTheme.install(look);
        Canvas canvas = new Canvas(look, session, eventThread);
        canvas.setSnapping(settings.snapping());
        StudioCommands made = new StudioCommands(this, look, canvas);
        content = content(canvas, made);
        view.ifPresent(canvas::show);
        showSolid(settings.solid());
        RecentMenu recent = new RecentMenu(look, settings::recent, pages::open);
        frame.setJMenuBar(scaling.apply(new TopBar(look, session, made.commands(), recent, this::search)));
        frame.revalidate();
        frame.repaint();
        canvas.requestFocusInWindow();
        frame.setTitle(FileWords.title(session.document(), look.texts()));
        tour.relook();
    }

    private Content content(Canvas canvas, StudioCommands made) {
        Commands commands = made.commands();
        OutlinePanel outline = new OutlinePanel(look, session, this::zoomTo);
        HistoryPanel history = new HistoryPanel(look, session);
        history.setVisible(historyWanted);
        outline.add(history, BorderLayout.SOUTH);
        ProblemsSection problems = new ProblemsSection(look, session, diagnosis, this::zoomTo);
        InspectorPanel inspector = new InspectorPanel(look, session, List.of(problems));
        Runnable unmark = diagnosis.listeners().add(canvas::show);
        canvas.show(diagnosis.findings());
        TimelinePanel timeline = new TimelinePanel(
                look,
                session,
                List.<Action>of(
                        commands.get("first"),
                        commands.get("back"),
                        commands.get("play"),
                        commands.get("forward"),
                        commands.get("loop")));
        StatusBar status = new StatusBar(look, session);
        ChipBar chips = new ChipBar(look, session);
        canvas.setLayout(new BorderLayout());
        chips.setBorder(javax.swing.BorderFactory.createEmptyBorder(10, 6, 10, 6));
        AspectBar aspects = new AspectBar(look, session);
        aspects.setBorder(javax.swing.BorderFactory.createEmptyBorder(10, 6, 10, 12));
        JPanel above = new JPanel(new BorderLayout());
        above.setOpaque(false);
        above.add(chips, BorderLayout.CENTER);
        above.add(aspects, BorderLayout.EAST);
        canvas.add(above, BorderLayout.NORTH);
        canvas.pointers().add(status::pointAt);
        canvas.views().add(view -> status.zoom(canvas.zoomShare()));
        status.zoom(canvas.zoomShare());
        Consumer<Tool> hint = tool ->
                status.hint(tool.message().isEmpty() ? look.text("tool." + tool.key() + ".hint") : tool.message());
        made.onTool(hint);
        canvas.gestures().add(hint);
        SolidView solid = new SolidView(look, session, eye, eventThread);
        SolidDeck deck = new SolidDeck(look, canvas, solid, () -> wantSolid(SolidMode.HIDDEN));
        JPanel all = new JPanel(new BorderLayout());
        all.add(pages.around(body(made, outline, deck, inspector, timeline)), BorderLayout.CENTER);
        all.add(status, BorderLayout.SOUTH);
        frame.setContentPane(scaling.apply(all));
        return new Content(
                canvas,
                solid,
                deck,
                commands,
                List.of(
                        canvas::close,
                        solid::close,
                        made::close,
                        outline::close,
                        history::close,
                        unmark,
                        inspector::close,
                        timeline::close,
                        status::close,
                        chips::close,
                        aspects::close),
                outline,
                history,
                inspector,
                timeline,
                status);
    }

    private JComponent body(
            StudioCommands made,
            OutlinePanel outline,
            SolidDeck deck,
            InspectorPanel inspector,
            TimelinePanel timeline) {
        JSplitPane right = ThinDivider.split(JSplitPane.HORIZONTAL_SPLIT, deck, inspector, 1, look);
        JSplitPane both = ThinDivider.split(JSplitPane.HORIZONTAL_SPLIT, outline, right, 0, look);
        JPanel middle = new JPanel(new BorderLayout());
        middle.add(new ToolStrip(look, made.tools()), BorderLayout.WEST);
        middle.add(both, BorderLayout.CENTER);
        return ThinDivider.split(JSplitPane.VERTICAL_SPLIT, middle, timeline, 1, look);
    }

    private static void dispose(Content old) {
        old.closing().forEach(Runnable::run);
    }

    /** Shows everything in another theme. */
    void show(Theme theme) {
        settings.setTheme(theme);
        look = look.with(theme);
        build();
        showOutline();
    }

    /** Shows everything in another language. */
    void show(Texts texts) {
        settings.setLanguage(texts.locale());
        look = look.with(texts);
        build();
        showOutline();
    }

    /** Shows everything at another scale, in percent. */
    void scale(int percent) {
        settings.setScale(percent);
        look = look.scaled(percent / 100.0);
        build();
        showOutline();
    }

    /** Shows the preferences. */
    void preferences() {
        new PreferencesDialog(this, settings).show();
    }

    /** Shows or hides the outline, whatever the width of the window. */
    void wantOutline(boolean on) {
        outlineWanted = Optional.of(on);
        showOutline();
    }

    /** Tells whether the steps of the history are listed. */
    boolean wantsHistory() {
        return historyWanted;
    }

    /** Shows or hides the steps of the history, below the outline. */
    void wantHistory(boolean on) {
        historyWanted = on;
        content.history().setVisible(on);
        if (on) {
            wantOutline(true);
        }
    }

    /** Shows or hides the inspector. */
    void wantInspector(boolean on) {
        show(content.inspector(), on);
    }

    /** Shows or hides the timeline. */
    void wantTimeline(boolean on) {
        show(content.timeline(), on);
    }

    /** Returns from where the view in three dimensions is seen. */
    Eye eye() {
        return content.solid().eye();
    }

    /** Shows the view in three dimensions in another place, and remembers it. */
    void wantSolid(SolidMode mode) {
        settings.setSolid(mode);
        showSolid(mode);
    }

    private void showSolid(SolidMode mode) {
        content.deck().show(mode);
        for (SolidMode each : SolidMode.values()) {
            if (each != SolidMode.HIDDEN) {
                content.commands().get("solid." + each.key()).setOn(each == mode);
            }
        }
    }

    private void showOutline() {
        boolean on = outlineWanted.orElse(frame.getWidth() >= look.px(NARROW));
        content.commands().get("outline").setOn(on);
        show(content.outline(), on);
    }

    private void show(JComponent part, boolean on) {
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
        Canvas canvas = content.canvas();
        canvas.show(Viewport.fit(box, (int) canvas.wide(), (int) canvas.high(), 60));
    }

    /** Opens the search for commands. */
    void search() {
        CommandSearch.open(frame.getLayeredPane(), look, content.commands(), () -> content.canvas()
                .requestFocusInWindow());
    }

    private void runClock(Playback playback) {
        if (playback.isPlaying() && !clock.isRunning()) {
            ticked = System.nanoTime();
            clock.start();
        } else if (!playback.isPlaying()) {
            clock.stop();
        }
    }

    private void tick() {
        long now = System.nanoTime();
        double seconds = (now - ticked) / 1e9;
        ticked = now;
        session.playback().advance(seconds);
    }

    /** Closes the window, unless the person wants to keep what is not saved. */
    void close() {
        new FileDialogs(frame, session, look).unlessUnsaved(this::dispose);
    }

    /** Closes the window and the session. */
    void dispose() {
        clock.stop();
        playKey.close();
        diagnosis.close();
        pages.close();
        recovery.close();
        tour.dispose();
        dispose(content);
        session.close();
        frame.dispose();
    }
}
