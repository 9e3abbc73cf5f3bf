package troupe.exchange.script;

import java.awt.Color;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import troupe.exchange.format.Body;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.Places;
import troupe.exchange.format.StreamExporter;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.motion.Track;
import troupe.run.Run;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;

/**
 * Writes a run as a script that rebuilds it in a program for animation (Crowd section 4.4): obstacles as polygons
 * extruded, the floors of ditches, one transform for each actor and each obstacle that is moved, with a key at every
 * frame. Actors are upright prisms of their radius and height with a beak where they head. Memory is bounded.
 */
public final class ScriptExport implements StreamExporter {
    private static final Color STONE = new Color(0x9a9da1);
    private static final Color WOOD = new Color(0xb4783c);
    private static final Color EARTH = new Color(0x6b5a48);
    private static final double FLOOR = 0.02;

    private final String name;
    private final String extension;
    private final String about;
    private final Supplier<SceneScript> language;

    /** Makes the exporter of a language. */
    public ScriptExport(String name, String extension, String about, Supplier<SceneScript> language) {
        this.name = name;
        this.extension = extension;
        this.about = about;
        this.language = language;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String extension() {
        return extension;
    }

    @Override
    public String about() {
        return about;
    }

    @Override
    public void write(Run run, ExportSettings settings, OutputStream out) throws IOException, ExchangeException {
        SceneScript script = language.get();
        String title = run.scene().title();
        script.begin(
                (title.isEmpty() ? "A scene" : title) + ": " + run.task(),
                run.frames().rate(),
                run.frames().count());
        List<Track> tracks = run.frames().count() == 0 ? List.of() : Track.of(run);
        solids(run, tracks, script);
        Places.each(run, tracks, settings, places -> keys(places, script, out));
        script.end();
        flush(script, out);
    }

    private static void solids(Run run, List<Track> tracks, SceneScript script) {
        Set<String> moving = new TreeSet<>();
        tracks.forEach(track -> moving.add(track.owner()));
        for (Ditch ditch : run.scene().ditches()) {
            script.solid(ditch.id(), turned(ditch.outline()), -ditch.depth() - FLOOR, FLOOR, EARTH);
        }
        for (Obstacle obstacle : run.scene().obstacles()) {
            Color plain = obstacle.movable() ? WOOD : STONE;
            Color colour = obstacle.colour().isEmpty() ? plain : Color.decode(obstacle.colour());
            boolean moved = moving.contains(obstacle.id());
            Polygon outline = turned(moved ? centred(obstacle.outline()) : obstacle.outline());
            // the keys of one that is moved hold the elevation of its bottom
            script.solid(obstacle.id(), outline, moved ? 0 : obstacle.offset(), obstacle.height(), colour);
        }
        Map<String, Body> bodies = Body.of(run);
        for (Track track : tracks) {
            Body body = bodies.get(track.owner());
            if (body != null) {
                script.solid(track.id(), body.outline(), 0, body.height(), body.colour());
            }
        }
    }

    private static Polygon centred(Polygon outline) {
        Point c = outline.centroid();
        double[] xs = new double[outline.size()];
        double[] ys = new double[outline.size()];
        for (int i = 0; i < xs.length; i++) {
            xs[i] = outline.x(i) - c.x();
            ys[i] = outline.y(i) - c.y();
        }
        return new Polygon(xs, ys);
    }

    /** Returns an outline that runs counter-clockwise. */
    private static Polygon turned(Polygon outline) {
        if (outline.signedArea() >= 0) {
            return outline;
        }
        int n = outline.size();
        double[] xs = new double[n];
        double[] ys = new double[n];
        for (int i = 0; i < n; i++) {
            xs[i] = outline.x(n - 1 - i);
            ys[i] = outline.y(n - 1 - i);
        }
        return new Polygon(xs, ys);
    }

    private static void keys(Places places, SceneScript script, OutputStream out) throws IOException {
        script.beginKeys(places.track().id());
        double[] degrees = places.steadyDegrees();
        boolean before = true;
        for (int frame = 0; frame < degrees.length; frame++) {
            boolean there = places.isThere(frame);
            if (there != before) {
                script.shown(frame, there);
                before = there;
            }
            if (there) {
                script.key(frame, places.x()[frame], places.y()[frame], places.z()[frame], degrees[frame]);
            }
            if (frame % 1024 == 0) {
                flush(script, out);
            }
        }
        script.endKeys();
        flush(script, out);
    }

    private static void flush(SceneScript script, OutputStream out) throws IOException {
        out.write(script.take().getBytes(StandardCharsets.US_ASCII));
    }
}
