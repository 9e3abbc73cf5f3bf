package troupe.app.start;

import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.FileSystem;
import java.nio.file.FileSystemAlreadyExistsException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Finds the example scenes that the program brings along, in its jar or in the folder of its classes. */
public final class Examples {
    private static final String ANY = "/scenes/unified/courtyard.xml";
    private static final List<String> FIRST = List.of("unified", "risk", "crowd");

    private Examples() {}

    /**
     * Returns the example scenes by the folder they lie in: those of the unified planner first, the courtyard
     * before the others, the rest by name. Must not be called on the event thread.
     *
     * @throws IOException if the program brings none along, or they cannot be listed
     */
    public static Map<String, List<Path>> find() throws IOException {
        Path root = sample().getParent().getParent();
        List<Path> files = new ArrayList<>();
        try (Stream<Path> all = Files.walk(root, 2)) {
            all.filter(f -> f.getFileName().toString().endsWith(".xml")).forEach(files::add);
        }
        files.sort(Comparator.comparing((Path f) -> rank(folder(f)))
                .thenComparing(Examples::folder)
                .thenComparing(f -> !ANY.endsWith(f.getFileName().toString()))
                .thenComparing(f -> f.getFileName().toString()));
        Map<String, List<Path>> groups = new LinkedHashMap<>();
        files.forEach(
                f -> groups.computeIfAbsent(folder(f), k -> new ArrayList<>()).add(f));
        return groups;
    }

    /**
     * Returns the sample scene, the courtyard. Must not be called on the event thread.
     *
     * @throws IOException if the program brings none along
     */
    public static Path sample() throws IOException {
        URL one = Examples.class.getResource(ANY);
        if (one == null) {
            throw new IOException("the program brings no " + ANY + " along");
        }
        return path(one);
    }

    private static String folder(Path file) {
        return file.getParent().getFileName().toString().replace("/", "");
    }

    private static int rank(String folder) {
        int at = FIRST.indexOf(folder);
        return at < 0 ? FIRST.size() : at;
    }

    private static Path path(URL url) throws IOException {
        try {
            URI uri = url.toURI();
            return uri.getScheme().equals("jar") ? inJar(uri) : Path.of(uri);
        } catch (URISyntaxException e) {
            throw new IOException(url + " cannot be listed", e);
        }
    }

    /** Returns the path in the jar, which stays open as long as the program runs. */
    private static Path inJar(URI uri) throws IOException {
        FileSystem jar;
        try {
            jar = FileSystems.newFileSystem(uri, Map.of());
        } catch (FileSystemAlreadyExistsException e) {
            jar = FileSystems.getFileSystem(uri);
        }
        return jar.getPath(ANY);
    }
}
