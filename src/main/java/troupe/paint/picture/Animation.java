package troupe.paint.picture;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import troupe.geometry.Pose;
import troupe.paint.motion.RunPainter;
import troupe.paint.solid.SolidPainter;

/**
 * Makes the pictures of a run one after another: what does not change is painted once, or anew while an
 * obstacle is being moved, the actors each time. Holds an image; serves one thread.
 */
public final class Animation {
    private final Picture picture;
    private final int width;
    private final double density;
    private final Optional<RunPainter> painter;
    private final Optional<SolidPainter> solid;
    private final BufferedImage base;

    /** Where the moved obstacles stand in {@link #base}; null before it is painted. */
    private List<Pose> poses;

    /** Makes the animation of a picture; width and density as in {@link Picture#image(int, double)}. */
    public Animation(Picture picture, int width, double density) {
        this.picture = picture;
        this.width = width;
        this.density = density;
        this.painter = picture.runPainter();
        this.solid = picture.angle().map(angle -> picture.solidPainter());
        this.base = picture.blank(width, density);
    }

    private void paintBase(double time) {
        List<Pose> now = painter.map(p -> p.poses(time)).orElse(List.of());
        if (!now.equals(poses)) {
            Graphics2D g = base.createGraphics();
            g.scale(density, density);
            picture.paintStill(g, width, painter, time);
            g.dispose();
            poses = now;
        }
    }

    /** Returns a new image of the run at {@code time} seconds. */
    public BufferedImage image(double time) {
        if (solid.isPresent()) {
            return solidImage(solid.get(), time);
        }
        paintBase(time);
        BufferedImage image = new BufferedImage(base.getWidth(), base.getHeight(), base.getType());
        Graphics2D g = image.createGraphics();
        g.drawImage(base, 0, 0, null);
        g.scale(density, density);
        picture.paintMoving(g, width, painter, time);
        g.dispose();
        return image;
    }

    private BufferedImage solidImage(SolidPainter from, double time) {
        BufferedImage image = new BufferedImage(base.getWidth(), base.getHeight(), base.getType());
        Graphics2D g = image.createGraphics();
        g.scale(density, density);
        picture.paintSolid(g, width, from, time);
        g.dispose();
        return image;
    }
}
