package troupe.app;

import java.awt.EventQueue;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import troupe.app.document.SceneDocument;
import troupe.app.plan.PlanningSteps;
import troupe.app.session.SceneFiles;
import troupe.app.session.SceneText;
import troupe.app.session.Session;
import troupe.app.settings.Opening;
import troupe.app.settings.StudioSettings;
import troupe.exchange.Formats;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.Importer;
import troupe.grid.region.Groundworks;
import troupe.run.Engine;
import troupe.run.view.GridOverlays;
import troupe.run.view.Overlay;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.SceneChecks;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneSource;
import troupe.scene.xml.SceneXml;
import troupe.work.Tasks;
import troupe.work.inspect.SceneInspection;
import troupe.work.view.Fields;

/** Opens the studio. */
public final class Studio {
    /** The scene that is opened when none is named: in the working directory, or else in the program. */
    public static final String DEFAULT_SCENE = "scenes/unified/courtyard.xml";

    private Studio() {}

    /**
     * Opens a window with a scene, the default one if none is named, and returns once it is there; the
     * program lives on until the window is closed. Reads the file on the calling thread, which must not
     * be the event thread.
     *
     * @throws SceneException if the file is not a scene
     * @throws IOException if it cannot be read
     */
    public static void open(Optional<Path> scene) throws SceneException, IOException {
        if (System.getProperty("awt.useSystemAAFontSettings") == null) {
            System.setProperty("awt.useSystemAAFontSettings", "on");
        }
        StudioSettings settings = StudioSettings.ofPerson();
        boolean page = scene.isEmpty() && settings.opening() == Opening.PAGE;
        Path local = Path.of(DEFAULT_SCENE);
        Optional<Path> file = scene.or(() -> last(settings))
                .or(() -> Files.isRegularFile(local) ? Optional.of(local) : Optional.empty());
        Scene read = file.isPresent() ? FILES.read(file.get()) : builtIn();
        EventQueue.invokeLater(() -> {
            scene.ifPresent(settings::addRecent);
            Session session = new Session(new SceneDocument(read, file), new Steps(), FILES, EventQueue::invokeLater);
            StudioWindow window = new StudioWindow(session, settings, EventQueue::invokeLater);
            window.open();
            if (page) {
                window.pages().showStart();
            }
            session.planNow();
            if (scene.isEmpty()) {
                window.tour().offer(window.pages()::tour);
            }
        });
    }

    /** Returns the file opened last, if that is what the person wants to begin with and it is still a scene. */
    private static Optional<Path> last(StudioSettings settings) {
        Optional<Path> newest =
                settings.opening() == Opening.LAST ? settings.recent().stream().findFirst() : Optional.empty();
        return newest.filter(file -> {
            try {
                FILES.read(file);
                return true;
            } catch (SceneException | IOException e) {
                // gone or broken since; the sample scene is opened instead
                return false;
            }
        });
    }

    private static Scene builtIn() throws SceneException, IOException {
        try (InputStream stream = Studio.class.getResourceAsStream("/" + DEFAULT_SCENE)) {
            if (stream == null) {
                throw new IOException("the program holds no " + DEFAULT_SCENE + "; name a scene file");
            }
            return SceneXml.read(stream, DEFAULT_SCENE).scene();
        }
    }

    private static List<String> endings() {
        return Formats.importers().stream().map(i -> "." + i.extension()).toList();
    }

    /** Reads and writes the scene format, and reads every format that there is an importer for. */
    static final SceneFiles FILES = new SceneFiles() {
        @Override
        public Scene read(Path file) throws SceneException, IOException {
            return SceneXml.read(file).scene();
        }

        @Override
        public Scene convert(Path file) throws ExchangeException, IOException {
            Importer importer = Formats.importerFor(file)
                    .orElseThrow(() -> new ExchangeException(
                            String.valueOf(file.getFileName()),
                            0,
                            0,
                            "the ending names no format",
                            "choose a file that ends with " + String.join(" or ", endings())));
            return importer.read(file);
        }

        @Override
        public void write(Scene scene, Path file) throws IOException {
            SceneXml.write(scene, file);
        }
    };

    /** Writes and reads parts of scenes as texts, for the clipboard. */
    static final SceneText TEXT = new SceneText() {
        @Override
        public String write(Scene scene) {
            return SceneXml.write(scene);
        }

        @Override
        public Scene read(String text) throws SceneException, IOException {
            InputStream stream = new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8));
            return SceneXml.read(stream, "clipboard").scene();
        }
    };

    /** Starts tasks and checks as the command line does; plans while something is dragged share what they can. */
    static final class Steps implements PlanningSteps {
        private final Groundworks kept = new Groundworks();

        @Override
        public List<Problem> check(Scene scene) {
            return SceneChecks.check(scene);
        }

        @Override
        public List<Problem> inspect(Scene scene) {
            return SceneInspection.check(new SceneSource(scene, Map.of()));
        }

        @Override
        public Engine start(Scene scene, String task) {
            return Tasks.start(scene, task, kept);
        }

        @Override
        public List<Overlay> overlays(
                Scene scene, String task, Engine engine, List<Integer> chosen, Predicate<String> wanted) {
            List<Overlay> all = new ArrayList<>(engine.overlays(chosen, wanted));
            if (!(scene.task(task).orElse(null) instanceof Journey)) {
                return all;
            }
            Set<String> known = all.stream().map(Overlay::key).collect(Collectors.toSet());
            List<String> missing = GridOverlays.KEYS.stream()
                    .filter(k -> wanted.test(k) && !known.contains(k))
                    .toList();
            Fields.of(scene, task, missing).overlays().forEach(all::addAll);
            return all;
        }
    }
}
