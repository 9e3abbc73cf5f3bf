package troupe.app.tool.draw;

import java.awt.Cursor;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.util.List;
import java.util.Optional;
import troupe.app.document.NewElements;
import troupe.app.tool.Editing;
import troupe.app.tool.Pointer;
import troupe.app.tool.Sketch;
import troupe.app.tool.Snap;
import troupe.app.tool.Snapping;
import troupe.app.tool.Tool;
import troupe.geometry.Point;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;

/**
 * Draws the start and the goal of a new journey: a click each, or one drag from the one to the other. The
 * journey is that of the actor whose journey is looked at, or of a new one.
 */
public final class DrawJourneyTool implements Tool {
    private static final double SLACK = 5;

    private final Editing editing;
    private final boolean newActor;
    private Pointer pressed;
    private Optional<Point> start = Optional.empty();
    private Optional<Snap> next = Optional.empty();
    private boolean second;

    /** Makes the tool; {@code newActor} says whether each journey gets an actor of its own. */
    public DrawJourneyTool(Editing editing, boolean newActor) {
        this.editing = editing;
        this.newActor = newActor;
    }

    @Override
    public String key() {
        return newActor ? "actor" : "journey";
    }

    private Snap snap(Pointer pointer) {
        Snapping snapping = new Snapping(
                editing.document().scene(), List.of(), editing.view().get().scale());
        return pointer.shift() || pointer.alt()
                ? snapping.place(pointer.at(), start, pointer.shift(), pointer.alt())
                : snapping.onGrid(pointer.at());
    }

    @Override
    public void press(Pointer pointer) {
        pressed = pointer;
        next = Optional.of(snap(pointer));
        second = start.isPresent();
        if (!second) {
            start = next.map(Snap::at);
        }
    }

    @Override
    public void drag(Pointer pointer) {
        next = Optional.of(snap(pointer));
    }

    @Override
    public void move(Pointer pointer) {
        next = Optional.of(snap(pointer));
    }

    @Override
    public void release(Pointer pointer) {
        if (start.isEmpty()) {
            return;
        }
        next = Optional.of(snap(pointer));
        if (second || pointer.pixelsTo(pressed) > SLACK) {
            Point from = start.get();
            Point to = next.get().at();
            if (!from.equals(to)) {
                cancel();
                commit(Place.of(from.x(), from.y()), Place.of(to.x(), to.y()));
            }
        }
    }

    private void commit(Place from, Place to) {
        Scene scene = editing.document().scene();
        Optional<Actor> present = scene.task(editing.document().task())
                .flatMap(task -> task instanceof Journey j ? scene.actor(j.actor()) : Optional.empty())
                .or(() -> scene.actors().stream().findFirst());
        boolean fresh = newActor || present.isEmpty();
        Actor actor = fresh ? NewElements.actor(scene, editing.texts()) : present.get();
        Scene with = fresh ? NewElements.with(scene, actor) : scene;
        Journey journey = NewElements.journey(with, actor, from, to, editing.texts());
        editing.document()
                .commit(
                        editing.texts().format("edit.draw", newActor ? actor.name() : journey.name()),
                        NewElements.with(with, journey));
        editing.document().lookAt(journey.id());
        editing.selection().set(List.of(newActor ? actor.id() : journey.id()));
        editing.drawn().run();
    }

    @Override
    public boolean isDrawing() {
        return start.isPresent();
    }

    @Override
    public void stepBack() {
        start = Optional.empty();
    }

    @Override
    public void cancel() {
        start = Optional.empty();
        next = Optional.empty();
    }

    @Override
    public String message() {
        return editing.texts().get(start.isEmpty() ? "draw.start" : "draw.goal");
    }

    @Override
    public Cursor cursor(Pointer pointer) {
        return Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR);
    }

    @Override
    public void paint(Graphics2D g, Viewport view) {
        start.ifPresent(from -> {
            g.setColor(editing.look().color(Tone.WALK));
            g.setStroke(Theme.line(2, 4, 5));
            next.ifPresent(to -> g.draw(Sketch.line(view, from, to.at())));
            g.setStroke(Theme.line(3));
            Ellipse2D ring = new Ellipse2D.Double(view.px(from.x()) - 7, view.py(from.y()) - 7, 14, 14);
            g.setColor(editing.look().color(Tone.PANEL));
            g.fill(ring);
            g.setColor(editing.look().color(Tone.WALK));
            g.draw(ring);
        });
        next.ifPresent(snap -> Sketch.guide(g, view, editing.look(), snap.guide(), snap.at()));
    }

    @Override
    public Object stamp() {
        return List.of(start, next);
    }
}
