package troupe;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Assumptions;

/** Finds the folder of real data that some tests read; it is no part of the repository. */
public final class SharedData {
    private static final List<String> PLACES = List.of("../shared/data", "../../shared/data");

    private SharedData() {}

    /** Returns the folder, or nothing where it is absent. */
    public static Optional<Path> folder() {
        return PLACES.stream().map(Path::of).filter(Files::isDirectory).findFirst();
    }

    /** Returns a file or folder of the data; skips the test with a message where it is absent. */
    public static Path require(String name) {
        Optional<Path> path = folder().map(f -> f.resolve(name)).filter(Files::exists);
        if (path.isEmpty()) {
            Assumptions.abort("skipped: no " + name + " in any of " + PLACES);
        }
        return path.get();
    }
}
