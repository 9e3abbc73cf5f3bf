package troupe.app;

import java.awt.CardLayout;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Executor;
import javax.swing.JComponent;
import javax.swing.JPanel;
import troupe.app.document.SceneDocument;
import troupe.app.look.Failures;
import troupe.app.look.Look;
import troupe.app.session.Notice;
import troupe.app.session.Session;
import troupe.app.settings.StudioSettings;
import troupe.app.start.Examples;
import troupe.app.start.ScenePictures;
import troupe.app.start.StartPage;
import troupe.scene.Scene;

/**
 * Shows the scene or the start page, and remembers which files were opened. Whatever opens another document asks
 * first what is to become of one that is not saved. Belongs to the event thread.
 */
final class Pages {
    private static final String SCENE = "scene";
    private static final String START = "start";

    private final StudioWindow window;
    private final Session session;
    private final StudioSettings settings;
    private final Executor eventThread;
    private final ScenePictures pictures;
    private JPanel deck = new JPanel(new CardLayout());
    private Optional<StartPage> start = Optional.empty();

    Pages(StudioWindow window, StudioSettings settings, Executor eventThread) {
        this.window = window;
        this.session = window.session();
        this.settings = settings;
        this.eventThread = eventThread;
        this.pictures = new ScenePictures(session.files(), eventThread);
        session.document().listeners().add(this::changed);
    }

    private void changed(SceneDocument.Change change) {
        if (change == SceneDocument.Change.FILE && !session.document().isUnsaved()) {
            session.document().file().ifPresent(settings::addRecent);
        }
        if (change == SceneDocument.Change.OPENED) {
            showScene();
        }
    }

    /** Returns the pages around the editor of a scene; the page that was shown is shown again. */
    JComponent around(JComponent editor) {
        boolean again = isStart();
        closeStart();
        deck = new JPanel(new CardLayout());
        deck.add(editor, SCENE);
        if (again) {
            eventThread.execute(this::showStart);
        }
        return deck;
    }

    /** Tells whether the start page is shown. */
    boolean isStart() {
        return start.isPresent();
    }

    /** Shows the start page. */
    void showStart() {
        if (isStart()) {
            return;
        }
        Look look = window.look();
        StartPage.Deeds deeds = new StartPage.Deeds(
                this::open,
                file -> unlessUnsaved(() -> session.openCopy(file)),
                this::create,
                () -> files().open(),
                this::tour,
                this::showScene);
        StartPage page = new StartPage(look, pictures, settings.recent(), deeds, eventThread);
        start = Optional.of(page);
        deck.add(page, START);
        ((CardLayout) deck.getLayout()).show(deck, START);
        deck.revalidate();
        page.requestFocusInWindow();
    }

    /** Shows the scene. */
    void showScene() {
        if (isStart()) {
            ((CardLayout) deck.getLayout()).show(deck, SCENE);
            closeStart();
            window.canvas().requestFocusInWindow();
        }
    }

    private void closeStart() {
        start.ifPresent(page -> {
            page.close();
            deck.remove(page);
        });
        start = Optional.empty();
    }

    /** Opens a file, after asking what is to become of what is not saved. */
    void open(Path file) {
        unlessUnsaved(() -> session.open(file));
    }

    /** Opens a new scene, after asking what is to become of what is not saved. */
    void create(Scene scene) {
        unlessUnsaved(() -> session.document().open(scene, Optional.empty()));
    }

    /** Begins the tour in the sample scene, after asking what is to become of what is not saved. */
    void tour() {
        unlessUnsaved(() -> pictures.inBackground(() -> {
            try {
                Path sample = Examples.sample();
                eventThread.execute(() -> {
                    window.tour().start();
                    session.openCopy(sample);
                });
            } catch (IOException e) {
                eventThread.execute(() -> session.notices().tell(new Notice(true, Failures.line(e))));
            }
        }));
    }

    private FileDialogs files() {
        return new FileDialogs(window.frame(), session, window.look());
    }

    /** Does something that gives up the document, after asking what is to become of what is not saved. */
    void unlessUnsaved(Runnable action) {
        files().unlessUnsaved(action);
    }

    /** Ends what makes pictures in the background. */
    void close() {
        closeStart();
        pictures.close();
    }
}
