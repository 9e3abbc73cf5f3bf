package troupe.app;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JOptionPane;
import javax.swing.filechooser.FileNameExtensionFilter;
import troupe.app.document.Listeners;
import troupe.app.document.SceneDocument;
import troupe.app.look.Look;
import troupe.app.session.Session;

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
            JFileChooser chooser = chooser("xml", "file.scenes");
            if (chooser.showOpenDialog(frame) == JFileChooser.APPROVE_OPTION) {
                session.open(chooser.getSelectedFile().toPath());
            }
        });
    }

    /** Saves to the document's file, or asks for one. */
    void save() {
        session.document().file().ifPresentOrElse(session::save, this::saveAs);
    }

    /** Asks for a file and saves to it. */
    void saveAs() {
        ask("xml", "file.scenes").ifPresent(session::save);
    }

    private JFileChooser chooser(String ending, String words) {
        JFileChooser chooser = new JFileChooser();
        chooser.setFileFilter(new FileNameExtensionFilter(look.text(words), ending));
        Path folder = session.document()
                .file()
                .map(f -> f.toAbsolutePath().getParent())
                .orElse(Path.of("").toAbsolutePath());
        chooser.setCurrentDirectory(folder.toFile());
        return chooser;
    }

    private Optional<Path> ask(String ending, String words) {
        JFileChooser chooser = chooser(ending, words);
        if (chooser.showSaveDialog(frame) != JFileChooser.APPROVE_OPTION) {
            return Optional.empty();
        }
        Path chosen = chooser.getSelectedFile().toPath();
        String name = chosen.getFileName().toString();
        Path file = name.contains(".") ? chosen : chosen.resolveSibling(name + "." + ending);
        boolean taken = Files.exists(file);
        boolean yes = !taken
                || JOptionPane.showConfirmDialog(
                                frame,
                                look.texts().format("file.replace", file.getFileName()),
                                look.text("file.replace.title"),
                                JOptionPane.YES_NO_OPTION)
                        == JOptionPane.YES_OPTION;
        return yes ? Optional.of(file) : Optional.empty();
    }

    /** Does something that gives up the document: at once if it is saved, else as the person wishes. */
    void unlessUnsaved(Runnable action) {
        SceneDocument document = session.document();
        if (!document.isUnsaved()) {
            action.run();
            return;
        }
        Object[] answers = {look.text("file.save"), look.text("file.discard"), look.text("file.cancel")};
        int answer = JOptionPane.showOptionDialog(
                frame,
                look.texts().format("file.unsaved", FileWords.name(document, look.texts())),
                look.text("file.unsaved.title"),
                JOptionPane.YES_NO_CANCEL_OPTION,
                JOptionPane.QUESTION_MESSAGE,
                null,
                answers,
                answers[0]);
        if (answer == 1) {
            action.run();
        } else if (answer == 0) {
            whenSaved(action);
            save();
        }
    }

    private void whenSaved(Runnable action) {
        Listeners<SceneDocument.Change> listeners = session.document().listeners();
        Runnable[] leave = new Runnable[1];
        leave[0] = listeners.add(change -> {
            if (change == SceneDocument.Change.FILE && !session.document().isUnsaved()) {
                leave[0].run();
                action.run();
            }
        });
    }
}
