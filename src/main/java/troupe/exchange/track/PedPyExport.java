package troupe.exchange.track;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import troupe.exchange.format.Body;
import troupe.exchange.format.Decimals;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.Exporter;
import troupe.exchange.format.Places;
import troupe.geometry.Polygon;
import troupe.paint.motion.Track;
import troupe.run.Run;
import troupe.scene.xml.AtomicFile;

/**
 * Writes trajectories as PedPy's {@code load_trajectory} reads them, checked against PedPy 1.5, and beside them the
 * walkable area as well-known text: {@code NAME.wkt}, or {@code NAME-1.wkt}, {@code NAME-2.wkt}, … for the phases
 * between which an obstacle is moved. Rows are sorted by number and then by frame; the frames of a number are
 * contiguous: one who goes away and comes back comes back under another number. Memory is bounded.
 */
public final class PedPyExport implements Exporter {
    private static final int FLUSH = 1 << 15;

    /** Makes the exporter. */
    public PedPyExport() {}

    @Override
    public String name() {
        return "pedpy";
    }

    @Override
    public String extension() {
        return "txt";
    }

    @Override
    public String about() {
        return "PedPy and JuPedSim: trajectories, and the walkable area beside them as .wkt";
    }

    @Override
    public void write(Run run, ExportSettings settings, Path target) throws IOException, ExchangeException {
        List<Track> tracks = run.frames().count() == 0 ? List.of() : Places.acting(run);
        if (tracks.isEmpty()) {
            throw new ExchangeException(
                    "the run", 0, 0, "nobody moves in it", "plan a task that has a solution; PedPy needs trajectories");
        }
        PedestrianGround ground = new PedestrianGround(run);
        List<String> numbers = new ArrayList<>();
        // the first pass sees who walks where, and that every number can be written
        Places.each(run, tracks, settings, places -> {
            ground.show(places);
            stretches(places, numbers);
        });
        List<PedestrianGround.Phase> phases = ground.phases();
        List<WalkableArea> areas = new ArrayList<>();
        for (PedestrianGround.Phase phase : phases) {
            areas.add(ground.in(phase));
        }
        for (int k = 0; k < areas.size(); k++) {
            String text = text(areas.get(k)) + "\n";
            AtomicFile.write(
                    beside(target, areas.size() == 1 ? "" : "-" + (k + 1)),
                    out -> out.write(text.getBytes(StandardCharsets.US_ASCII)));
        }
        String header = header(run, numbers, phases, areas);
        AtomicFile.write(target, out -> {
            out.write(header.getBytes(StandardCharsets.UTF_8));
            rows(run, tracks, settings, out);
        });
    }

    private static Path beside(Path target, String number) {
        String name = String.valueOf(target.getFileName());
        String base = name.toLowerCase(Locale.ROOT).endsWith(".txt") ? name.substring(0, name.length() - 4) : name;
        return target.resolveSibling(base + number + ".wkt");
    }

    /** Adds the id once for each time that the thing comes. */
    private static void stretches(Places places, List<String> numbers) {
        for (int frame = 0; frame < places.x().length; frame++) {
            if (places.isThere(frame) && (frame == 0 || !places.isThere(frame - 1))) {
                numbers.add(places.track().id());
            }
        }
    }

    /** Returns the lines before the rows; the unit is read from them, so none may hold "in m" or the like by chance. */
    private static String header(
            Run run, List<String> numbers, List<PedestrianGround.Phase> phases, List<WalkableArea> areas) {
        StringBuilder out = new StringBuilder("# framerate: ");
        String rate = Decimals.trimmed(run.frames().rate());
        int point = rate.indexOf('.');
        out.append(rate)
                .append(point < 0 ? ".00" : rate.length() - point == 2 ? "0" : "")
                .append('\n');
        for (int k = 0; k < areas.size(); k++) {
            WalkableArea area = areas.get(k);
            out.append("# walkable area ").append(k + 1).append(": frames ");
            out.append(phases.get(k).first())
                    .append(" to ")
                    .append(phases.get(k).last());
            if (area.leftOut() > 0) {
                out.append("; left out, being cut off: ")
                        .append(Decimals.trimmed(area.leftOut()))
                        .append(" m2");
            }
            if (area.outside() > 0) {
                out.append("; people not on it at its first frame: ").append(area.outside());
            }
            out.append('\n');
        }
        for (int k = 0; k < numbers.size(); k++) {
            out.append("# id ")
                    .append(k + 1)
                    .append(" = ")
                    .append(numbers.get(k))
                    .append('\n');
        }
        return out.append("# id\tframe\tx/m\ty/m\tz/m\theading/deg\tradius/m\tability\n")
                .toString();
    }

    private static void rows(Run run, List<Track> tracks, ExportSettings settings, OutputStream out)
            throws IOException, ExchangeException {
        Map<String, Body> bodies = Body.of(run);
        int[] number = {0};
        Places.each(run, tracks, settings, places -> {
            Body body = bodies.get(places.track().owner());
            String radius = Decimals.trimmed(body == null ? 0 : body.radius());
            StringBuilder rows = new StringBuilder();
            for (int frame = 0; frame < places.x().length; frame++) {
                if (!places.isThere(frame)) {
                    continue;
                }
                number[0] += frame == 0 || !places.isThere(frame - 1) ? 1 : 0;
                rows.append(number[0]).append('\t').append(frame).append('\t');
                Decimals.six(rows, places.x()[frame]).append('\t');
                Decimals.six(rows, places.y()[frame]).append('\t');
                Decimals.six(rows, places.z()[frame]).append('\t');
                double degrees = Math.toDegrees(Math.IEEEremainder(places.headingRad()[frame], 2 * Math.PI));
                Decimals.six(rows, degrees).append('\t').append(radius).append('\t');
                rows.append(places.words()[frame].isEmpty() ? "-" : places.words()[frame])
                        .append('\n');
                if (rows.length() > FLUSH) {
                    out.write(rows.toString().getBytes(StandardCharsets.UTF_8));
                    rows.setLength(0);
                }
            }
            out.write(rows.toString().getBytes(StandardCharsets.UTF_8));
        });
    }

    /** Returns a polygon with holes as well-known text. */
    private static String text(WalkableArea area) {
        StringBuilder out = new StringBuilder("POLYGON (");
        ring(out, area.outline());
        for (Polygon hole : area.holes()) {
            ring(out.append(", "), hole);
        }
        return out.append(')').toString();
    }

    private static void ring(StringBuilder out, Polygon ring) {
        out.append('(');
        for (int i = 0; i <= ring.size(); i++) {
            int k = i % ring.size();
            out.append(i == 0 ? "" : ", ").append(Decimals.trimmed(ring.x(k)));
            out.append(' ').append(Decimals.trimmed(ring.y(k)));
        }
        out.append(')');
    }
}
