package troupe.paint.picture;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import troupe.geometry.Box;
import troupe.paint.Labels;
import troupe.paint.ScaleBar;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.paint.field.OverlayPainter;
import troupe.paint.motion.RunPainter;
import troupe.paint.scene.ScenePainter;
import troupe.paint.scene.TaskPainter;
import troupe.paint.solid.Camera;
import troupe.paint.solid.SolidPainter;
import troupe.run.Run;
import troupe.run.view.Overlay;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Scene;

/**
 * Composes a whole picture: a scene, overlays, and a run at a time, with legend and scale bar in the
 * margin, never over the scene. Immutable; serves any thread; the same on each run of one JDK.
 *
 * @param time seconds into the run
 * @param elevation only a trace is left of what begins higher above the ground, in metres
 * @param filled whether fields of numbers are filled, or shown by contour lines alone
 * @param angle from where it is seen in three dimensions, without overlays; empty for the plan view
 * @param words turns the keys of a legend into what is to be read
 */
public record Picture(
        Scene scene,
        List<Overlay> overlays,
        Optional<Run> run,
        double time,
        Theme theme,
        double elevation,
        boolean filled,
        Optional<Camera.Angle> angle,
        UnaryOperator<String> words) {
    /** The least width in pixels. */
    public static final int MIN_WIDTH = 64;

    /** The largest width in pixels. */
    public static final int MAX_WIDTH = 8_192;

    /** The most pixels that an image may have. */
    public static final int MAX_PIXELS = 1 << 26;

    private static final int MARGIN = 14;
    private static final int GAP = 10;

    /** Copies the overlays. */
    public Picture {
        overlays = List.copyOf(overlays);
    }

    /** Makes the picture of a scene in the light theme. */
    public static Picture of(Scene scene) {
        return new Picture(
                scene,
                List.of(),
                Optional.empty(),
                0,
                Theme.LIGHT,
                Double.POSITIVE_INFINITY,
                true,
                Optional.empty(),
                Legend.ENGLISH);
    }

    /** Makes the picture of a run at a time in seconds, in the light theme. */
    public static Picture of(Run run, double time) {
        return of(run.scene()).with(run, time);
    }

    /** Returns this picture with overlays in place of those it had. */
    public Picture with(List<Overlay> others) {
        return new Picture(scene, others, run, time, theme, elevation, filled, angle, words);
    }

    /** Returns this picture with a run as it stands at a time in seconds. */
    public Picture with(Run other, double seconds) {
        return new Picture(scene, overlays, Optional.of(other), seconds, theme, elevation, filled, angle, words);
    }

    /** Returns this picture in another theme. */
    public Picture with(Theme other) {
        return new Picture(scene, overlays, run, time, other, elevation, filled, angle, words);
    }

    /** Returns this picture with only a trace of what begins above {@code metres}. */
    public Picture upTo(double metres) {
        return new Picture(scene, overlays, run, time, theme, metres, filled, angle, words);
    }

    /** Returns this picture with fields of numbers shown by contour lines alone. */
    public Picture outlined() {
        return new Picture(scene, overlays, run, time, theme, elevation, false, angle, words);
    }

    /** Returns this picture in three dimensions, seen from an angle. */
    public Picture solid(Camera.Angle from) {
        return new Picture(scene, overlays, run, time, theme, elevation, filled, Optional.of(from), words);
    }

    /** Returns the width and height in pixels that a picture of the given width takes. */
    public Dimension size(int width) {
        if (width < MIN_WIDTH || width > MAX_WIDTH) {
            throw new IllegalArgumentException(
                    "picture of " + width + " pixels; needs " + MIN_WIDTH + " to " + MAX_WIDTH);
        }
        double inner = width - 2.0 * MARGIN;
        double tall = angle.isPresent()
                ? inner * SolidPainter.aspect(scene, angle.get())
                : inner * scene.world().depth() / scene.world().width();
        int height = (int) Math.ceil(Double.isNaN(tall) ? inner : Math.max(MIN_WIDTH, Math.min(tall, 2 * inner)));
        return new Dimension(width, 2 * MARGIN + GAP + height + footer(width));
    }

    private int footer(int width) {
        BufferedImage scratch = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = Shapes.smooth(scratch.createGraphics());
        int height = Math.max(ScaleBar.HEIGHT, legend().size(g, legendWidth(width)).height);
        g.dispose();
        return height;
    }

    private static int legendWidth(int width) {
        return Math.max(MIN_WIDTH, width - 2 * MARGIN - 170);
    }

    private Legend legend() {
        return Legend.of(run.orElse(null), angle.isPresent() ? List.of() : overlays, filled, theme, words);
    }

    /** Returns the picture as an opaque image of the given width in pixels, {@value #MIN_WIDTH} to {@value #MAX_WIDTH}. */
    public BufferedImage image(int width) {
        return image(width, 1);
    }

    /** Returns the picture laid out for {@code width} pixels and drawn {@code density} times as large, from 1 to 4. */
    public BufferedImage image(int width, double density) {
        BufferedImage image = blank(width, density);
        Graphics2D g = image.createGraphics();
        g.scale(density, density);
        paint(g, width);
        g.dispose();
        return image;
    }

    /** Returns an image of the size that the picture takes. */
    BufferedImage blank(int width, double density) {
        if (!(density >= 1 && density <= 4)) {
            throw new IllegalArgumentException("density " + density + "; needs 1 to 4");
        }
        Dimension size = size(width);
        if (size.width * density * size.height * density > MAX_PIXELS) {
            throw new IllegalArgumentException("picture of " + size.width + " x " + size.height + " pixels, " + density
                    + " times as large; needs at most " + MAX_PIXELS + " pixels");
        }
        return new BufferedImage(
                (int) Math.round(size.width * density),
                (int) Math.round(size.height * density),
                BufferedImage.TYPE_INT_RGB);
    }

    /** Paints the picture laid out for {@code width} pixels; its height is that of {@link #size}. */
    public void paint(Graphics2D graphics, int width) {
        if (angle.isPresent()) {
            paintSolid(graphics, width, solidPainter(), time);
            return;
        }
        Optional<RunPainter> painter = runPainter();
        paint(graphics, width, painter, time, true);
        paintMoving(graphics, width, painter, time);
    }

    /** Returns the painter of a picture in three dimensions. */
    SolidPainter solidPainter() {
        return new SolidPainter(scene, run, theme).upTo(elevation);
    }

    /** Paints the picture in three dimensions as it stands at {@code seconds}. */
    void paintSolid(Graphics2D graphics, int width, SolidPainter painter, double seconds) {
        Dimension size = size(width);
        int footer = footer(width);
        int high = size.height - MARGIN - GAP - footer;
        double density = Math.max(1, graphics.getTransform().getScaleX());
        Camera camera = SolidPainter.fit(
                scene, angle.orElseThrow(), MARGIN, MARGIN, width - 2.0 * MARGIN, high - (double) MARGIN);
        Color ground = theme.color(Tone.CANVAS);
        Graphics2D g = Shapes.smooth(graphics);
        g.setColor(ground);
        g.fillRect(0, 0, size.width, size.height);
        g.drawImage(painter.image(camera, width, high, density, seconds, ground), 0, 0, width, high, null);
        legend().paint(g, MARGIN, size.height - MARGIN - footer, legendWidth(width));
        g.dispose();
    }

    /** Returns the painter of the run, if there is one. */
    Optional<RunPainter> runPainter() {
        return run.map(r -> new RunPainter(r, theme));
    }

    /** Paints the picture as it stands at {@code seconds}, without the actors. */
    void paintStill(Graphics2D graphics, int width, Optional<RunPainter> painter, double seconds) {
        paint(graphics, width, painter, seconds, false);
    }

    /** Paints the actors as they stand at {@code seconds}. */
    void paintMoving(Graphics2D graphics, int width, Optional<RunPainter> painter, double seconds) {
        painter.ifPresent(p -> p.paintActors(graphics, view(width), seconds));
    }

    /** Returns the pixels that the world takes in a picture of the given width. */
    public Rectangle2D sceneBox(int width) {
        Viewport view = view(width);
        return new Rectangle2D.Double(
                view.px(0),
                view.py(scene.world().depth()),
                scene.world().width() * view.scale(),
                scene.world().depth() * view.scale());
    }

    /** Returns the pixels that legend and scale bar may take in a picture of the given width. */
    Rectangle2D footerBox(int width) {
        Dimension size = size(width);
        int footer = footer(width);
        return new Rectangle2D.Double(0, size.height - MARGIN - footer, size.width, footer);
    }

    /** Returns the ground rectangle; a side that is no length of a drawable world counts as a metre. */
    private Box world() {
        return new Box(
                0, 0, drawable(scene.world().width()), drawable(scene.world().depth()));
    }

    private static double drawable(double side) {
        return side > 1e-6 && side < 1e9 ? side : 1;
    }

    private Viewport view(int width) {
        Dimension size = size(width);
        Box world = world();
        double height = size.height - 2.0 * MARGIN - GAP - footer(width);
        return Viewport.fit(world, MARGIN, MARGIN, size.width - 2.0 * MARGIN, height);
    }

    private void paint(
            Graphics2D graphics, int width, Optional<RunPainter> runPainter, double seconds, boolean avoidActors) {
        Dimension size = size(width);
        Graphics2D g = Shapes.smooth(graphics);
        g.setColor(theme.color(Tone.CANVAS));
        g.fillRect(0, 0, size.width, size.height);
        Viewport view = view(width);
        paintScene(g, width, runPainter, seconds, avoidActors);
        legend().paint(g, MARGIN, size.height - MARGIN - footer(width), legendWidth(width));
        ScaleBar.paint(g, view, theme, size.width - MARGIN - 2, size.height - MARGIN - 2);
        g.dispose();
    }

    private void paintScene(
            Graphics2D g, int width, Optional<RunPainter> runPainter, double seconds, boolean avoidActors) {
        Viewport view = view(width);
        ScenePainter painter = runPainter
                .map(p -> p.scene(scene, seconds))
                .orElseGet(() -> new ScenePainter(scene, theme))
                .upTo(elevation);
        Labels labels = new Labels();
        painter.paintGround(g, view);
        painter.paintObstacles(g, view);
        Graphics2D inside = (Graphics2D) g.create();
        inside.clip(sceneBox(width));
        boolean fields = false;
        for (Overlay overlay : overlays) {
            if (overlay instanceof Overlay.Field) {
                new OverlayPainter(overlay, theme, filled).paint(inside, view);
                fields = true;
            }
        }
        if (fields) {
            painter.paintOutlines(inside, view);
        }
        for (Overlay overlay : overlays) {
            if (!(overlay instanceof Overlay.Field)) {
                new OverlayPainter(overlay, theme, filled).paint(inside, view);
            }
        }
        inside.dispose();
        runPainter.ifPresent(p -> {
            p.paintLegs(g, view);
            p.paintEnds(g, view);
            p.takeRoom(labels, view, avoidActors ? seconds : Double.NaN);
        });
        if (run.isEmpty() && scene.tasks().stream().findFirst().orElse(null) instanceof Journey journey) {
            TaskPainter.paint(g, scene, journey, view, theme);
            TaskPainter.take(labels, journey, view);
        }
        if (run.isEmpty() && scene.tasks().stream().findFirst().orElse(null) instanceof Encounter encounter) {
            TaskPainter.paint(g, scene, encounter, view, theme);
            TaskPainter.take(labels, encounter, view);
        }
        painter.paintLabels(g, view, labels);
        runPainter.ifPresent(p -> p.paintPills(g, view, labels));
    }
}
