package troupe.paint.scene;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Point;
import troupe.paint.Clipping;
import troupe.paint.Labels;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.scene.Ditch;
import troupe.scene.Obstacle;

/** Writes how high obstacles and how deep ditches are: inside where there is room, else beside on the floor. */
final class ElevationLabels {
    private static final float TEXT_SIZE = 12;
    private static final double[] ACROSS = {0, 0, 0, -0.28, 0.28};
    private static final double[] ALONG = {0, -0.28, 0.28, 0, 0};

    private final Graphics2D g;
    private final Theme theme;
    private final Viewport view;
    private final Clipping clipping;
    private final Labels labels;
    private final Font font = Theme.font(TEXT_SIZE);
    private final List<Shape> solids = new ArrayList<>();

    /** Makes a writer for one picture. */
    ElevationLabels(Graphics2D g, Theme theme, Viewport view, Labels labels) {
        this.g = g;
        this.theme = theme;
        this.view = view;
        this.clipping = new Clipping(g, view);
        this.labels = labels;
    }

    /** Keeps texts off movable obstacles, and texts beside an obstacle off everything that stands there. */
    void keepOff(List<ObstacleLook> looks) {
        for (ObstacleLook look : looks) {
            Shape shape = clipping.polygon(look.obstacle().outline());
            solids.add(shape);
            if (look.obstacle().movable()) {
                labels.take(shape.getBounds2D());
            }
        }
    }

    /** Writes the depth of a ditch, if it fits inside. */
    void write(Ditch ditch) {
        Shape shape = clipping.polygon(ditch.outline());
        inside(shape, ditch.outline().centroid(), Shapes.metres(-ditch.depth()), theme.color(Tone.TEXT));
    }

    /** Writes name and top of an obstacle, or its top alone; {@code asked} that it be written beside too. */
    void write(ObstacleLook look, boolean asked) {
        Obstacle obstacle = look.obstacle();
        Point centre = obstacle.outline().centroid();
        String number = Shapes.metres(obstacle.top());
        Shape shape = clipping.polygon(look.obstacle().outline());
        Color ink = look.hanging() ? theme.color(Tone.TEXT) : Shapes.ink(look.fill(theme));
        boolean named = !obstacle.label().isEmpty() && inside(shape, centre, obstacle.label() + " " + number, ink);
        if (named || inside(shape, centre, number, ink)) {
            return;
        }
        Rectangle2D room = shape.getBounds2D();
        if (asked || room.getWidth() > room.getHeight()) {
            beside(room, number);
        }
    }

    private boolean inside(Shape shape, Point centre, String text, Color ink) {
        Rectangle2D room = shape.getBounds2D();
        for (int k = 0; k < ACROSS.length; k++) {
            double x = view.px(centre.x()) + ACROSS[k] * room.getWidth();
            double y = view.py(centre.y()) + ALONG[k] * room.getHeight();
            Rectangle2D place = Labels.around(g, font, text, x, y);
            Rectangle2D padded = new Rectangle2D.Double(
                    place.getX() - 3, place.getY() + 1, place.getWidth() + 6, place.getHeight() - 2);
            if (shape.contains(padded) && labels.free(place)) {
                labels.draw(g, font, text, place, ink);
                return true;
            }
        }
        return false;
    }

    private void beside(Rectangle2D room, String number) {
        Rectangle2D text = Labels.around(g, font, number, 0, 0);
        double up = text.getHeight() / 2 + 2;
        double[] ys = {room.getMinY() - up, room.getMaxY() + up};
        double[] xs = {room.getMinX() + text.getWidth() / 2 + 6, room.getMaxX() - text.getWidth() / 2 - 6};
        for (int k = 0; k < 4; k++) {
            Rectangle2D place = Labels.around(g, font, number, xs[k / 2], ys[k % 2]);
            if (labels.free(place) && solids.stream().noneMatch(s -> s.intersects(place))) {
                labels.draw(g, font, number, place, theme.color(Tone.DIM));
                return;
            }
        }
    }
}
