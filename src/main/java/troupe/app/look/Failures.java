package troupe.app.look;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** Says in one English line why a file could not be read or written; {@link Texts#tell} tells it in others. Pure. */
public final class Failures {
    private Failures() {}

    /** Returns the line of a failure, which names the file if the failure does. */
    public static String line(IOException failure) {
        String named = failure instanceof FileSystemException system ? system.getFile() : null;
        return line(Path.of(named == null ? "" : named), failure);
    }

    /** Returns the line of a failure; it names the file. */
    public static String line(Path file, Exception failure) {
        if (failure instanceof NoSuchFileException || failure instanceof FileNotFoundException) {
            return "there is no file " + file;
        }
        if (failure instanceof AccessDeniedException) {
            return "no right to use " + file;
        }
        String reason = failure instanceof FileSystemException system ? system.getReason() : failure.getMessage();
        if (reason == null) {
            return file + ": it cannot be used";
        }
        boolean unnamed = file.toString().isEmpty();
        return unnamed || reason.contains(String.valueOf(file.getFileName())) ? reason : file + ": " + reason;
    }
}
