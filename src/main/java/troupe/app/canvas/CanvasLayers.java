package troupe.app.canvas;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import troupe.app.look.Look;
import troupe.app.plan.Views;
import troupe.app.problem.BlockagePainter;
import troupe.app.problem.Findings;
import troupe.app.session.Session;
import troupe.app.tool.Tool;
import troupe.app.tool.select.PartPainter;
import troupe.app.tool.select.SelectionPainter;
import troupe.geometry.Pose;
import troupe.paint.Labels;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.paint.field.OverlayPainter;
import troupe.paint.motion.AgentPixels;
import troupe.paint.motion.RunPainter;
import troupe.paint.picture.Legend;
import troupe.paint.scene.ScenePainter;
import troupe.paint.scene.TaskPainter;
import troupe.scene.Crowd;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Paints what the canvas shows, one layer over the other: ground, obstacles, views, ways, selection and actors.
 * Has the painters of runs and views made in the background. Belongs to the event thread.
 */
final class CanvasLayers implements AutoCloseable {
    private final Look look;
    private final Session session;
    private final Supplier<Tool> tool;
    private final Runnable changed;
    private final Painters painters;
    private final Moments moments;
    private final Ghost ghost;
    private final LayerStack stack;
    private final AgentPixels agents = new AgentPixels();
    private Viewport view = new Viewport(0, 0, 1);
    private Findings findings = Findings.NONE;
    private Painters.Prepared prepared;
    private List<OverlayPainter> ofMoment = List.of();
    private Scene painted;
    private List<?> paintedMoment = List.of();
    private ScenePainter scenePainter;
    private boolean printing;
    private double elevation = Double.POSITIVE_INFINITY;

    /**
     * Makes the layers of a session.
     *
     * @param tool gives the tool in hand, or null
     * @param changed told when there is something new to paint
     */
    CanvasLayers(Look look, Session session, Executor eventThread, Supplier<Tool> tool, Runnable changed) {
        this.look = look.scaled(1);
        this.session = session;
        this.tool = tool;
        this.changed = changed;
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
    }

    /** Has what the present plan found prepared for painting. */
    void request() {
        session.plan().ifPresent(plan -> painters.request(plan, session.overlays()));
        requestMoment();
    }

    /** Has the views of the moment shown prepared. */
    void requestMoment() {
        moments.request(session);
    }

    /** Drops what belongs to the document before. */
    void forget() {
        prepared = null;
        painters.forget();
    }

    private void takeMoment(List<OverlayPainter> made) {
        ofMoment = made;
        changed.run();
    }

    private void take(Painters.Prepared made) {
        prepared = made;
        changed.run();
    }

    /** Shows what stands in the way of the journey, or nothing. */
    void show(Findings found) {
        findings = found;
        changed.run();
    }

    /** Returns the legend of what is shown, once it is prepared. */
    Optional<Legend> legend() {
        return Optional.ofNullable(prepared).map(Painters.Prepared::legend);
    }

    /** Tells whether all that time changes lies on the ground of the scene: so it is with crowds. */
    boolean movesInside() {
        return run().isPresent() && session.document().shownTask().orElse(null) instanceof Crowd;
    }

    /** Paints all layers. */
    void paint(Graphics2D g, int width, int height, Viewport of) {
        view = of;
        stack.paint(g, width, height, look.color(Tone.CANVAS), of, movesInside());
    }

    /** Paints all layers without keeping any of them, of shapes alone. */
    void print(Graphics2D g, int width, int height, Viewport of) {
        view = of;
        printing = true;
        stack.print(g, width, height, look.color(Tone.CANVAS));
        printing = false;
    }

    /** Leaves only a trace of what begins above the floors of the layer looked at. */
    void showLayer(int layer) {
        List<Views.Layer> layers = session.plan().map(p -> p.views().layers()).orElse(List.of());
        boolean known = layer >= 0
                && layer < layers.size()
                && !Double.isNaN(layers.get(layer).highest());
        elevation = known ? layers.get(layer).highest() : Double.POSITIVE_INFINITY;
        painted = null;
        changed.run();
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
                session.document().task(),
                tool.get() == null ? "" : tool.get(),
                tool.get() == null ? "" : tool.get().stamp());
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
        session.document().shownTask().ifPresent(task -> PartPainter.paint(g, view, look, task, session.selection()));
        SelectionPainter.paint(g, view, look, session.document().shown(), session.selection());
        if (tool.get() != null) {
            tool.get().paint(g, view);
        }
    }

    private void paintActors(Graphics2D g) {
        ghost.paintMovers(g, view);
        double time = session.playback().time();
        if (printing) {
            run().ifPresent(run -> run.paintActors(g, view, time));
        } else {
            run().ifPresent(run -> run.paintActors(g, view, time, agents));
        }
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

    @Override
    public void close() {
        painters.close();
        moments.close();
    }
}
