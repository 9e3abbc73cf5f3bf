package troupe.exchange;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.Exporter;
import troupe.exchange.format.Importer;
import troupe.exchange.picture.GifExport;
import troupe.exchange.picture.ImageExport;
import troupe.exchange.picture.ImagesExport;
import troupe.exchange.picture.SvgExport;
import troupe.exchange.scenario.MovingAiMap;
import troupe.exchange.scenario.NamosimImport;
import troupe.exchange.script.BlenderScript;
import troupe.exchange.script.MelScript;
import troupe.exchange.script.ScriptExport;
import troupe.exchange.track.CsvExport;
import troupe.exchange.track.PedPyExport;
import troupe.scene.Scene;

/** Lists the formats that runs are written to and scenes are read from; one line registers a format. */
public final class Formats {
    private static final List<Exporter> EXPORTERS = List.of(
            new CsvExport(),
            new PedPyExport(),
            new ScriptExport("mel", "mel", "Maya: obstacles, and a transform with keys for each actor", MelScript::new),
            new ScriptExport("blender", "py", "Blender: the same, as a Python script", BlenderScript::new),
            new SvgExport(),
            new ImageExport(),
            new ImagesExport(),
            new GifExport());
    private static final List<Importer> IMPORTERS = List.of(new MapImport(), new NamosimImport());

    private Formats() {}

    /** Returns all exporters, in the order of the documentation. */
    public static List<Exporter> exporters() {
        return EXPORTERS;
    }

    /** Returns all importers, in the order of the documentation. */
    public static List<Importer> importers() {
        return IMPORTERS;
    }

    /**
     * Finds an exporter by its name.
     *
     * @throws IllegalArgumentException that lists the known names
     */
    public static Exporter exporter(String name) {
        return EXPORTERS.stream()
                .filter(e -> e.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("format '" + name + "'; known are "
                        + String.join(
                                ", ", EXPORTERS.stream().map(Exporter::name).toList())));
    }

    /** Finds the first exporter whose files end as {@code file} does. */
    public static Optional<Exporter> exporterFor(Path file) {
        return EXPORTERS.stream().filter(e -> endsWith(file, e.extension())).findFirst();
    }

    /**
     * Finds an importer by its name.
     *
     * @throws IllegalArgumentException that lists the known names
     */
    public static Importer importer(String name) {
        return IMPORTERS.stream()
                .filter(i -> i.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("format '" + name + "'; known are "
                        + String.join(
                                ", ", IMPORTERS.stream().map(Importer::name).toList())));
    }

    /** Finds the first importer whose files end as {@code file} does. */
    public static Optional<Importer> importerFor(Path file) {
        return IMPORTERS.stream().filter(i -> endsWith(file, i.extension())).findFirst();
    }

    private static boolean endsWith(Path file, String extension) {
        return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT).endsWith("." + extension);
    }

    /** Reads MovingAI maps. */
    private static final class MapImport implements Importer {
        @Override
        public String name() {
            return "movingai";
        }

        @Override
        public String extension() {
            return "map";
        }

        @Override
        public String about() {
            return "MovingAI grid map: exact cells, an actor that only walks";
        }

        @Override
        public Scene read(Path file) throws IOException, ExchangeException {
            return MovingAiMap.read(file).scene();
        }
    }
}
