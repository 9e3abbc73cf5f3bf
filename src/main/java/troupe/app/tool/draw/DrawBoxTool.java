package troupe.app.tool.draw;

import java.awt.Cursor;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Optional;
import troupe.app.document.NewElements;
import troupe.app.document.Outlines;
import troupe.app.document.SceneEdits;
import troupe.app.look.Texts;
import troupe.app.tool.Editing;
import troupe.app.tool.Pointer;
import troupe.app.tool.ShapeCheck;
import troupe.app.tool.Sketch;
import troupe.app.tool.Snap;
import troupe.app.tool.Snapping;
import troupe.app.tool.Tool;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.Viewport;
import troupe.scene.Element;

/**
 * Draws an obstacle in one drag: a rectangle from corner to corner, with Shift a square, or a circle from its
 * middle. It is part of the scene while the button is down, so that the plan follows.
 */
public final class DrawBoxTool implements Tool {
    private static final int CIRCLE_CORNERS = 24;
    private static final double SLACK = 3;

    private final Editing editing;
    private final boolean round;
    private Pointer pressed;
    private Point from;
    private Optional<Snap> next = Optional.empty();
    private Optional<Polygon> shape = Optional.empty();

    /** Makes the tool; {@code round} says whether it draws circles. */
    public DrawBoxTool(Editing editing, boolean round) {
        this.editing = editing;
        this.round = round;
    }

    @Override
    public String key() {
        return round ? "circle" : "rectangle";
    }

    private Snap snap(Pointer pointer) {
        return new Snapping(
                        editing.document().scene(),
                        List.of(),
                        editing.view().get().scale())
                .place(pointer.at(), Optional.empty(), false, pointer.alt());
    }

    @Override
    public void press(Pointer pointer) {
        Snap snap = snap(pointer);
        pressed = pointer;
        from = snap.at();
        next = Optional.of(snap);
        shape = Optional.empty();
    }

    @Override
    public void drag(Pointer pointer) {
        if (from == null) {
            return;
        }
        Snap snap = snap(pointer);
        next = Optional.of(snap);
        shape = pointer.pixelsTo(pressed) > SLACK ? outline(snap.at(), pointer.shift()) : Optional.empty();
        if (shape.isPresent() && wrong().isEmpty()) {
            editing.document().preview(NewElements.with(editing.document().scene(), made(shape.get())));
        } else {
            editing.document().dropPreview();
        }
    }

    private Optional<Polygon> outline(Point to, boolean square) {
        if (round) {
            double radius = from.distance(to);
            return radius > 0 ? Optional.of(Outlines.circle(from, radius, CIRCLE_CORNERS)) : Optional.empty();
        }
        double dx = to.x() - from.x();
        double dy = to.y() - from.y();
        if (square) {
            double side = Math.max(Math.abs(dx), Math.abs(dy));
            dx = Math.copySign(side, dx);
            dy = Math.copySign(side, dy);
        }
        double x = SceneEdits.rounded(from.x() + dx);
        double y = SceneEdits.rounded(from.y() + dy);
        return Optional.of(Polygon.rectangle(
                Math.min(from.x(), x), Math.min(from.y(), y), Math.max(from.x(), x), Math.max(from.y(), y)));
    }

    private Optional<String> wrong() {
        return shape.flatMap(s -> ShapeCheck.wrong(s, editing.document().scene().world(), editing.texts()));
    }

    private Element made(Polygon outline) {
        return NewElements.obstacle(editing.document().scene(), outline, editing.texts());
    }

    @Override
    public void release(Pointer pointer) {
        if (from == null) {
            return;
        }
        drag(pointer);
        Optional<Polygon> drawn = wrong().isEmpty() ? shape : Optional.empty();
        cancel();
        if (drawn.isPresent()) {
            NewElements.add(editing.document(), editing.selection(), made(drawn.get()), editing.texts());
            editing.drawn().run();
        }
    }

    @Override
    public void move(Pointer pointer) {
        next = Optional.of(snap(pointer));
    }

    @Override
    public void cancel() {
        from = null;
        shape = Optional.empty();
        next = Optional.empty();
        editing.document().dropPreview();
    }

    @Override
    public String message() {
        if (shape.isEmpty() || from == null) {
            return "";
        }
        Polygon outline = shape.get();
        String size = round
                ? editing.texts()
                        .format("draw.radius", Texts.number(outline.bounds().width() / 2, 2))
                : Texts.number(outline.bounds().width(), 2) + " \u00d7 "
                        + Texts.number(outline.bounds().depth(), 2) + " m";
        return wrong().orElse(size);
    }

    @Override
    public Cursor cursor(Pointer pointer) {
        return Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR);
    }

    @Override
    public void paint(Graphics2D g, Viewport view) {
        boolean wrong = wrong().isPresent();
        shape.ifPresent(outline -> Sketch.outline(g, view, editing.look(), outline, wrong));
        next.ifPresent(snap -> {
            Sketch.guide(g, view, editing.look(), snap.guide(), snap.at());
            Sketch.beside(
                    g, editing.look(), view.px(snap.at().x()), view.py(snap.at().y()), message(), wrong);
        });
    }

    @Override
    public Object stamp() {
        return List.of(next, shape);
    }
}
