package troupe.paint.motion;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.paint.Disc;
import troupe.paint.Labels;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.paint.scene.TaskPainter;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Scene;

/**
 * Paints an encounter at a time: the ways that all have come, the actor's plan, and everybody as a disc with its
 * heading. Uncertain avatars are hatched by an open ring, certain ones are full; who touches the actor gets a red
 * ring. Immutable; serves any thread.
 */
final class EncounterPainter {
    private static final double LEAST_RADIUS = 5;
    /** Seconds of a way that are shown; what lies further back has faded. */
    private static final double TRAIL = 6;

    private final Scene scene;
    private final Encounter encounter;
    private final Optional<Actor> actor;
    private final Frames frames;
    private final Theme theme;
    private final List<Track> tracks = new ArrayList<>();

    private EncounterPainter(Run run, Encounter encounter, Theme theme) {
        this.scene = run.scene();
        this.encounter = encounter;
        this.actor = run.scene().actor(encounter.actor());
        this.frames = run.frames();
        this.theme = theme;
        for (Track track : Track.of(run)) {
            if (track.owner().equals(encounter.actor())
                    || encounter.avatar(track.owner()).isPresent()) {
                tracks.add(track);
            }
        }
    }

    /** Makes the painter of a run, if it is that of an encounter. */
    static Optional<EncounterPainter> of(Run run, Theme theme) {
        return run.scene().task(run.task()).orElse(null) instanceof Encounter encounter
                ? Optional.of(new EncounterPainter(run, encounter, theme))
                : Optional.empty();
    }

    /** Paints start and goal. */
    void paintEnds(Graphics2D graphics, Viewport view) {
        TaskPainter.paint(graphics, scene, encounter, view, theme);
    }

    /** Paints what is there at a time in seconds; the run has a frame. */
    void paint(Graphics2D graphics, Viewport view, double time) {
        int frame = Track.frameAt(frames, time);
        Graphics2D g = Shapes.smooth(graphics);
        for (Track track : tracks) {
            paintTrail(g, view, track, frame);
        }
        paintPlan(g, view, frame);
        for (Track track : tracks) {
            if (!isActor(track) && track.isThere(frame)) {
                paintAvatar(g, view, track, frame);
            }
        }
        for (Track track : tracks) {
            if (isActor(track)) {
                paintDisc(g, view, track, frame, actorColour(), true);
            }
        }
        g.dispose();
    }

    private boolean isActor(Track track) {
        return track.owner().equals(encounter.actor());
    }

    private Color actorColour() {
        return actor.map(a -> Shapes.colour(a.colour(), theme.color(Tone.WALK))).orElse(theme.color(Tone.WALK));
    }

    private Color colour(Track track) {
        if (isActor(track)) {
            return actorColour();
        }
        Avatar avatar = encounter.avatar(track.owner()).orElseThrow();
        Tone tone = avatar.kind() == Avatar.Kind.CERTAIN ? Tone.SIDESTEP : Tone.MOVE;
        return Shapes.colour(avatar.colour(), theme.color(tone));
    }

    private double metres(Track track) {
        return isActor(track)
                ? actor.map(a -> a.walk().radius()).orElse(0.0)
                : encounter.avatar(track.owner()).orElseThrow().radius();
    }

    private double radius(Track track, Viewport view) {
        return Math.max(LEAST_RADIUS, view.scale() * metres(track));
    }

    private void paintTrail(Graphics2D g, Viewport view, Track track, int frame) {
        int first = isActor(track) ? 0 : (int) Math.max(0, frame - TRAIL * frames.rate());
        Path2D line = new Path2D.Double();
        boolean begun = false;
        for (int f = first; f <= frame; f++) {
            if (!track.isThere(f)) {
                begun = false;
                continue;
            }
            double x = view.px(track.x(f));
            double y = view.py(track.y(f));
            if (begun) {
                line.lineTo(x, y);
            } else {
                line.moveTo(x, y);
            }
            begun = true;
        }
        Color c = colour(track);
        g.setColor(new Color(c.getRed(), c.getGreen(), c.getBlue(), isActor(track) ? 255 : 130));
        g.setStroke(isActor(track) ? Theme.line(3) : Theme.line(1.6f));
        g.draw(line);
    }

    private void paintPlan(Graphics2D g, Viewport view, int frame) {
        int x = frames.channel(encounter.actor(), "plan.x");
        int y = frames.channel(encounter.actor(), "plan.y");
        if (x < 0 || y < 0) {
            return;
        }
        Path2D line = new Path2D.Double();
        int points = frames.channels().get(x).width();
        for (int k = 0; k < points; k++) {
            double px = view.px(frames.value(frame, x, k));
            double py = view.py(frames.value(frame, y, k));
            if (k == 0) {
                line.moveTo(px, py);
            } else {
                line.lineTo(px, py);
            }
        }
        g.setColor(theme.color(Tone.FLOOR, 0.8));
        g.setStroke(Theme.line(5));
        g.draw(line);
        g.setColor(actorColour());
        g.setStroke(Theme.line(2.4f, 1, 6));
        g.draw(line);
    }

    private void paintAvatar(Graphics2D g, Viewport view, Track track, int frame) {
        Avatar avatar = encounter.avatar(track.owner()).orElseThrow();
        Color c = colour(track);
        boolean certain = avatar.kind() == Avatar.Kind.CERTAIN;
        paintDisc(g, view, track, frame, certain ? c : new Color(c.getRed(), c.getGreen(), c.getBlue(), 150), certain);
        double r = radius(track, view);
        double x = view.px(track.x(frame));
        double y = view.py(track.y(frame));
        g.setColor(c);
        g.setStroke(Theme.line(1.8f));
        g.draw(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r));
        if (touches(track, frame)) {
            g.setColor(new Color(0xd11a2a));
            g.setStroke(Theme.line(3));
            g.draw(new Ellipse2D.Double(x - r - 3, y - r - 3, 2 * r + 6, 2 * r + 6));
        }
    }

    private boolean touches(Track track, int frame) {
        for (Track other : tracks) {
            if (isActor(other)) {
                double apart = Math.hypot(track.x(frame) - other.x(frame), track.y(frame) - other.y(frame));
                return apart < metres(track) + metres(other);
            }
        }
        return false;
    }

    private void paintDisc(Graphics2D g, Viewport view, Track track, int frame, Color colour, boolean edged) {
        double r = radius(track, view);
        double x = view.px(track.x(frame));
        double y = view.py(track.y(frame));
        Disc disc = new Disc(x, y, r, track.headingRad(frame));
        if (edged) {
            disc.paint(g, colour, theme.color(Tone.PANEL));
        } else {
            disc.paint(g, colour);
        }
    }

    /** Takes the room of the ends and of those who are there at a time in seconds (NaN: at no time). */
    void takeRoom(Labels labels, Viewport view, double time) {
        TaskPainter.take(labels, encounter, view);
        if (frames.count() == 0 || Double.isNaN(time)) {
            return;
        }
        int frame = Track.frameAt(frames, time);
        for (Track track : tracks) {
            if (track.isThere(frame)) {
                double r = radius(track, view);
                labels.take(
                        new Rectangle2D.Double(view.px(track.x(frame)) - r, view.py(track.y(frame)) - r, 2 * r, 2 * r));
            }
        }
    }
}
