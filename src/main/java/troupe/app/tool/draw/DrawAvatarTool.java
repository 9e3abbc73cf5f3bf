package troupe.app.tool.draw;

import java.awt.Cursor;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import troupe.app.document.Mark;
import troupe.app.document.NewElements;
import troupe.app.document.Parts;
import troupe.app.tool.Editing;
import troupe.app.tool.Guide;
import troupe.app.tool.Hits;
import troupe.app.tool.Pointer;
import troupe.app.tool.Sketch;
import troupe.app.tool.Snap;
import troupe.app.tool.Snapping;
import troupe.app.tool.Tool;
import troupe.app.tool.select.Gesture;
import troupe.app.tool.select.MarkGesture;
import troupe.geometry.Point;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.Task;

/**
 * Draws an avatar: a click where it stands, then one for each goal of its way. Enter or a double click ends it; an avatar
 * without a way is steered by hand. It joins the encounter that is looked at, or a new one of the actor of the journey
 * that is looked at. A press on a place of an avatar moves that instead.
 */
public final class DrawAvatarTool implements Tool {
    private static final double RADIUS = Avatar.DEFAULT_RADIUS;

    /** Where a new actor walks in a scene that has none, as shares of the width. */
    private static final double FROM = 1.0 / 6;

    private final Editing editing;
    private final List<Point> places = new ArrayList<>();
    private Optional<Snap> next = Optional.empty();
    private Optional<Gesture> gesture = Optional.empty();
    private Optional<Gesture.Outcome> outcome = Optional.empty();

    /** Makes the tool. */
    public DrawAvatarTool(Editing editing) {
        this.editing = editing;
    }

    @Override
    public String key() {
        return "avatar";
    }

    private Snap snap(Pointer pointer) {
        Optional<Point> anchor = places.isEmpty() ? Optional.empty() : Optional.of(places.get(places.size() - 1));
        Snapping snapping = new Snapping(
                editing.document().scene(), List.of(), editing.view().get().scale());
        return pointer.shift() || pointer.alt()
                ? snapping.place(pointer.at(), anchor, pointer.shift(), pointer.alt())
                : snapping.onGrid(pointer.at());
    }

    @Override
    public void press(Pointer pointer) {
        if (pointer.clicks() > 1) {
            finish();
            return;
        }
        Optional<Mark> mark = isDrawing() ? Optional.empty() : mark(pointer);
        if (mark.isPresent()) {
            gesture = Optional.of(new MarkGesture(editing, pointer, mark.get()));
            editing.selection().set(List.of(mark.get().owner()));
            return;
        }
        next = Optional.of(snap(pointer));
        Point at = next.get().at();
        if (places.isEmpty() || !places.get(places.size() - 1).equals(at)) {
            places.add(at);
        }
    }

    private Optional<Mark> mark(Pointer pointer) {
        return editing.document()
                .shownTask()
                .filter(Encounter.class::isInstance)
                .flatMap(task -> Hits.mark(task, editing.view().get(), pointer.px(), pointer.py()));
    }

    @Override
    public void drag(Pointer pointer) {
        if (gesture.isPresent()) {
            outcome = gesture.map(g -> g.at(pointer));
            editing.document().preview(outcome.orElseThrow().scene());
        } else if (isDrawing()) {
            next = Optional.of(snap(pointer));
            places.set(places.size() - 1, next.get().at());
        }
    }

    @Override
    public void release(Pointer pointer) {
        if (gesture.isPresent() && editing.document().isPreviewing()) {
            editing.document()
                    .commit(gesture.get().name(), gesture.get().at(pointer).scene());
        }
        gesture = Optional.empty();
        outcome = Optional.empty();
        move(pointer);
    }

    @Override
    public void move(Pointer pointer) {
        next = Optional.of(snap(pointer));
    }

    @Override
    public boolean isDrawing() {
        return !places.isEmpty();
    }

    @Override
    public void stepBack() {
        if (isDrawing()) {
            places.remove(places.size() - 1);
        }
    }

    @Override
    public void finish() {
        if (!isDrawing()) {
            return;
        }
        Place start = place(places.get(0));
        List<Avatar.Head> heads = places.stream()
                .skip(1)
                .map(p -> new Avatar.Head(place(p), OptionalDouble.empty()))
                .toList();
        cancel();
        commit(heads.isEmpty() ? new Avatar.Pointer(start) : new Avatar.Script(start, Avatar.DEFAULT_PACE, heads));
    }

    private static Place place(Point at) {
        return Place.of(at.x(), at.y());
    }

    private void commit(Avatar.Motion motion) {
        Scene scene = editing.document().scene();
        Task looked = scene.task(editing.document().task()).orElse(null);
        Scene with = scene;
        if (!(looked instanceof Encounter)) {
            Optional<Actor> there = (looked instanceof Journey j ? scene.actor(j.actor()) : Optional.<Actor>empty())
                    .or(() -> scene.actors().stream().findFirst());
            Actor actor = there.orElseGet(() -> NewElements.actor(scene, editing.texts()));
            with = there.isPresent() ? scene : NewElements.with(scene, actor);
            looked = NewElements.encounter(with, actor, start(scene, looked), goal(scene, looked), editing.texts());
            with = NewElements.with(with, looked);
        }
        Encounter encounter = (Encounter) looked;
        Avatar avatar = NewElements.avatar(with, encounter, motion, editing.texts());
        List<Avatar> all = new ArrayList<>(encounter.avatars());
        all.add(avatar);
        editing.document().commit(editing.texts().format("edit.draw", avatar.name()), with.with(encounter.among(all)));
        editing.document().lookAt(encounter.id());
        editing.selection().set(List.of(Parts.id(encounter.id(), avatar.id())));
        editing.drawn().run();
    }

    private static Place start(Scene scene, Task looked) {
        return looked instanceof Journey j
                ? j.start()
                : Place.of(scene.world().width() * FROM, scene.world().depth() / 2);
    }

    private static Place goal(Scene scene, Task looked) {
        return looked instanceof Journey j
                ? j.goal()
                : Place.of(scene.world().width() * (1 - FROM), scene.world().depth() / 2);
    }

    @Override
    public void cancel() {
        places.clear();
        next = Optional.empty();
        gesture = Optional.empty();
        outcome = Optional.empty();
        editing.document().dropPreview();
    }

    @Override
    public String message() {
        return outcome.map(Gesture.Outcome::text)
                .orElseGet(
                        () -> !isDrawing() ? "" : editing.texts().get(places.size() == 1 ? "draw.way" : "draw.ways"));
    }

    @Override
    public Cursor cursor(Pointer pointer) {
        boolean over = !isDrawing() && mark(pointer).isPresent();
        return Cursor.getPredefinedCursor(over ? Cursor.MOVE_CURSOR : Cursor.CROSSHAIR_CURSOR);
    }

    @Override
    public void paint(Graphics2D g, Viewport view) {
        List<Point> line = new ArrayList<>(places);
        if (isDrawing()) {
            next.map(Snap::at).ifPresent(line::add);
            Sketch.line(g, view, editing.look(), line, false);
            Point at = places.get(0);
            double r = Math.max(5, RADIUS * view.scale());
            g.setColor(editing.look().theme().color(Tone.ACCENT, 0.2));
            Ellipse2D disc = new Ellipse2D.Double(view.px(at.x()) - r, view.py(at.y()) - r, 2 * r, 2 * r);
            g.fill(disc);
            g.setColor(editing.look().color(Tone.ACCENT));
            g.setStroke(Theme.line(2));
            g.draw(disc);
            places.stream().skip(1).forEach(p -> Sketch.corner(g, view, editing.look(), p, false));
        }
        Optional<Guide> guide = outcome.map(Gesture.Outcome::guide).orElseGet(() -> next.flatMap(Snap::guide));
        Optional<Point> at = outcome.map(Gesture.Outcome::at).or(() -> next.map(Snap::at));
        at.ifPresent(p -> Sketch.guide(g, view, editing.look(), guide, p));
    }

    @Override
    public Object stamp() {
        return List.of(List.copyOf(places), next, outcome.isPresent() ? outcome.get() : "");
    }
}
