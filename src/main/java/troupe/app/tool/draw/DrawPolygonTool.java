package troupe.app.tool.draw;

import java.awt.Cursor;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import troupe.app.document.NewElements;
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
 * Draws an obstacle or a ditch corner by corner. A double click, Enter or a click on the first corner closes
 * it, if it is right; what is wrong with it is shown at once. Backspace or undo takes the last corner back.
 */
public final class DrawPolygonTool implements Tool {
    private static final double CLOSE = 9;

    private final Editing editing;
    private final boolean ditch;
    private final List<Point> corners = new ArrayList<>();
    private Optional<Snap> next = Optional.empty();
    private String refused = "";

    /** Makes the tool; {@code ditch} says whether it draws ditches. */
    public DrawPolygonTool(Editing editing, boolean ditch) {
        this.editing = editing;
        this.ditch = ditch;
    }

    @Override
    public String key() {
        return ditch ? "ditch" : "polygon";
    }

    private Snap snap(Pointer pointer) {
        Optional<Point> anchor = corners.isEmpty() ? Optional.empty() : Optional.of(corners.get(corners.size() - 1));
        return new Snapping(
                        editing.document().scene(),
                        List.of(),
                        editing.view().get().scale())
                .place(pointer.at(), anchor, pointer.shift(), pointer.alt());
    }

    @Override
    public void press(Pointer pointer) {
        refused = "";
        if (closes(pointer)) {
            finish();
            return;
        }
        Snap snap = snap(pointer);
        boolean again = !corners.isEmpty() && corners.get(corners.size() - 1).equals(snap.at());
        if (!again) {
            corners.add(snap.at());
        }
        next = Optional.of(snap);
    }

    private boolean closes(Pointer pointer) {
        if (corners.isEmpty()) {
            return false;
        }
        Viewport view = editing.view().get();
        Point first = corners.get(0);
        double away = Math.hypot(view.px(first.x()) - pointer.px(), view.py(first.y()) - pointer.py());
        return pointer.clicks() > 1 || corners.size() > 2 && away <= CLOSE;
    }

    @Override
    public void drag(Pointer pointer) {
        if (!corners.isEmpty()) {
            Point last = corners.remove(corners.size() - 1);
            Snap snap = snap(pointer);
            boolean again =
                    !corners.isEmpty() && corners.get(corners.size() - 1).equals(snap.at());
            corners.add(again ? last : snap.at());
            next = Optional.of(snap);
        }
    }

    @Override
    public void release(Pointer pointer) {
        move(pointer);
    }

    @Override
    public void move(Pointer pointer) {
        next = Optional.of(snap(pointer));
    }

    @Override
    public boolean isDrawing() {
        return !corners.isEmpty();
    }

    @Override
    public void stepBack() {
        refused = "";
        if (isDrawing()) {
            corners.remove(corners.size() - 1);
        }
    }

    @Override
    public void finish() {
        if (!isDrawing()) {
            return;
        }
        Optional<String> wrong = wrong(corners);
        if (wrong.isPresent()) {
            refused = wrong.get();
            return;
        }
        Polygon outline = polygon(corners);
        clear();
        Element made = ditch
                ? NewElements.ditch(editing.document().scene(), outline, editing.texts())
                : NewElements.obstacle(editing.document().scene(), outline, editing.texts());
        NewElements.add(editing.document(), editing.selection(), made, editing.texts());
        editing.drawn().run();
    }

    private void clear() {
        corners.clear();
        next = Optional.empty();
        refused = "";
    }

    private Optional<String> wrong(List<Point> places) {
        return ShapeCheck.wrong(polygon(places), editing.document().scene().world(), editing.texts());
    }

    private static Polygon polygon(List<Point> places) {
        double[] xs = places.stream().mapToDouble(Point::x).toArray();
        double[] ys = places.stream().mapToDouble(Point::y).toArray();
        return new Polygon(xs, ys);
    }

    @Override
    public void cancel() {
        clear();
    }

    /** Returns the corners with the one that a click would add now. */
    private List<Point> shape() {
        List<Point> all = new ArrayList<>(corners);
        next.map(Snap::at).filter(at -> all.isEmpty() || !all.contains(at)).ifPresent(all::add);
        return all;
    }

    @Override
    public String message() {
        if (!refused.isEmpty()) {
            return refused;
        }
        if (!isDrawing()) {
            return "";
        }
        List<Point> shape = shape();
        Optional<String> wrong = shape.size() < 3 ? Optional.empty() : wrong(shape);
        return wrong.orElse(editing.texts().get(corners.size() < 3 ? "draw.more" : "draw.close"));
    }

    @Override
    public Cursor cursor(Pointer pointer) {
        return Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR);
    }

    @Override
    public void paint(Graphics2D g, Viewport view) {
        List<Point> shape = shape();
        boolean wrong = isDrawing()
                && (!refused.isEmpty() || shape.size() > 2 && wrong(shape).isPresent());
        if (isDrawing() && shape.size() > 2) {
            Sketch.outline(g, view, editing.look(), polygon(shape), wrong);
        } else if (isDrawing()) {
            Sketch.line(g, view, editing.look(), shape, false);
        }
        for (int i = 0; i < corners.size(); i++) {
            Sketch.corner(g, view, editing.look(), corners.get(i), i == 0 && corners.size() > 2);
        }
        next.ifPresent(snap -> Sketch.guide(g, view, editing.look(), snap.guide(), snap.at()));
        if (wrong && next.isPresent()) {
            Point at = next.get().at();
            Sketch.beside(g, editing.look(), view.px(at.x()), view.py(at.y()), message(), true);
        }
    }

    @Override
    public Object stamp() {
        return List.of(List.copyOf(corners), next, refused);
    }
}
