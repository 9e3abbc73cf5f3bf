package troupe.paint;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;

/**
 * Makes the pictures of a run one after another: what does not change is painted once, the actors each
 * time. Holds an image; serves one thread.
 */
public final class Animation {
    private final Picture picture;
    private final int width;
    private final double density;
    private final BufferedImage base;

    /** Makes the animation of a picture; width and density as in {@link Picture#image(int, double)}. */
    public Animation(Picture picture, int width, double density) {
        this.picture = picture;
        this.width = width;
        this.density = density;
        this.base = picture.blank(width, density);
        Graphics2D g = base.createGraphics();
        g.scale(density, density);
        picture.paintStill(g, width);
        g.dispose();
    }

    /** Returns a new image of the run at {@code time} seconds. */
    public BufferedImage image(double time) {
        BufferedImage image = new BufferedImage(base.getWidth(), base.getHeight(), base.getType());
        Graphics2D g = image.createGraphics();
        g.drawImage(base, 0, 0, null);
        g.scale(density, density);
        picture.paintMoving(g, width, time);
        g.dispose();
        return image;
    }
}
