package troupe.app;

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
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import troupe.app.canvas.Canvas;
import troupe.app.command.CommandSearch;
import troupe.app.command.Commands;
import troupe.app.look.Look;
import troupe.app.look.Scaling;
import troupe.app.look.SwingTheme;
import troupe.app.look.Texts;
import troupe.app.play.Playback;
import troupe.app.problem.Diagnosis;
import troupe.app.recovery.KeptFiles;
import troupe.app.recovery.Recovery;
import troupe.app.session.Session;
import troupe.app.settings.StudioSettings;
import troupe.app.solid.Eye;
import troupe.app.solid.SolidMode;
import troupe.app.tour.TourGuide;
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
    private Workbench bench;
    private Eye eye = Eye.DEFAULT;
    private Optional<Boolean> outlineWanted = Optional.empty();
    private boolean historyWanted;

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
        recovery = new Recovery(session, new KeptFiles(settings.recoveryFolder()), eventThread, look.theme(), asking());
        frame.setTransferHandler(new SceneDrop(pages::open));
        tour = new TourGuide(frame, session, settings);
        tour.among(this::look, this::canvas, this::commands);
        build();
        playKey = new PlayKey(
                        focused -> SwingUtilities.getWindowAncestor(focused) == frame,
                        () -> bench.commands().get("play").perform())
                .install();
    }

    /** Opens the window, as large as the screen allows up to 1440 by 900. */
    void open() {
        Dimension screen = Toolkit.getDefaultToolkit().getScreenSize();
        frame.setSize(Math.min(look.px(1_440), screen.width), Math.min(look.px(900), screen.height));
        frame.setMinimumSize(new Dimension(800, 560));
        frame.setLocationRelativeTo(null);
        frame.setVisible(true);
        bench.canvas().requestFocusInWindow();
        List<Path> known = new ArrayList<>(settings.recent());
        session.document().file().ifPresent(known::add);
        recovery.look(known);
    }

    private Recovery.Asking asking() {
        return new Recovery.Asking() {
            @Override
            public void ask(Recovery.Offer offer) {
                RecoveryQuestion.ask(StudioWindow.this, recovery, offer);
            }

            @Override
            public void ask(Recovery.RunOffer offer) {
                RecoveryQuestion.ask(StudioWindow.this, recovery, offer);
            }
        };
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
        return bench.canvas();
    }

    /** Returns the commands that are shown now. */
    Commands commands() {
        return bench.commands();
    }

    /** Returns the looks that are shown now. */
    Look look() {
        return look;
    }

    private void build() {
        Optional<Viewport> view = Optional.empty();
        if (bench != null) {
            Canvas old = bench.canvas();
            view = old.isFitted() ? Optional.empty() : Optional.of(old.view());
            eye = bench.eye();
            bench.close();
        }
        SwingTheme.install(look);
        bench = new Workbench(this, settings, diagnosis, eye, eventThread);
        bench.showHistory(historyWanted);
        frame.setContentPane(scaling.apply(bench.pane()));
        view.ifPresent(bench.canvas()::show);
        bench.showSolid(settings.solid());
        RecentMenu recent = new RecentMenu(look, settings::recent, pages::open);
        frame.setJMenuBar(scaling.apply(new TopBar(look, session, bench.commands(), recent, this::search)));
        frame.revalidate();
        frame.repaint();
        bench.canvas().requestFocusInWindow();
        frame.setTitle(FileWords.title(session.document(), look.texts()));
        tour.relook();
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
        bench.showHistory(on);
        if (on) {
            wantOutline(true);
        }
    }

    /** Shows or hides the inspector. */
    void wantInspector(boolean on) {
        bench.showInspector(on);
    }

    /** Shows or hides the timeline. */
    void wantTimeline(boolean on) {
        bench.showTimeline(on);
    }

    /** Returns from where the view in three dimensions is seen. */
    Eye eye() {
        return bench.eye();
    }

    /** Shows the view in three dimensions in another place, and remembers it. */
    void wantSolid(SolidMode mode) {
        settings.setSolid(mode);
        bench.showSolid(mode);
    }

    private void showOutline() {
        bench.showOutline(outlineWanted.orElse(frame.getWidth() >= look.px(NARROW)));
    }

    /** Opens the search for commands. */
    void search() {
        CommandSearch.open(frame.getLayeredPane(), look, bench.commands(), () -> bench.canvas()
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
        bench.close();
        session.close();
        frame.dispose();
    }
}
