package troupe.paint.solid;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Polygon;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.scene.Ditch;
import troupe.scene.Scene;

/**
 * Draws the ground as a block with its ditches dug out. Where ditches overlap, the deepest counts. Immutable;
 * serves any thread.
 */
final class SolidGround {
    /** The thickness of the block in metres. */
    static final double THICK = 0.2;

    /** Edges that another ditch may cut are drawn in pieces of this length in metres. */
    private static final double PIECE = 0.1;

    private static final int MOST_PIECES = 400;

    private final Polygon outline;
    private final List<Ditch> ditches;
    private final Theme theme;

    /** Takes the ground of a scene. */
    SolidGround(Scene scene, Theme theme) {
        this.theme = theme;
        this.outline = Polygon.rectangle(
                0,
                0,
                Math.max(0, scene.world().width()),
                Math.max(0, scene.world().depth()));
        this.ditches = scene.ditches().stream().filter(d -> d.depth() > 0).toList();
    }

    /** Draws the block. */
    void paint(Stage stage) {
        List<Polygon> holes = ditches.stream().map(Ditch::outline).toList();
        if (!ditches.isEmpty()) {
            ditches.forEach(ditch -> paint(stage, ditch));
            stage.keepWithin(holes, 0);
        }
        Color floor = theme.color(Tone.FLOOR);
        Color side = Shapes.blend(floor, theme.color(Tone.STEP), theme == Theme.LIGHT ? 0.3 : 0.2);
        for (int i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
            stage.side(outline.x(j), outline.y(j), outline.x(i), outline.y(i), -THICK, 0, side);
        }
        stage.floor(outline, 0, floor, holes);
        stage.outline(outline, 0, 1, theme.color(Tone.LINE));
        for (Ditch ditch : ditches) {
            stage.outline(ditch.outline(), 0, 1, theme.color(Tone.DITCH_EDGE));
        }
    }

    private void paint(Stage stage, Ditch ditch) {
        List<Ditch> others = ditches.stream()
                .filter(o ->
                        o != ditch && o.outline().bounds().meets(ditch.outline().bounds()))
                .toList();
        List<Polygon> deeper = new ArrayList<>();
        for (Ditch other : others) {
            if (other.depth() > ditch.depth()) {
                deeper.add(other.outline());
            }
        }
        Color colour = theme.color(Tone.DITCH);
        stage.floor(ditch.outline(), -ditch.depth(), colour, deeper);
        Polygon ring = ditch.outline();
        boolean left = ring.signedArea() >= 0;
        for (int i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            // seen from inside: the way round is turned
            int from = left ? i : j;
            int to = left ? j : i;
            wall(stage, ditch, others, ring.x(from), ring.y(from), ring.x(to), ring.y(to));
        }
    }

    private void wall(Stage stage, Ditch ditch, List<Ditch> others, double x0, double y0, double x1, double y1) {
        Color colour = theme.color(Tone.DITCH);
        int pieces = others.isEmpty()
                ? 1
                : (int) Math.max(1, Math.min(MOST_PIECES, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / PIECE)));
        for (int k = 0; k < pieces; k++) {
            double from = (double) k / pieces;
            double to = (k + 1.0) / pieces;
            double middle = (from + to) / 2;
            double high = 0;
            for (Ditch other : others) {
                if (other.outline().contains(x0 + middle * (x1 - x0), y0 + middle * (y1 - y0))) {
                    high = Math.min(high, -other.depth());
                }
            }
            double fromX = x0 + from * (x1 - x0);
            double fromY = y0 + from * (y1 - y0);
            double toX = x0 + to * (x1 - x0);
            double toY = y0 + to * (y1 - y0);
            stage.side(fromX, fromY, toX, toY, -ditch.depth(), high, colour);
        }
    }
}
