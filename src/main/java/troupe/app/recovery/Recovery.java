package troupe.app.recovery;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import troupe.app.document.EventThread;
import troupe.app.document.SceneDocument;
import troupe.app.look.Failures;
import troupe.app.session.Notice;
import troupe.app.session.SceneFiles;
import troupe.app.session.Session;
import troupe.app.start.ScenePictures;
import troupe.paint.Theme;
import troupe.run.Run;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;

/**
 * Keeps a session's unsaved edits and what it simulates, and offers those that were left behind: of every document known when the studio
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

    /**
     * A simulation that can be shown again as far as it had come.
     *
     * @param left where it was kept
     */
    public record RunOffer(KeptFiles.Left left, Run run) {}

    /** Asks the person what is to become of what was found. */
    public interface Asking {

        /** Asks about edits; answers with one of {@link #bringBack} and {@link #discard}, or with neither. */
        void ask(Offer offer);

        /** Asks about a simulation; answers as about edits. */
        void ask(RunOffer offer);
    }

    private final Session session;
    private final KeptFiles kept;
    private final Executor eventThread;
    private final Autosave autosave;
    private final RunKeeping runs;
    private final Asking asking;
    private final Theme theme;
    private final Runnable leave;
    private boolean bringing;

    /**
     * Keeps a session's edits and simulations from now on.
     *
     * @param theme in which the pictures of what is offered are painted
     */
    public Recovery(Session session, KeptFiles kept, Executor eventThread, Theme theme, Asking asking) {
        this.session = session;
        this.kept = kept;
        this.eventThread = eventThread;
        this.theme = theme;
        this.asking = asking;
        this.autosave = new Autosave(session.document(), session.files(), kept, this::tell);
        this.runs = new RunKeeping(session, kept, eventThread, this::tell);
        this.leave = session.document().listeners().add(this::changed);
    }

    private void changed(SceneDocument.Change change) {
        if (change == SceneDocument.Change.OPENED && !bringing) {
            session.document().file().ifPresent(file -> look(List.of(file), false));
        }
    }

    /**
     * Looks for edits of these documents, and of those without a file, and asks about the newest; then for simulations
     * that were cut off, and asks about the newest.
     */
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
                if (unnamed) {
                    runs.left().ifPresent(offer -> eventThread.execute(() -> asking.ask(offer)));
                }
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
                eventThread.execute(() -> asking.ask(offer.get()));
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

    /** Shows a simulation as a saved run, in place of the document; then tells {@code shown}. */
    public void bringBack(RunOffer offer, Runnable shown) {
        runs.bringBack(offer.left().kept(), shown);
    }

    /** Gives a simulation up. */
    public void discard(RunOffer offer) {
        runs.remove(offer.left().kept());
    }

    private void tell(IOException e) {
        eventThread.execute(() -> session.notices().tell(new Notice(true, Failures.line(e))));
    }

    /** Ends, as the document is given up on purpose: nothing is kept of it. */
    @Override
    public void close() {
        leave.run();
        autosave.close();
        runs.close();
    }
}
