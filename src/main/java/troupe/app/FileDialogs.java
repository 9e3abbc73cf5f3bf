package troupe.app;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.filechooser.FileNameExtensionFilter;
import troupe.app.document.Listeners;
import troupe.app.document.SceneDocument;
import troupe.app.look.Look;
import troupe.app.look.widget.Question;
import troupe.app.session.Session;
import troupe.exchange.Formats;
import troupe.exchange.format.Importer;

/** Asks which file to open or to save to, and what to do with what is not saved. */
final class FileDialogs {
    private final JFrame frame;
    private final Session session;
    private final Look look;

    FileDialogs(JFrame frame, Session session, Look look) {
        this.frame = frame;
        this.session = session;
        this.look = look;
    }

    /** Asks for a scene and opens it. */
    void open() {
        unlessUnsaved(() -> {
            JFileChooser chooser = chooser("file.scenes", "xml");
            if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
                session.open(chooser.getSelectedFile().toPath());
            }
        });
    }

    /**
     * Asks for a file of another program, and puts the scene it describes in place of the one shown, as one step.
     *
     * @param then what is done after it
     */
    void importScene(Runnable then) {
        String[] endings = Formats.importers().stream().map(Importer::extension).toArray(String[]::new);
        JFileChooser chooser = chooser("file.foreign", endings);
        if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
            Path file = chooser.getSelectedFile().toPath();
            session.importFrom(file, look.texts().format("edit.import", file.getFileName()), then);
        }
    }

    /** Saves to the document's file, or asks for one. */
    void save() {
        saving();
    }

    /** Asks for a file and saves to it. */
    void saveAs() {
        askAndSave();
    }

    /** Saves, and tells whether that has begun: it has not if the person was asked for a file and named none. */
    private boolean saving() {
        Optional<Path> file = session.document().file();
        file.ifPresent(session::save);
        return file.isPresent() || askAndSave();
    }

    private boolean askAndSave() {
        Optional<Path> file = ask("xml", "file.scenes");
        file.ifPresent(session::save);
        return file.isPresent();
    }

    private JFileChooser chooser(String words, String... endings) {
        JFileChooser chooser = new JFileChooser();
        chooser.setFileFilter(new FileNameExtensionFilter(look.text(words), endings));
        Path folder = session.document()
                .file()
                .map(f -> f.toAbsolutePath().getParent())
                .orElse(Path.of("").toAbsolutePath());
        chooser.setCurrentDirectory(folder.toFile());
        return chooser;
    }

    private Optional<Path> ask(String ending, String words) {
        JFileChooser chooser = chooser(words, ending);
        String offered = FileWords.plain(session.document(), look.texts()).replaceAll("[^\\p{L}\\p{N}. _-]+", "-");
        chooser.setSelectedFile(new File(offered.endsWith("." + ending) ? offered : offered + "." + ending));
        if (chooser.showSaveDialog(frame) != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        Path chosen = chooser.getSelectedFile().toPath();
        String name = chosen.getFileName().toString();
        Path file = name.contains(".") ? chosen : chosen.resolveSibling(name + "." + ending);
        boolean yes = !Files.exists(file)
                || new Question(look, "replace")
                        .ask(frame, look.texts().format("replace", file.getFileName()), List.of("yes", "cancel"))
                        .equals(Optional.of("yes"));
        return yes ? Optional.of(file) : Optional.empty();
    }

    /** Does something that gives up the document: at once if it is saved, else as the person wishes. */
    void unlessUnsaved(Runnable action) {
        SceneDocument document = session.document();
        if (!document.isUnsaved()) {
            action.run();
            return;
        }
        Optional<String> answer = new Question(look, "unsaved")
                .ask(
                        frame,
                        look.texts().format("unsaved", FileWords.plain(document, look.texts())),
                        List.of("save", "discard", "cancel"));
        if (answer.equals(Optional.of("discard"))) {
            action.run();
        } else if (answer.equals(Optional.of("save"))) {
            Runnable leave = whenSaved(action);
            if (!saving()) {
                leave.run();
            }
        }
    }

    private Runnable whenSaved(Runnable action) {
        Listeners<SceneDocument.Change> listeners = session.document().listeners();
        Runnable[] leave = new Runnable[1];
        leave[0] = listeners.add(change -> {
            if (change == SceneDocument.Change.FILE && !session.document().isUnsaved()) {
                leave[0].run();
                action.run();
            }
        });
        return leave[0];
    }
}
