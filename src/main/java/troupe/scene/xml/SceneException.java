package troupe.scene.xml;

import java.util.List;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;

/** Tells that a file is not a scene: where, what was expected and what was found. Its message is one line. */
public final class SceneException extends Exception {
    private final transient List<Problem> problems;

    /**
     * Makes the exception of a file with everything that was found wrong, first first.
     *
     * @param problems at least one
     */
    public SceneException(String file, List<Problem> problems) {
        super(file + ": " + problems.get(0).describe()
                + (problems.size() > 1 ? " (and " + (problems.size() - 1) + " more)" : ""));
        this.problems = List.copyOf(problems);
    }

    /** Makes the exception of a single mistake; {@code line} is 0 where none can be named. */
    public SceneException(String file, int line, String message, String cure) {
        this(file, List.of(new Problem(Severity.ERROR, "", line, message, cure)));
    }

    /** Returns everything that was found wrong, in the order of the file; at least one. */
    public List<Problem> problems() {
        return problems;
    }
}
