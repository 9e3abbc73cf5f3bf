package troupe.paint.motion;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import troupe.paint.Clipping;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.run.Run;
import troupe.run.frame.Frames;

/**
 * Paints another run under the one that is shown, to compare them: its ways as long pale dashes in one ghost colour,
 * and where its movers are at a time as hollow discs. Immutable; serves any thread.
 */
public final class GhostPainter {
    private static final int MOST_WAYS = 300;
    private static final int MOST_POINTS = 400;
    private static final double LEAST_RADIUS = 7;

    private final Run run;
    private final Theme theme;
    private final List<Track> tracks;
    private final List<double[]> ways = new ArrayList<>();

    /** Makes a painter. Cost O(points of the legs + points of the tracks, at most {@value #MOST_POINTS} each). */
    public GhostPainter(Run run, Theme theme) {
        this.run = run;
        this.theme = theme;
        this.tracks = Track.of(run).stream()
                .filter(track -> run.scene().obstacle(track.owner()).isEmpty())
                .toList();
        for (Run.Leg leg : run.legs()) {
            double[] way = new double[2 * leg.points().size()];
            for (int i = 0; i < leg.points().size(); i++) {
                way[2 * i] = leg.points().get(i)[0];
                way[2 * i + 1] = leg.points().get(i)[1];
            }
            ways.add(way);
        }
        if (ways.isEmpty() && tracks.size() <= MOST_WAYS) {
            tracks.forEach(track -> ways.add(way(track)));
        }
    }

    private double[] way(Track track) {
        Frames frames = run.frames();
        int count = Math.min(frames.count(), MOST_POINTS);
        double[] way = new double[2 * count];
        int kept = 0;
        for (int k = 0; k < count; k++) {
            int frame = count == 1 ? 0 : (int) ((long) k * (frames.count() - 1) / (count - 1));
            double x = track.x(frame);
            double y = track.y(frame);
            if (Double.isFinite(x) && Double.isFinite(y)) {
                way[kept++] = x;
                way[kept++] = y;
            }
        }
        return java.util.Arrays.copyOf(way, kept);
    }

    /** Returns the one colour of ghosts. */
    public static Color colour(Theme theme) {
        return theme.color(Tone.DIM);
    }

    /** Paints the ways. */
    public void paintWays(Graphics2D graphics, Viewport view) {
        Graphics2D g = Shapes.smooth(graphics);
        Clipping clipping = new Clipping(g, view);
        for (double[] way : ways) {
            if (way.length >= 4) {
                g.setColor(theme.color(Tone.FLOOR, 0.7));
                g.setStroke(Theme.line(5));
                g.draw(clipping.line(way, 2));
                g.setColor(colour(theme));
                g.setStroke(stroke());
                g.draw(clipping.line(way, 2));
            }
        }
        g.dispose();
    }

    /** Returns the stroke of its ways. */
    public static BasicStroke stroke() {
        return Theme.line(2.4f, 10, 6);
    }

    /** Paints where its movers are at {@code time} seconds; at the end if it has ended by then. */
    public void paintMovers(Graphics2D graphics, Viewport view, double time) {
        if (run.frames().count() == 0) {
            return;
        }
        int frame = Track.frameAt(run.frames(), time);
        Graphics2D g = Shapes.smooth(graphics);
        g.setStroke(Theme.line(2));
        for (Track track : tracks) {
            double x = view.px(track.x(frame));
            double y = view.py(track.y(frame));
            if (Double.isFinite(x) && Double.isFinite(y)) {
                double metres = run.scene()
                        .actor(track.owner())
                        .map(a -> a.walk().radius())
                        .orElse(0.0);
                double r = Math.max(tracks.size() > MOST_WAYS ? 2 : LEAST_RADIUS, view.scale() * metres);
                double heading = track.headingRad(frame);
                g.setColor(theme.color(Tone.FLOOR, 0.5));
                g.fill(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r));
                g.setColor(colour(theme));
                g.draw(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r));
                g.draw(new Line2D.Double(x, y, x + r * Math.cos(heading), y - r * Math.sin(heading)));
            }
        }
        g.dispose();
    }
}
