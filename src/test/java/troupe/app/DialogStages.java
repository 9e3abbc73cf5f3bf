package troupe.app;

import java.awt.Container;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JDialog;
import javax.swing.JEditorPane;
import javax.swing.JFileChooser;
import javax.swing.SwingUtilities;
import troupe.app.document.SceneEdits;
import troupe.app.recovery.KeptFiles;
import troupe.app.recovery.Recovery;
import troupe.scene.Scene;

/** Leads the studio through what it asks and explains beside the scene: choosers of files, questions, help, the tour. */
final class DialogStages {
    private final StudioFixture studio;
    private final BiConsumer<String, Container> looker;

    /** Makes the way through; {@code looker} is told the name of each stage and what to look at, on the event thread. */
    DialogStages(StudioFixture studio, BiConsumer<String, Container> looker) {
        this.studio = studio;
        this.looker = looker;
    }

    /** Goes through all stages. The window shows a scene that is saved, and has a run, when this begins. */
    void walk() {
        for (String command : List.of("import", "saveas", "saverun", "openrun")) {
            shown(command, () -> perform(command), dialog -> holds(dialog.getContentPane()));
        }
        help("about", "about.text");
        help("guide", "guide.text");
        help("shortcuts", "shortcuts.list");
        tour();
        Scene scene = studio.scene();
        OnEventThread.run(() -> studio.session()
                .document()
                .commit(
                        "edit",
                        SceneEdits.shifted(
                                scene, List.of(scene.obstacles().get(0).id()), 0.1, 0)));
        question("unsaved", () -> perform("open"));
        KeptFiles.Left left = new KeptFiles.Left(Optional.of(studio.file()), studio.file(), Instant.EPOCH);
        Recovery.Offer offer =
                new Recovery.Offer(left, scene, scene, new BufferedImage(260, 190, BufferedImage.TYPE_INT_RGB));
        question("recovery", () -> RecoveryQuestion.ask(studio.window(), null, offer));
        question(
                "recovery.run",
                () -> RecoveryQuestion.ask(
                        studio.window(),
                        null,
                        new Recovery.RunOffer(left, studio.session().run().orElseThrow())));
    }

    private void perform(String command) {
        studio.window().commands().get(command).perform();
    }

    private Stream<JDialog> dialogs() {
        return Stream.of(studio.window().frame().getOwnedWindows())
                .filter(Window::isShowing)
                .filter(JDialog.class::isInstance)
                .map(JDialog.class::cast);
    }

    private static boolean holds(Container part) {
        return part instanceof JFileChooser
                || Stream.of(part.getComponents())
                        .anyMatch(inner -> inner instanceof Container container && holds(container));
    }

    private void question(String name, Runnable ask) {
        shown(name, ask, dialog -> name.equals(dialog.getName()));
    }

    private void help(String command, String part) {
        SwingUtilities.invokeLater(() -> perform(command));
        Await.until("the window of " + command, () -> studio.shows(part));
        if (part.equals("guide.text")) {
            Await.until(
                    "the guide is read",
                    () -> ((JEditorPane) studio.find(part)).getDocument().getLength() > 1_000);
        }
        shown(command, () -> {}, dialog -> command.equals(dialog.getName()));
    }

    /** Does what opens a dialog, looks at it, and closes it. */
    private void shown(String stage, Runnable opening, Predicate<JDialog> which) {
        SwingUtilities.invokeLater(opening);
        Await.until("the dialog " + stage, () -> dialogs().anyMatch(which));
        OnEventThread.run(() -> dialogs().filter(which).toList().forEach(dialog -> {
            looker.accept(stage, dialog);
            dialog.dispose();
        }));
    }

    private void tour() {
        OnEventThread.run(() -> studio.window().tour().offer(() -> {}));
        OnEventThread.run(() -> studio.window().tour().start());
        String before = "";
        while (!studio.window().tour().step().equals(before)) {
            String step = studio.window().tour().step();
            before = step;
            OnEventThread.run(() -> {
                studio.window().frame().validate();
                looker.accept("tour " + step, studio.window().frame());
                String forward = studio.shows("tour.next") ? "tour.next" : "tour.skip";
                if (studio.shows(forward)) {
                    ((AbstractButton) studio.find(forward)).doClick(0);
                }
            });
        }
        OnEventThread.run(() -> studio.window().tour().close());
    }
}
