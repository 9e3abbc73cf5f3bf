package troupe.app.canvas;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import troupe.app.document.Listeners;
import troupe.app.document.SceneDocument;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.app.plan.Views;
import troupe.app.problem.BlockagePainter;
import troupe.app.problem.Findings;
import troupe.app.session.OverlayChoice;
import troupe.app.session.Session;
import troupe.app.tool.SelectionPainter;
import troupe.app.tool.SteerTool;
import troupe.app.tool.Tool;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.geometry.Pose;
import troupe.paint.Labels;
import troupe.paint.Legend;
import troupe.paint.OverlayPainter;
import troupe.paint.RunPainter;
import troupe.paint.ScaleBar;
import troupe.paint.ScenePainter;
import troupe.paint.TaskPainter;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Shows the scene from above, what the planner found, and what the tool does. Zooms at the pointer with
 * the wheel; pans with the middle button. Belongs to the event thread.
 */
public final class Canvas extends Drawn implements AutoCloseable {
    private static final int MARGIN = 24;
    private static final int TOP = 46;
    /** Room for a legend of two rows. */
    private static final int BOTTOM = 72;

    private static final int CARD_MARGIN = 12;

    private final transient Look look;
    private final transient Session session;
    private final transient Painters painters;
    private final transient Moments moments;
    private final transient LayerStack stack;
    private final transient Listeners<Viewport> views = new Listeners<>();
    private final transient Listeners<Optional<Point>> pointers = new Listeners<>();
    private final transient Listeners<Tool> gestures = new Listeners<>();
    private final transient List<Runnable> leave = new ArrayList<>();
    private transient Findings findings = Findings.NONE;
    private transient Viewport view = new Viewport(0, 0, 1);
    private boolean fitted = true;
    private final transient Ghost ghost;
    private transient Dimension corner = new Dimension();
    private boolean snapping = true;
    private boolean marked;
    private final double scale;
    private transient Tool tool;
    private transient Painters.Prepared prepared;
    private transient List<OverlayPainter> ofMoment = List.of();
    private transient Scene painted;
    private transient List<?> paintedMoment = List.of();
    private transient ScenePainter scenePainter;
    private double elevation = Double.POSITIVE_INFINITY;

    /** Makes the canvas of a session. */
    public Canvas(Look look, Session session, Executor eventThread) {
        this.look = look.scaled(1);
        this.scale = look.scale();
        this.session = session;
        this.painters = new Painters(this.look, eventThread, this::take);
        this.moments = new Moments(this.look, eventThread, this::takeMoment);
        this.ghost = new Ghost(look, session);
        this.stack = new LayerStack(List.of(
                layer(this::groundStamp, g -> scenePainter().paintGround(g, view)),
                layer(this::sceneStamp, g -> scenePainter().paintObstacles(g, view)),
                layer(() -> prepared == null ? "" : prepared.overlays(), this::paintOverlays),
                layer(ghost::stamp, g -> ghost.paintWays(g, view)),
                layer(this::pathStamp, this::paintPath),
                layer(this::selectionStamp, this::paintSelection),
                layer(() -> ofMoment, this::paintMoment),
                layer(this::actorStamp, this::paintActors)));
        setName("canvas");
        setFocusable(true);
        setOpaque(true);
        getAccessibleContext().setAccessibleName(look.text("canvas.name"));
        getAccessibleContext().setAccessibleDescription(look.text("canvas.description"));
        observe();
        new CanvasMouse(this, new SteerTool(session, this::view));
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                marked = Set.of(FocusEvent.Cause.TRAVERSAL_FORWARD, FocusEvent.Cause.TRAVERSAL_BACKWARD)
                        .contains(event.getCause());
                repaint();
            }

            @Override
            public void focusLost(FocusEvent event) {
                marked = false;
                repaint();
            }
        });
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                if (fitted) {
                    fit();
                }
            }
        });
    }

    private void observe() {
        leave.add(session.document().listeners().add(change -> {
            if (change == SceneDocument.Change.OPENED) {
                prepared = null;
                painters.forget();
                fit();
            }
            repaint();
        }));
        leave.add(session.selection().listeners().add(s -> repaint()));
        leave.add(session.playback().listeners().add(p -> {
            moments.request(session);
            repaint();
        }));
        leave.add(session.plans().add(plan -> prepare()));
        leave.add(session.comparison().listeners().add(c -> repaint()));
        leave.add(session.overlays().listeners().add(choice -> {
            showLayer(choice.layer());
            prepare();
        }));
        prepare();
    }

    private void prepare() {
        session.plan().ifPresent(plan -> painters.request(plan, session.overlays()));
        moments.request(session);
    }

    private void takeMoment(List<OverlayPainter> made) {
        ofMoment = made;
        repaint();
    }

    private void take(Painters.Prepared made) {
        prepared = made;
        repaint();
    }

    /** Returns the observers of the viewport. */
    public Listeners<Viewport> views() {
        return views;
    }

    /** Returns the observers of the place under the pointer, in metres; empty when it has left. */
    public Listeners<Optional<Point>> pointers() {
        return pointers;
    }

    /** Returns the observers of the tool in hand, told whenever what it has under way may have changed. */
    public Listeners<Tool> gestures() {
        return gestures;
    }

    /** Returns the width in the pixels of the viewport, which are those at 100 %. */
    public double wide() {
        return getWidth() / scale;
    }

    /** Returns the height in the pixels of the viewport, which are those at 100 %. */
    public double high() {
        return getHeight() / scale;
    }

    /** Returns where an event was in the pixels of the viewport. */
    Point2D place(MouseEvent event) {
        return new Point2D.Double(event.getX() / scale, event.getY() / scale);
    }

    /** Shows what stands in the way of the journey, or nothing. */
    public void show(Findings found) {
        findings = found;
        repaint();
    }

    /** Returns the viewport. */
    public Viewport view() {
        return view;
    }

    /** Shows another part of the scene. */
    public void show(Viewport other) {
        fitted = false;
        setView(other);
    }

    private void setView(Viewport other) {
        view = other;
        views.tell(view);
        repaint();
    }

    /** Shows the whole scene, and goes on doing so when the window changes its size. */
    public void fit() {
        fitted = true;
        if (wide() > 0 && high() > 0) {
            setView(fitting());
        }
    }

    private Viewport fitting() {
        Scene scene = session.document().shown();
        Box world = new Box(0, 0, scene.world().width(), scene.world().depth());
        return Fitting.of(world, MARGIN, TOP, wide() - 2.0 * MARGIN, high() - TOP - BOTTOM, corner);
    }

    /** Leaves so many pixels of the upper right corner free of the scene while the whole of it is shown. */
    public void leaveCorner(Dimension pixels) {
        Dimension size = new Dimension((int) Math.ceil(pixels.width / scale), (int) Math.ceil(pixels.height / scale));
        if (!corner.equals(size)) {
            corner = size;
            if (fitted) {
                fit();
            }
        }
    }

    /** Tells whether the whole scene is shown, whatever the size of the window. */
    public boolean isFitted() {
        return fitted;
    }

    /** Returns the present scale as a share of that at which the whole scene just fits. */
    public double zoomShare() {
        return wide() == 0 || high() == 0 ? 1 : view.scale() / fitting().scale();
    }

    /** Zooms at the middle of the canvas. */
    public void zoom(double factor) {
        show(view.zoomed(factor, wide() / 2, high() / 2));
    }

    /** Switches snapping: where it is off, the Alt key snaps instead of keeping from it. */
    public void setSnapping(boolean on) {
        snapping = on;
    }

    /** Tells whether the tools snap without the Alt key. */
    public boolean isSnapping() {
        return snapping;
    }

    /** Returns the tool in hand. */
    public Tool tool() {
        return tool;
    }

    /** Takes another tool in hand; what the one before was doing is dropped. */
    public void take(Tool other) {
        if (tool != null) {
            tool.cancel();
        }
        tool = other;
        setCursor(Cursor.getDefaultCursor());
        gestures.tell(tool);
        repaint();
    }

    /** Leaves only a trace of what begins above the floors of the layer looked at. */
    private void showLayer(int layer) {
        List<Views.Layer> layers = session.plan().map(p -> p.views().layers()).orElse(List.of());
        boolean known = layer >= 0
                && layer < layers.size()
                && !Double.isNaN(layers.get(layer).highest());
        elevation = known ? layers.get(layer).highest() : Double.POSITIVE_INFINITY;
        painted = null;
        repaint();
    }

    private ScenePainter scenePainter() {
        Scene scene = session.document().shown();
        List<?> moment = moment();
        if (scene != painted || !moment.equals(paintedMoment)) {
            painted = scene;
            paintedMoment = moment;
            double time = session.playback().time();
            scenePainter = run().map(run -> run.scene(scene, time))
                    .orElseGet(() -> new ScenePainter(scene, look.theme()))
                    .upTo(elevation);
        }
        return scenePainter;
    }

    private Optional<RunPainter> run() {
        return prepared == null ? Optional.empty() : prepared.run();
    }

    /** Returns what the look of the scene depends on in the run: the run, and the poses of what it moves. */
    private List<?> moment() {
        return run().map(run -> {
                    List<Pose> poses = run.poses(session.playback().time());
                    return poses.isEmpty() ? List.of() : List.of(run, poses);
                })
                .orElse(List.of());
    }

    private Object groundStamp() {
        Scene scene = session.document().shown();
        return List.of(scene.world(), scene.ditches());
    }

    private Object sceneStamp() {
        return List.of(
                session.document().shown().obstacles(), session.selection().ids(), elevation, moment());
    }

    private Object pathStamp() {
        return List.of(
                prepared == null ? "" : prepared.run().map(RunPainter::stamp).orElse(""),
                session.document().shownTask().isPresent()
                        ? session.document().shownTask().get()
                        : "",
                session.selection().ids());
    }

    private Object selectionStamp() {
        return List.of(
                findings.blockage(),
                session.selection().ids(),
                session.document().shown(),
                tool == null ? "" : tool,
                tool == null ? "" : tool.stamp());
    }

    private Object actorStamp() {
        return List.of(session.playback().time(), prepared == null ? "" : prepared, ghost.stamp());
    }

    private void paintOverlays(Graphics2D g) {
        if (prepared == null || prepared.overlays().isEmpty()) {
            return;
        }
        paintInside(g, prepared.overlays());
        if (prepared.field()) {
            scenePainter().paintOutlines(g, view);
        }
    }

    private void paintInside(Graphics2D g, List<OverlayPainter> overlays) {
        World world = session.document().shown().world();
        Graphics2D inside = (Graphics2D) g.create();
        inside.clip(new Rectangle2D.Double(
                view.px(0), view.py(world.depth()), world.width() * view.scale(), world.depth() * view.scale()));
        overlays.forEach(painter -> painter.paint(inside, view));
        inside.dispose();
    }

    private void paintMoment(Graphics2D g) {
        if (!ofMoment.isEmpty()) {
            paintInside(g, ofMoment);
        }
    }

    private void paintPath(Graphics2D g) {
        Optional<RunPainter> run = run();
        Labels labels = new Labels();
        run.ifPresent(painter -> {
            painter.paintLegs(g, view);
            painter.takeRoom(labels, view, Double.NaN);
        });
        if (session.document().shownTask().orElse(null) instanceof Journey journey) {
            TaskPainter.paint(g, session.document().shown(), journey, view, look.theme());
            TaskPainter.take(labels, journey, view);
        } else {
            run.ifPresent(painter -> painter.paintEnds(g, view));
        }
        scenePainter().numbering(Set.copyOf(session.selection().ids())).paintLabels(g, view, labels);
        run.ifPresent(painter -> painter.paintPills(g, view, labels, a -> look.text("word." + a.key())));
    }

    private void paintSelection(Graphics2D g) {
        findings.blockage()
                .ifPresent(b ->
                        BlockagePainter.paint(g, view, look, session.document().shown(), b));
        SelectionPainter.paint(g, view, look, session.document().shown(), session.selection());
        if (tool != null) {
            tool.paint(g, view);
        }
    }

    private void paintActors(Graphics2D g) {
        ghost.paintMovers(g, view);
        run().ifPresent(run -> run.paintActors(g, view, session.playback().time()));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        g.setRenderingHint(RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
        g.scale(scale, scale);
        stack.paint(g, (int) Math.ceil(wide()), (int) Math.ceil(high()), look.color(Tone.CANVAS), view);
        paintCards(g);
        if (marked) {
            g.setColor(look.color(Tone.ACCENT));
            g.draw(new Rectangle2D.Double(0.5, 0.5, wide() - 1, high() - 1));
        }
        g.dispose();
    }

    /** Paints what explains the picture: legend and scale. */
    private void paintCards(Graphics2D g) {
        int bottom = (int) high() - CARD_MARGIN;
        double scaleBar = ScaleBar.width(view);
        if (prepared != null && session.overlays().shows(OverlayChoice.LEGEND)) {
            Legend legend = prepared.legend();
            int most = (int) (wide() - scaleBar - 5 * CARD_MARGIN);
            Dimension size = legend.size(g, most);
            legend.paint(g, CARD_MARGIN, bottom - size.height, most);
        }
        ScaleBar.paint(g, view, look.theme(), wide() - 2.0 * CARD_MARGIN, bottom - 6.0);
    }

    private static LayerStack.Layer layer(Supplier<Object> stamp, Consumer<Graphics2D> painting) {
        return new LayerStack.Layer() {
            @Override
            public Object stamp() {
                return stamp.get();
            }

            @Override
            public void paint(Graphics2D g) {
                painting.accept(g);
            }
        };
    }

    /** Leaves what it observes and ends its background thread. */
    @Override
    public void close() {
        leave.forEach(Runnable::run);
        painters.close();
        moments.close();
    }
}
