package troupe.app.tour;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Insets;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLayeredPane;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import troupe.app.canvas.Canvas;
import troupe.app.command.Commands;
import troupe.app.document.SceneDocument;
import troupe.app.look.Look;
import troupe.app.look.Named;
import troupe.app.look.widget.FlatButton;
import troupe.app.session.Session;
import troupe.app.settings.StudioSettings;
import troupe.app.tool.Hits;
import troupe.geometry.Box;
import troupe.paint.Viewport;

/** Leads a person through the window, step by step. */
public final class TourGuide {
    private static final int LOOK_MS = 120;
    private static final int MARGIN = 14;

    /** Room for the scale below the card. */
    private static final int BELOW = 44;

    /** Room for the chips above it. */
    private static final int ABOVE = 50;

    private final JFrame frame;
    private final Session session;
    private final StudioSettings settings;
    private final List<TourStep> steps = TourStep.all();
    private final Set<Integer> finished = new HashSet<>();
    private final Timer timer = new Timer(LOOK_MS, e -> watch());
    private Optional<Shown> shown = Optional.empty();
    private Supplier<Look> look;
    private Supplier<Canvas> canvas;
    private Supplier<Commands> commands;
    private Runnable take = () -> {};
    private int at;
    private boolean offering;
    private TourStep.Begun begun;

    /** What is made for one look. */
    private record Shown(TourCard card, TourMark mark) {}

    /** Makes a guide that shows nothing yet. */
    public TourGuide(JFrame frame, Session session, StudioSettings settings) {
        this.frame = frame;
        this.session = session;
        this.settings = settings;
        session.document().listeners().add(change -> {
            if (change == SceneDocument.Change.OPENED && isOn() && at == 0) {
                begun = TourStep.Begun.of(session);
                EventQueue.invokeLater(this::focus); // after the canvas of the scene was given the keys
            }
        });
    }

    /** Says where the guide finds what the window shows now. */
    public void among(Supplier<Look> looks, Supplier<Canvas> canvases, Supplier<Commands> all) {
        look = looks;
        canvas = canvases;
        commands = all;
    }

    /** Tells whether the tour is on its way. */
    public boolean isOn() {
        return shown.isPresent() && !offering;
    }

    /** Returns the word for the step that is shown, empty while there is none. */
    public String step() {
        return isOn() ? steps.get(at).key() : "";
    }

    /** Offers the tour, unless it was taken or declined before; {@code accepted} opens it. */
    public void offer(Runnable accepted) {
        if (settings.isTourTaken()) {
            return;
        }
        take = accepted;
        offering = true;
        open();
    }

    /** Begins the tour at its first step. */
    public void start() {
        offering = false;
        finished.clear();
        at = 0;
        begun = TourStep.Begun.of(session);
        open();
        focus();
    }

    /** Shows the card anew where the looks have changed. */
    public void relook() {
        if (shown.isPresent()) {
            open();
        }
    }

    /** Ends the tour, or declines it; it is not offered again. */
    public void close() {
        if (shown.isPresent()) {
            settings.setTourTaken();
            remove();
            canvas.get().requestFocusInWindow();
        }
    }

    /** Leaves the window without remembering anything. */
    public void dispose() {
        timer.stop();
    }

    private void remove() {
        timer.stop();
        JLayeredPane layers = frame.getLayeredPane();
        shown.ifPresent(s -> {
            layers.remove(s.card());
            layers.remove(s.mark());
        });
        shown = Optional.empty();
        layers.repaint();
    }

    private void open() {
        remove();
        Look now = look.get();
        Shown made = new Shown(new TourCard(now, this::close), new TourMark(now));
        shown = Optional.of(made);
        JLayeredPane layers = frame.getLayeredPane();
        layers.add(made.mark(), JLayeredPane.PALETTE_LAYER);
        layers.add(made.card(), JLayeredPane.MODAL_LAYER);
        fill();
        timer.start();
    }

    /** Writes the words of the step, or of the offer, on the card. */
    private void fill() {
        TourCard card = shown.orElseThrow().card();
        Look now = look.get();
        card.clearButtons();
        if (offering) {
            card.show(now.text("tour.name"), now.text("tour.offer.title"), now.text("tour.offer.text"), "");
            card.button("later", false, this::close);
            card.button("take", true, take);
        } else {
            TourStep step = steps.get(at);
            String key = step.command().isEmpty()
                    ? ""
                    : commands.get().get(step.command()).shortcut();
            String outcome = finished.contains(at) ? now.texts().get("tour." + step.key() + ".done", "") : "";
            card.show(
                    now.texts().format("tour.step", at + 1, steps.size()),
                    now.text("tour." + step.key() + ".title"),
                    now.texts().format("tour." + step.key() + ".text", key),
                    outcome);
            addButtons(card);
        }
        Dimension size = card.getPreferredSize();
        card.setSize(size);
        place(target());
        card.validate();
        card.repaint();
    }

    private void addButtons(TourCard card) {
        boolean last = at + 1 == steps.size();
        if (at > 0) {
            card.button("back", false, () -> go(at - 1));
        }
        boolean done = last || finished.contains(at) || steps.get(at).isShown();
        card.button(last ? "end" : done ? "next" : "skip", done, last ? this::close : () -> go(at + 1));
    }

    private void go(int to) {
        boolean keys = shown.filter(s -> s.card().isAncestorOf(focused())).isPresent();
        at = to;
        begun = TourStep.Begun.of(session);
        fill();
        reveal();
        if (keys) {
            focus();
        }
    }

    private Component focused() {
        Component owner = frame.getMostRecentFocusOwner();
        return owner == null ? frame : owner;
    }

    /** Gives the keys to what leads on. */
    private void focus() {
        shown.map(Shown::card).map(TourCard::leading).ifPresent(FlatButton::requestFocusInWindow);
    }

    private void watch() {
        if (shown.isEmpty()) {
            return;
        }
        if (!offering && !finished.contains(at) && !steps.get(at).isShown()) {
            boolean done = steps.get(at).check().isDone(begun, session, name -> part(name)
                    .isPresent());
            if (done) {
                finished.add(at);
                fill();
            }
        }
        place(target());
    }

    private Optional<Component> part(String name) {
        return Named.find(frame.getRootPane(), name).filter(Component::isShowing);
    }

    /** Scrolls to what the step speaks of. */
    private void reveal() {
        steps.get(at).parts().stream()
                .flatMap(name -> part(name).stream())
                .filter(JComponent.class::isInstance)
                .findFirst()
                .ifPresent(part -> ((JComponent) part).scrollRectToVisible(new Rectangle(part.getSize())));
    }

    /** Returns what the step speaks of, in the pixels of the window; empty where that is not to be seen. */
    private Rectangle target() {
        if (offering) {
            return new Rectangle();
        }
        TourStep step = steps.get(at);
        if (!step.element().isEmpty()) {
            return element(step.element());
        }
        JLayeredPane layers = frame.getLayeredPane();
        for (String name : step.parts()) {
            Optional<Component> part = part(name);
            if (part.isPresent() && part.get() instanceof JComponent seen) {
                Rectangle visible = seen.getVisibleRect();
                if (visible.width > 0 && visible.height > 0) {
                    return SwingUtilities.convertRectangle(seen, visible, layers);
                }
            }
        }
        return new Rectangle();
    }

    private Rectangle element(String id) {
        Canvas on = canvas.get();
        Optional<Box> box =
                session.document().shown().element(id).flatMap(Hits::outline).map(outline -> outline.bounds());
        if (box.isEmpty() || !on.isShowing()) {
            return new Rectangle();
        }
        Viewport view = on.view();
        double by = look.get().scale();
        Rectangle pixels = new Rectangle(
                (int) (view.px(box.get().minX()) * by),
                (int) (view.py(box.get().maxY()) * by),
                (int) Math.ceil(box.get().width() * view.scale() * by),
                (int) Math.ceil(box.get().depth() * view.scale() * by));
        return SwingUtilities.convertRectangle(on, pixels.intersection(on.getVisibleRect()), frame.getLayeredPane());
    }

    /** Rings the target, and puts the card into the first corner of the canvas where it does not hide it. */
    private void place(Rectangle target) {
        Shown now = shown.orElseThrow();
        now.mark().ring(target);
        TourCard card = now.card();
        if (card.isDragged()) {
            return;
        }
        Look looks = look.get();
        Canvas on = canvas.get();
        Component around = on.isShowing() ? on : frame.getContentPane();
        Rectangle room =
                SwingUtilities.convertRectangle(around, new Rectangle(around.getSize()), frame.getLayeredPane());
        Insets margin = new Insets(looks.px(ABOVE), looks.px(MARGIN), looks.px(BELOW), looks.px(MARGIN));
        int left = room.x + margin.left;
        int right = room.x + room.width - margin.right - card.getWidth();
        int top = room.y + margin.top;
        int bottom = room.y + room.height - margin.bottom - card.getHeight();
        for (Point corner : List.of(
                new Point(right, bottom), new Point(left, bottom), new Point(left, top), new Point(right, top))) {
            Rectangle taken = new Rectangle(corner, card.getSize());
            taken.grow(looks.px(MARGIN), looks.px(MARGIN));
            if (!taken.intersects(target)) {
                card.setLocation(corner);
                return;
            }
        }
        card.setLocation(right, bottom);
    }
}
