package troupe.app.recovery;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import troupe.app.document.EventThread;
import troupe.app.document.SceneDocument;
import troupe.app.look.Failures;
import troupe.app.session.Notice;
import troupe.app.session.SceneFiles;
import troupe.app.session.Session;
import troupe.app.start.ScenePictures;
import troupe.paint.Theme;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;

/**
 * Keeps a session's unsaved edits, and offers those that were left behind: of every document known when the studio
 * starts, of a document when it is opened. Belongs to the event thread.
 */
public final class Recovery implements AutoCloseable {
    private static final int WIDTH = 260;
    private static final int HEIGHT = 190;

    /**
     * Edits that can be brought back.
     *
     * @param left where they were kept
     * @param base the scene as its file holds it; empty ground if it has none
     * @param scene the scene as it was edited
     * @param picture what it looks like
     */
    public record Offer(KeptFiles.Left left, Scene base, Scene scene, BufferedImage picture) {}

    private final Session session;
    private final KeptFiles kept;
    private final Executor eventThread;
    private final Autosave autosave;
    private final Consumer<Offer> ask;
    private final Theme theme;
    private final Runnable leave;
    private boolean bringing;

    /**
     * Keeps a session's edits from now on.
     *
     * @param ask asks the person what is to become of edits that were found, and answers with one of
     *     {@link #bringBack} and {@link #discard}, or with neither
     * @param theme in which the pictures of what is offered are painted
     */
    public Recovery(Session session, KeptFiles kept, Executor eventThread, Theme theme, Consumer<Offer> ask) {
        this.session = session;
        this.kept = kept;
        this.eventThread = eventThread;
        this.theme = theme;
        this.ask = ask;
        this.autosave = new Autosave(session.document(), session.files(), kept, this::tell);
        this.leave = session.document().listeners().add(this::changed);
    }

    private void changed(SceneDocument.Change change) {
        if (change == SceneDocument.Change.OPENED && !bringing) {
            session.document().file().ifPresent(file -> look(List.of(file), false));
        }
    }

    /** Looks for edits of these documents, and of those without a file, and asks about the newest. */
    public void look(List<Path> documents) {
        look(documents, true);
    }

    private void look(List<Path> documents, boolean unnamed) {
        EventThread.require();
        SceneFiles files = session.files();
        autosave.inBackground(() -> {
            try {
                List<KeptFiles.Left> found = new ArrayList<>(kept.leftOf(documents));
                if (unnamed) {
                    found.addAll(kept.leftUnnamed());
                }
                offer(found, files);
            } catch (IOException e) {
                tell(e);
            }
        });
    }

    /** Offers the first that differs from what its file holds; runs in the background. */
    private void offer(List<KeptFiles.Left> found, SceneFiles files) {
        for (KeptFiles.Left left : found) {
            Optional<Offer> offer = read(left, files);
            if (offer.isPresent()) {
                eventThread.execute(() -> ask.accept(offer.get()));
                return;
            }
        }
    }

    private Optional<Offer> read(KeptFiles.Left left, SceneFiles files) {
        try {
            Scene scene = files.read(left.kept());
            Scene base = base(left, scene, files);
            if (base.equals(scene)) {
                autosave.remove(left.kept());
                return Optional.empty();
            }
            ScenePictures.Wanted wanted = new ScenePictures.Wanted(left.kept(), theme, WIDTH, HEIGHT, 1);
            return Optional.of(new Offer(left, base, scene, ScenePictures.paint(scene, wanted)));
        } catch (SceneException | IOException e) {
            // a file of this name that is no scene was not written here; it is left alone
            return Optional.empty();
        }
    }

    private static Scene base(KeptFiles.Left left, Scene scene, SceneFiles files) {
        Scene empty = new Scene("", scene.world(), List.of(), List.of(), List.of(), List.of());
        try {
            return left.file().isPresent() ? files.read(left.file().get()) : empty;
        } catch (SceneException | IOException e) {
            // the document itself is gone or broken; the edits are all there is
            return empty;
        }
    }

    /** Opens the document as its file holds it, with the edits as one step of its history. */
    public void bringBack(Offer offer, String step) {
        EventThread.require();
        SceneDocument document = session.document();
        bringing = true;
        document.open(offer.base(), offer.left().file());
        document.commit(step, offer.scene());
        bringing = false;
        autosave.keep();
        autosave.remove(offer.left().kept());
    }

    /** Gives the edits up. */
    public void discard(Offer offer) {
        autosave.remove(offer.left().kept());
    }

    private void tell(IOException e) {
        eventThread.execute(() -> session.notices().tell(new Notice(true, Failures.line(e))));
    }

    /** Ends, as the document is given up on purpose: nothing is kept of it. */
    @Override
    public void close() {
        leave.run();
        autosave.close();
    }
}
