package troupe.app.tool.draw;

import java.awt.Cursor;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Optional;
import troupe.app.document.CrowdEdits;
import troupe.app.document.NewElements;
import troupe.app.document.Parts;
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
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Draws a group of a crowd: a drag from corner to corner for the area where its members stand at first, then a click
 * where they go. Enter instead of the click sends them where the group goes to which they belong, or where the group
 * before them goes. It joins the crowd that is looked at, as a part of the group of groups that is selected, or a new one.
 */
public final class DrawGroupTool implements Tool {
    private static final double SLACK = 5;

    /** Members for each square metre, as many as stand easily. */
    private static final double DENSE = 0.8;

    private static final int MOST = 500;

    private final Editing editing;
    private Optional<Pointer> pressed = Optional.empty();
    private Optional<Point> from = Optional.empty();
    private Optional<Snap> next = Optional.empty();
    private Optional<Polygon> area = Optional.empty();
    private boolean drawn;
    private String refused = "";

    /** Makes the tool. */
    public DrawGroupTool(Editing editing) {
        this.editing = editing;
    }

    @Override
    public String key() {
        return "group";
    }

    private Snap snap(Pointer pointer) {
        Snapping snapping = new Snapping(
                editing.document().scene(), List.of(), editing.view().get().scale());
        return drawn && !pointer.alt()
                ? snapping.onGrid(pointer.at())
                : snapping.place(pointer.at(), Optional.empty(), false, pointer.alt());
    }

    @Override
    public void press(Pointer pointer) {
        refused = "";
        next = Optional.of(snap(pointer));
        pressed = Optional.of(pointer);
        if (!drawn) {
            from = next.map(Snap::at);
        }
    }

    @Override
    public void drag(Pointer pointer) {
        next = Optional.of(snap(pointer));
        if (!drawn && from.isPresent()) {
            Point a = from.get();
            Point b = next.get().at();
            boolean far = pressed.filter(p -> pointer.pixelsTo(p) > SLACK).isPresent();
            area = far && a.x() != b.x() && a.y() != b.y()
                    ? Optional.of(Polygon.rectangle(
                            Math.min(a.x(), b.x()),
                            Math.min(a.y(), b.y()),
                            Math.max(a.x(), b.x()),
                            Math.max(a.y(), b.y())))
                    : Optional.empty();
        }
    }

    @Override
    public void release(Pointer pointer) {
        if (pressed.isEmpty()) {
            return;
        }
        drag(pointer);
        pressed = Optional.empty();
        if (drawn) {
            Point at = next.orElseThrow().at();
            commit(Optional.of(Place.of(at.x(), at.y())));
        } else if (area.isPresent() && wrong().isEmpty()) {
            drawn = true;
        } else {
            refused = wrong().orElse(editing.texts().get("draw.area"));
            area = Optional.empty();
        }
    }

    @Override
    public void move(Pointer pointer) {
        next = Optional.of(snap(pointer));
    }

    private Optional<String> wrong() {
        return area.flatMap(a -> ShapeCheck.wrong(a, editing.document().scene().world(), editing.texts()));
    }

    @Override
    public boolean isDrawing() {
        return drawn;
    }

    @Override
    public void stepBack() {
        drawn = false;
        area = Optional.empty();
        refused = "";
    }

    /** {@inheritDoc} That is when there is a goal that the group can share. */
    @Override
    public void finish() {
        if (!drawn) {
            return;
        }
        Optional<CrowdGroup> family = family();
        Optional<Place> shared = looked().flatMap(
                        c -> c.allGroups().flatMap(g -> g.goal().stream()).reduce((first, last) -> last));
        if (family.isPresent() && family.get().goal().isPresent()) {
            commit(Optional.empty());
        } else if (shared.isPresent()) {
            commit(shared);
        } else {
            refused = editing.texts().get("draw.nogoal");
        }
    }

    private Optional<Crowd> looked() {
        return editing.document()
                .scene()
                .task(editing.document().task())
                .map(task -> task instanceof Crowd crowd ? crowd : null);
    }

    /** Returns the group of groups that is selected, if that is one of the crowd that is looked at. */
    private Optional<CrowdGroup> family() {
        return looked().flatMap(crowd -> editing.selection().ids().stream()
                .filter(id -> id.startsWith(Parts.id(crowd.id(), "")))
                .flatMap(id -> Parts.group(editing.document().scene(), id).stream())
                .filter(g -> g.members().isEmpty())
                .findFirst());
    }

    private void commit(Optional<Place> goal) {
        Scene scene = editing.document().scene();
        Optional<Crowd> present = looked();
        String family = family().map(CrowdGroup::id).orElse("");
        Crowd crowd = present.orElseGet(() -> NewElements.crowd(scene, editing.texts()));
        Polygon spawn = area.orElseThrow();
        int count = (int) Math.max(1, Math.min(MOST, Math.round(Math.abs(spawn.signedArea()) * DENSE)));
        CrowdGroup group = NewElements.group(
                scene, crowd, goal, NewElements.members(scene.world(), count, spawn), editing.texts());
        Crowd with = CrowdEdits.with(crowd, family, group);
        cancel();
        editing.document()
                .commit(
                        editing.texts().format("edit.draw", Parts.name(group)),
                        present.isPresent() ? scene.with(with) : NewElements.with(scene, with));
        editing.document().lookAt(crowd.id());
        editing.selection().set(List.of(Parts.id(crowd.id(), group.id())));
        editing.drawn().run();
    }

    @Override
    public void cancel() {
        pressed = Optional.empty();
        from = Optional.empty();
        next = Optional.empty();
        stepBack();
    }

    @Override
    public String message() {
        if (!refused.isEmpty()) {
            return refused;
        }
        if (drawn) {
            return editing.texts().get("draw.groupgoal");
        }
        return wrong().or(() -> area.map(DrawGroupTool::size)).orElse("");
    }

    private static String size(Polygon area) {
        return Texts.number(area.bounds().width(), 2) + " \u00d7 "
                + Texts.number(area.bounds().depth(), 2) + " m";
    }

    @Override
    public Cursor cursor(Pointer pointer) {
        return Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR);
    }

    @Override
    public void paint(Graphics2D g, Viewport view) {
        boolean wrong = wrong().isPresent();
        area.ifPresent(a -> Sketch.outline(g, view, editing.look(), a, wrong));
        next.ifPresent(snap -> {
            if (drawn) {
                g.setColor(editing.look().color(Tone.ACCENT));
                g.setStroke(Theme.line(2, 4, 5));
                g.draw(Sketch.line(view, area.orElseThrow().centroid(), snap.at()));
            }
            Sketch.guide(g, view, editing.look(), snap.guide(), snap.at());
            String text = drawn ? "" : message();
            Sketch.beside(
                    g, editing.look(), view.px(snap.at().x()), view.py(snap.at().y()), text, wrong);
        });
    }

    @Override
    public Object stamp() {
        return List.of(next, area, drawn, refused);
    }
}
