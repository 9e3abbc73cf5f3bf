package troupe.app.canvas;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
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
import troupe.app.document.Listeners;
import troupe.app.document.SceneDocument;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.app.problem.Findings;
import troupe.app.session.OverlayChoice;
import troupe.app.session.Session;
import troupe.app.tool.SteerTool;
import troupe.app.tool.Tool;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.paint.ScaleBar;
import troupe.paint.Tone;
import troupe.paint.Viewport;
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
    /** How far agents reach over the edge of the ground: pixels at least, and metres. */
    private static final double LEAST_REACH = 12;

    private static final double REACH_M = 1;

    private final transient Look look;
    private final transient Session session;
    private final transient CanvasLayers layers;
    private final transient Listeners<Viewport> views = new Listeners<>();
    private final transient Listeners<Optional<Point>> pointers = new Listeners<>();
    private final transient Listeners<Tool> gestures = new Listeners<>();
    private final transient List<Runnable> leave = new ArrayList<>();
    private transient Viewport view = new Viewport(0, 0, 1);
    private boolean fitted = true;
    private transient Dimension corner = new Dimension();
    private boolean snapping = true;
    private boolean marked;
    private final double scale;
    private transient Tool tool;

    /** Makes the canvas of a session. */
    public Canvas(Look look, Session session, Executor eventThread) {
        this.look = look.scaled(1);
        this.scale = look.scale();
        this.session = session;
        this.layers = new CanvasLayers(look, session, eventThread, this::tool, this::repaint);
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
                layers.forget();
                fit();
            }
            repaint();
        }));
        leave.add(session.selection().listeners().add(s -> repaint()));
        leave.add(session.playback().listeners().add(p -> {
            layers.requestMoment();
            repaintMoving();
        }));
        leave.add(session.plans().add(plan -> layers.request()));
        leave.add(session.comparison().listeners().add(c -> repaint()));
        leave.add(session.overlays().listeners().add(choice -> {
            layers.showLayer(choice.layer());
            layers.request();
        }));
        layers.request();
    }

    /** Paints anew what the time shown changes: of a crowd only the ground, so that what lies over it need not be. */
    private void repaintMoving() {
        if (!layers.movesInside()) {
            repaint();
            return;
        }
        World world = session.document().shown().world();
        double reach = Math.max(LEAST_REACH, REACH_M * view.scale());
        Rectangle2D ground = new Rectangle2D.Double(
                (view.px(0) - reach) * scale,
                (view.py(world.depth()) - reach) * scale,
                (world.width() * view.scale() + 2 * reach) * scale,
                (world.depth() * view.scale() + 2 * reach) * scale);
        Rectangle part = ground.createIntersection(new Rectangle(getWidth(), getHeight()))
                .getBounds();
        repaint(part.x, part.y, part.width, part.height);
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
        layers.show(found);
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

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        g.setRenderingHint(RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
        g.scale(scale, scale);
        if (isPaintingForPrint()) {
            layers.print(g, (int) Math.ceil(wide()), (int) Math.ceil(high()), view);
        } else {
            layers.paint(g, (int) Math.ceil(wide()), (int) Math.ceil(high()), view);
        }
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
        if (session.overlays().shows(OverlayChoice.LEGEND)) {
            layers.legend().ifPresent(legend -> {
                int most = (int) (wide() - scaleBar - 5 * CARD_MARGIN);
                Dimension size = legend.size(g, most);
                legend.paint(g, CARD_MARGIN, bottom - size.height, most);
            });
        }
        ScaleBar.paint(g, view, look.theme(), wide() - 2.0 * CARD_MARGIN, bottom - 6.0);
    }

    /** Leaves what it observes and ends its background thread. */
    @Override
    public void close() {
        leave.forEach(Runnable::run);
        layers.close();
    }
}
