package troupe.app.tool.select;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import troupe.app.document.Mark;
import troupe.app.document.Parts;
import troupe.app.document.Selection;
import troupe.app.look.Look;
import troupe.app.tool.Sketch;
import troupe.geometry.Point;
import troupe.paint.Labels;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.paint.motion.CrowdPainter;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Encounter;
import troupe.scene.Place;
import troupe.scene.Task;

/** Paints the parts of a task that are drawn and dragged: the ways of avatars, and where groups stand at first. Pure. */
public final class PartPainter {
    /** How much of a group's colour is left where it must stand out from a dark floor. */
    private static final double DARK = 0.6;

    /** So many lines above a thing, and below it, are tried for its name. */
    private static final int LINES = 4;

    /** Pixels between two lines; what {@link Labels} keeps free on each side of a text is less. */
    private static final double LEADING = 3;

    private PartPainter() {}

    /** Paints the parts of a task; those that are selected stand out. */
    public static void paint(Graphics2D g, Viewport view, Look look, Task task, Selection selection) {
        Labels labels = new Labels();
        if (task instanceof Encounter encounter) {
            for (Avatar avatar : encounter.avatars()) {
                boolean selected = selection.contains(Parts.id(task.id(), avatar.id()));
                paint(g, view, look, avatar, selected, labels);
            }
        } else if (task instanceof Crowd crowd) {
            Map<String, Color> colours = CrowdPainter.colours(crowd);
            crowd.allGroups().forEach(group -> {
                boolean selected = selection.contains(Parts.id(task.id(), group.id()));
                Color colour = colours.get(group.id());
                boolean dark = look.theme() == Theme.DARK;
                paint(g, view, look, group, dark ? Look.mix(colour, look.color(Tone.TEXT), DARK) : colour, selected);
                name(g, view, look, group, labels);
            });
        }
    }

    private static void paint(Graphics2D g, Viewport view, Look look, Avatar avatar, boolean selected, Labels labels) {
        Optional<Place> start = Mark.start(avatar);
        if (start.isEmpty()) {
            return;
        }
        Color colour =
                look.color(selected ? Tone.ACCENT : avatar.kind() == Avatar.Kind.CERTAIN ? Tone.SIDESTEP : Tone.MOVE);
        List<Point> way = new ArrayList<>(List.of(point(start.get())));
        Mark.heads(avatar).forEach(head -> way.add(point(head.to())));
        g.setColor(colour);
        g.setStroke(selected ? Theme.line(2, 5, 4) : Theme.line(1.2f, 3, 4));
        for (int i = 1; i < way.size(); i++) {
            g.draw(Sketch.line(view, way.get(i - 1), way.get(i)));
        }
        double r = Math.max(5, avatar.radius() * view.scale());
        Shape disc = new Ellipse2D.Double(
                view.px(way.get(0).x()) - r, view.py(way.get(0).y()) - r, 2 * r, 2 * r);
        g.setStroke(selected ? Theme.line(2.4f) : Theme.line(1.2f, 3, 3));
        g.draw(disc);
        for (int i = 1; i < way.size(); i++) {
            dot(g, view, look, way.get(i), colour);
        }
        Rectangle2D about = disc.getBounds2D();
        write(g, look, avatar.name(), about, colour, labels);
    }

    private static Point point(Place place) {
        return new Point(place.x(), place.y());
    }

    private static void dot(Graphics2D g, Viewport view, Look look, Point at, Color colour) {
        Ellipse2D dot = new Ellipse2D.Double(view.px(at.x()) - 4, view.py(at.y()) - 4, 8, 8);
        g.setColor(look.color(Tone.PANEL));
        g.fill(dot);
        g.setColor(colour);
        g.setStroke(Theme.line(1.6f));
        g.draw(dot);
    }

    private static void paint(
            Graphics2D g, Viewport view, Look look, CrowdGroup group, Color colour, boolean selected) {
        group.members().ifPresent(members -> {
            Shape outline = Sketch.path(members.spawn(), view);
            g.setColor(new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), selected ? 46 : 22));
            g.fill(outline);
            g.setColor(selected ? look.color(Tone.ACCENT) : colour);
            g.setStroke(selected ? Theme.line(2) : Theme.line(1.4f, 4, 4));
            g.draw(outline);
        });
    }

    /** Writes the name of a group and how many are in it, where its area is wide enough. */
    private static void name(Graphics2D g, Viewport view, Look look, CrowdGroup group, Labels labels) {
        group.members().ifPresent(members -> {
            Rectangle2D about = Sketch.path(members.spawn(), view).getBounds2D();
            String text = Parts.name(group) + " \u00b7 " + members.count();
            if (g.getFontMetrics(look.font()).stringWidth(text) <= Math.max(60, 2 * about.getWidth())) {
                write(g, look, text, about, look.color(Tone.TEXT), labels);
            }
        });
    }

    /** Writes a text above a thing or below it, on a trace of the floor's colour, clear of other texts; else not at all. */
    private static void write(Graphics2D g, Look look, String text, Rectangle2D about, Color colour, Labels labels) {
        g.setFont(look.font());
        FontMetrics metrics = g.getFontMetrics();
        double wide = metrics.stringWidth(text);
        double high = metrics.getAscent() + metrics.getDescent();
        for (int k = 0; k < 2 * LINES; k++) {
            double above = about.getMinY() - 5 + metrics.getDescent() - high - k / 2 * (high + LEADING);
            double below = about.getMaxY() + 3 + k / 2 * (high + LEADING);
            Rectangle2D place =
                    new Rectangle2D.Double(about.getCenterX() - wide / 2, k % 2 == 0 ? above : below, wide, high);
            if (labels.free(place)) {
                labels.take(place);
                label(g, look, text, (float) place.getX(), (float) place.getY() + metrics.getAscent(), colour);
                return;
            }
        }
    }

    private static void label(Graphics2D g, Look look, String text, float x, float py, Color colour) {
        g.setColor(look.theme().color(Tone.FLOOR, 0.8));
        for (int[] by : new int[][] {{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            g.drawString(text, x + by[0], py + by[1]);
        }
        g.setColor(colour);
        g.drawString(text, x, py);
    }
}
