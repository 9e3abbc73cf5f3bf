package troupe.app.tool.select;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import troupe.app.document.Mark;
import troupe.app.document.Parts;
import troupe.app.document.Selection;
import troupe.app.look.Look;
import troupe.app.tool.Sketch;
import troupe.geometry.Box;
import troupe.geometry.Point;
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

    private PartPainter() {}

    /** Paints the parts of a task; those that are selected stand out. */
    public static void paint(Graphics2D g, Viewport view, Look look, Task task, Selection selection) {
        if (task instanceof Encounter encounter) {
            for (Avatar avatar : encounter.avatars()) {
                boolean selected = selection.contains(Parts.id(task.id(), avatar.id()));
                paint(g, view, look, avatar, selected);
            }
        } else if (task instanceof Crowd crowd) {
            Map<String, Color> colours = CrowdPainter.colours(crowd);
            crowd.allGroups().forEach(group -> {
                boolean selected = selection.contains(Parts.id(task.id(), group.id()));
                Color colour = colours.get(group.id());
                boolean dark = look.theme() == Theme.DARK;
                paint(g, view, look, group, dark ? Look.mix(colour, look.color(Tone.TEXT), DARK) : colour, selected);
            });
        }
    }

    private static void paint(Graphics2D g, Viewport view, Look look, Avatar avatar, boolean selected) {
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
        g.setFont(look.font());
        label(
                g,
                look,
                avatar.name(),
                view.px(way.get(0).x()),
                view.py(way.get(0).y()) - r - 5,
                colour);
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
            Box box = members.spawn().bounds();
            String text = Parts.name(group) + " \u00b7 " + members.count();
            g.setFont(look.font());
            if (g.getFontMetrics().stringWidth(text) <= Math.max(60, 2 * box.width() * view.scale())) {
                double x = view.px((box.minX() + box.maxX()) / 2);
                label(g, look, text, x, view.py(box.maxY()) - 5, look.color(Tone.TEXT));
            }
        });
    }

    /** Writes a text with its middle above a pixel, on a trace of the floor's colour. */
    private static void label(Graphics2D g, Look look, String text, double px, double py, Color colour) {
        float x = (float) (px - g.getFontMetrics().stringWidth(text) / 2.0);
        g.setColor(look.theme().color(Tone.FLOOR, 0.8));
        for (int[] by : new int[][] {{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
            g.drawString(text, x + by[0], (float) py + by[1]);
        }
        g.setColor(colour);
        g.drawString(text, x, (float) py);
    }
}
