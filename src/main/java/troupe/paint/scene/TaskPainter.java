package troupe.paint.scene;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import troupe.paint.Labels;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Paints where a journey starts, a ring, and where it ends, a flag whose foot is the goal. */
public final class TaskPainter {
    private static final double RING = 7;
    private static final double POLE = 26;

    private TaskPainter() {}

    /** Paints the ends of a journey in the colour of its actor, or else of walking. */
    public static void paint(Graphics2D graphics, Scene scene, Journey journey, Viewport view, Theme theme) {
        paintEnds(graphics, colour(scene, journey.actor(), theme), journey.start(), journey.goal(), view, theme);
    }

    /** Paints the ends of an encounter in the colour of its actor, or else of walking. */
    public static void paint(Graphics2D graphics, Scene scene, Encounter encounter, Viewport view, Theme theme) {
        Color colour = colour(scene, encounter.actor(), theme);
        paintEnds(graphics, colour, encounter.start(), encounter.goal(), view, theme);
    }

    private static Color colour(Scene scene, String actor, Theme theme) {
        return scene.actor(actor)
                .map(a -> Shapes.colour(a.colour(), theme.color(Tone.WALK)))
                .orElse(theme.color(Tone.WALK));
    }

    private static void paintEnds(
            Graphics2D graphics, Color colour, Place start, Place goal, Viewport view, Theme theme) {
        Graphics2D g = Shapes.smooth(graphics);
        paintStart(g, theme, colour, start, view);
        paintGoal(g, theme, colour, goal, view);
        g.dispose();
    }

    /** Takes the room of ring and flag, so that text keeps away from them. */
    public static void take(Labels labels, Journey journey, Viewport view) {
        take(labels, journey.start(), journey.goal(), view);
    }

    /** Takes the room of the ring and flag of an encounter. */
    public static void take(Labels labels, Encounter encounter, Viewport view) {
        take(labels, encounter.start(), encounter.goal(), view);
    }

    private static void take(Labels labels, Place start, Place goal, Viewport view) {
        double x = view.px(start.x());
        double y = view.py(start.y());
        labels.take(new Rectangle2D.Double(x - RING, y - RING, 2 * RING, 2 * RING));
        x = view.px(goal.x());
        y = view.py(goal.y());
        labels.take(new Rectangle2D.Double(x - 2, y - POLE, 20, POLE + 2));
    }

    private static void paintStart(Graphics2D g, Theme theme, Color colour, Place start, Viewport view) {
        double x = view.px(start.x());
        double y = view.py(start.y());
        Ellipse2D ring = new Ellipse2D.Double(x - RING, y - RING, 2 * RING, 2 * RING);
        g.setColor(theme.color(Tone.PANEL));
        g.fill(ring);
        g.setColor(colour);
        g.setStroke(Theme.line(3));
        g.draw(ring);
    }

    /** Paints a goal: a flag whose foot is the goal. */
    public static void paintGoal(Graphics2D g, Theme theme, Color colour, Place goal, Viewport view) {
        double x = view.px(goal.x());
        double y = view.py(goal.y());
        Path2D pennant = new Path2D.Double();
        pennant.moveTo(x, y - POLE);
        pennant.lineTo(x + 17, y - POLE + 6);
        pennant.lineTo(x, y - POLE + 13);
        pennant.closePath();
        g.setColor(theme.color(Tone.PANEL, 0.9));
        g.setStroke(Theme.line(5));
        g.draw(pennant);
        g.setColor(colour);
        g.fill(pennant);
        g.setStroke(Theme.line(2));
        g.draw(pennant);
        g.draw(new Line2D.Double(x, y, x, y - POLE));
    }
}
