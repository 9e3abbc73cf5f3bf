package troupe;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import troupe.exchange.ExchangeException;
import troupe.exchange.ExportSettings;
import troupe.exchange.Formats;
import troupe.exchange.ImageExport;
import troupe.paint.Picture;
import troupe.paint.Theme;
import troupe.run.Overlay;
import troupe.run.Run;
import troupe.scene.Scene;
import troupe.scene.SceneException;
import troupe.scene.SceneXml;
import troupe.work.Fields;
import troupe.work.Tasks;

/**
 * Makes the pictures of the documentation anew: {@code mvn -q test-compile exec:java
 * -Dexec.classpathScope=test -Dexec.mainClass=troupe.DocPictures}.
 */
public final class DocPictures {
    private static final Path SCENES = Path.of("scenes/unified");
    private static final Path FOLDER = Path.of("docs/pictures");
    private static final int WIDTH = 800;

    private DocPictures() {}

    /** Writes every picture into {@code docs/pictures}. */
    public static void main(String[] arguments) throws SceneException, ExchangeException, IOException {
        Files.createDirectories(FOLDER);
        plan("courtyard", "to-the-fountain", 0.3);
        plan("layers", "over-the-bridge", 0.45);
        plan("layers", "under-the-bridge", 0.5);
        plan("apartment", "kitchen-to-bedroom", 0.4);
        views("courtyard", "to-the-fountain");
        Run run = run(scene("courtyard"), "to-the-fountain");
        Formats.exporter("gif").write(run, ExportSettings.DEFAULT.wide(480), FOLDER.resolve("courtyard.gif"));
    }

    private static Scene scene(String name) throws SceneException, IOException {
        return SceneXml.read(SCENES.resolve(name + ".xml")).scene();
    }

    private static Run run(Scene scene, String task) {
        return Tasks.start(scene, task).finish();
    }

    /** Draws a plan at a share of its time, in both themes, with skeleton and contour lines. */
    private static void plan(String name, String task, double share) throws SceneException, IOException {
        Scene scene = scene(name);
        Run run = run(scene, task);
        Picture picture = Picture.of(run, share * run.frames().duration());
        write(picture, name + "-" + task);
        write(
                picture.with(overlays(scene, task, List.of("potential", "skeleton")))
                        .outlined()
                        .with(Theme.DARK),
                name + "-" + task + "-dark");
    }

    /** Draws each view of the grid core, in the layers that the goal can be reached from. */
    private static void views(String name, String task) throws SceneException, IOException {
        Scene scene = scene(name);
        for (String key : List.of("layers", "region", "class", "clearance", "potential", "effort")) {
            write(Picture.of(scene).with(overlays(scene, task, List.of(key))), name + "-" + key);
        }
        write(
                Picture.of(scene)
                        .with(overlays(scene, task, List.of("potential", "skeleton")))
                        .outlined(),
                name + "-skeleton");
    }

    private static List<Overlay> overlays(Scene scene, String task, List<String> keys) {
        Set<Integer> reached = new TreeSet<>();
        for (Overlay overlay : flat(Fields.of(scene, task, List.of("potential")))) {
            reached.add(overlay.layer());
        }
        return rescaled(flat(Fields.of(scene, task, keys)).stream()
                .filter(o -> o.key().equals("effort") || reached.contains(o.layer()))
                .toList());
    }

    /** Ends the scale of the clearance at the largest value that is shown. */
    private static List<Overlay> rescaled(List<Overlay> overlays) {
        double max = 0;
        for (Overlay overlay : overlays) {
            if (overlay.key().equals("clearance") && overlay instanceof Overlay.Field field) {
                for (float value : field.values()) {
                    max = value > max ? value : max;
                }
            }
        }
        Overlay.Scale scale = new Overlay.Continuous("m", 0, max, 0.25);
        return overlays.stream()
                .map(o -> o.key().equals("clearance") && o instanceof Overlay.Field f
                        ? new Overlay.Field(f.key(), f.layer(), f.frame(), f.values(), scale)
                        : o)
                .toList();
    }

    private static List<Overlay> flat(Fields fields) {
        List<Overlay> all = new ArrayList<>();
        fields.overlays().forEach(all::addAll);
        return all;
    }

    private static void write(Picture picture, String name) throws IOException {
        try (var out = Files.newOutputStream(FOLDER.resolve(name + ".png"))) {
            ImageExport.write(picture.image(WIDTH), out);
        }
    }
}
