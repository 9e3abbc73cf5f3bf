package troupe;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import troupe.app.StudioPictures;
import troupe.exchange.Formats;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.picture.ImageExport;
import troupe.paint.Theme;
import troupe.paint.picture.Picture;
import troupe.paint.solid.Camera;
import troupe.run.Run;
import troupe.run.view.Overlay;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.work.Tasks;
import troupe.work.view.Fields;

/**
 * Makes the pictures of the documentation anew: {@code mvn test -Dtest=DocPictures}, those of the window only
 * where there is a display ({@code xvfb-run -a -s "-screen 0 1600x1000x24"} before it makes one). Takes a minute or
 * two; no part of the suite.
 */
class DocPictures {
    private static final Path SCENES = Path.of("scenes/unified");
    private static final Path FOLDER = Path.of("docs/pictures");
    private static final int WIDTH = 800;

    /** Writes every picture into {@code docs/pictures}. */
    @Test
    void writesEveryPicture() throws Exception {
        System.setProperty("awt.useSystemAAFontSettings", "on");
        Files.createDirectories(FOLDER);
        plan("courtyard", "to-the-fountain", 0.69);
        dark("courtyard", "to-the-fountain", 0.69);
        plan("layers", "over-the-bridge", 0.45);
        plan("layers", "under-the-bridge", 0.5);
        plan("apartment", "kitchen-to-bedroom", 0.4);
        views("courtyard", "to-the-fountain");
        Run run = run(scene("courtyard"), "to-the-fountain");
        write(Picture.of(run, 0.69 * run.frames().duration()).solid(Camera.Angle.DEFAULT), "courtyard-solid");
        Formats.exporter("gif").write(run, ExportSettings.DEFAULT.wide(480), FOLDER.resolve("courtyard.gif"));
        if (GraphicsEnvironment.isHeadless()) {
            System.out.println("there is no display: the pictures of the window were not made");
        } else {
            StudioPictures.write(FOLDER);
        }
    }

    private static Scene scene(String name) throws SceneException, IOException {
        return SceneXml.read(SCENES.resolve(name + ".xml")).scene();
    }

    private static Run run(Scene scene, String task) {
        return Tasks.start(scene, task).finish();
    }

    /** Draws a plan at a share of its time. */
    private static void plan(String name, String task, double share) throws SceneException, IOException {
        Run run = run(scene(name), task);
        write(Picture.of(run, share * run.frames().duration()), name + "-" + task);
    }

    /** Draws a plan in the dark theme, with skeleton and contour lines. */
    private static void dark(String name, String task, double share) throws SceneException, IOException {
        Scene scene = scene(name);
        Run run = run(scene, task);
        Picture picture = Picture.of(run, share * run.frames().duration());
        write(
                picture.with(overlays(scene, task, List.of("potential", "skeleton")))
                        .outlined()
                        .with(Theme.DARK),
                name + "-" + task + "-dark");
    }

    /** Draws each view of the grid core, in the layers that the goal can be reached from. */
    private static void views(String name, String task) throws SceneException, IOException {
        Scene scene = scene(name);
        for (String key : List.of("layers", "region", "class", "opening", "clearance", "potential", "effort")) {
            write(Picture.of(scene).with(overlays(scene, task, List.of(key))), name + "-" + key);
        }
        write(
                Picture.of(scene)
                        .with(overlays(scene, task, List.of("potential", "skeleton")))
                        .outlined(),
                name + "-skeleton");
    }

    /** Returns views of the storeys that the goal can be reached from. */
    private static List<Overlay> overlays(Scene scene, String task, List<String> keys) {
        List<Overlay> potential = flat(Fields.of(scene, task, List.of("potential")));
        Set<Integer> reached = new TreeSet<>();
        potential.forEach(o -> reached.add(o.layer()));
        List<Overlay> shown = flat(Fields.of(scene, task, keys)).stream()
                .filter(o -> o.key().equals("effort") || reached.contains(o.layer()))
                .toList();
        return keys.contains("clearance")
                ? onTheWay(shown, flat(Fields.of(scene, task, List.of("elevation"))), potential)
                : shown;
    }

    /** Leaves the values on the ground and on what can be reached, not those on walls, and ends their scale there. */
    private static List<Overlay> onTheWay(List<Overlay> shown, List<Overlay> elevation, List<Overlay> potential) {
        List<float[]> kept = new ArrayList<>();
        float max = 0;
        for (Overlay overlay : shown) {
            float[] values = values(overlay, shown).clone();
            float[] floor = values(overlay, elevation);
            float[] way = values(overlay, potential);
            for (int i = 0; i < values.length; i++) {
                values[i] = Math.abs(floor[i]) < 0.05 || !Float.isNaN(way[i]) ? values[i] : Float.NaN;
                max = values[i] > max ? values[i] : max;
            }
            kept.add(values);
        }
        List<Overlay> result = new ArrayList<>();
        for (int k = 0; k < kept.size(); k++) {
            Overlay.Field field = (Overlay.Field) shown.get(k);
            result.add(new Overlay.Field(
                    field.key(), field.layer(), field.frame(), kept.get(k), new Overlay.Continuous("m", 0, max, 0.25)));
        }
        return result;
    }

    /** Returns the values of the field among {@code fields} that lies in the layer of another. */
    private static float[] values(Overlay other, List<Overlay> fields) {
        return fields.stream()
                .filter(f -> f.layer() == other.layer())
                .map(f -> ((Overlay.Field) f).values())
                .findFirst()
                .orElseThrow();
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
