package troupe.app;

import troupe.app.document.SceneDocument;
import troupe.app.look.Texts;

/** Names the document in titles. */
final class FileWords {
    private FileWords() {}

    /** Returns the file's name, or the scene's title. */
    static String plain(SceneDocument document, Texts texts) {
        String title = document.scene().title().isEmpty()
                ? texts.get("file.untitled")
                : document.scene().title();
        return document.file().map(f -> f.getFileName().toString()).orElse(title);
    }

    /** Returns the file's name, or the scene's title, and whether it is edited. */
    static String name(SceneDocument document, Texts texts) {
        String name = plain(document, texts);
        return document.isUnsaved() ? texts.format("file.edited", name) : name;
    }

    /** Returns the title of the window. */
    static String title(SceneDocument document, Texts texts) {
        return name(document, texts) + " \u2013 Troupe";
    }
}
