package troupe.app.start;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Optional;
import javax.swing.JButton;
import troupe.app.look.Look;
import troupe.paint.Tone;

/** A button with the picture of a scene over its title. */
final class SceneCard extends JButton {
    /** The width of a picture in pixels at 100 %. */
    static final int WIDTH = 216;

    /** The height of a picture in pixels at 100 %. */
    static final int HEIGHT = 150;

    private static final int TITLE = 34;
    private static final int ARC = 12;

    private final transient Look look;
    private final String title;
    private transient Optional<BufferedImage> image = Optional.empty();
    private double density = 1;

    SceneCard(Look look, String title) {
        this.look = look;
        this.title = title;
        setFont(look.font());
        setContentAreaFilled(false);
        setBorderPainted(false);
        setFocusPainted(false);
        setOpaque(false);
        setRolloverEnabled(true);
        setPreferredSize(new Dimension(WIDTH + 2, HEIGHT + TITLE + 2));
        name();
    }

    private void name() {
        getAccessibleContext().setAccessibleName(title);
        getAccessibleContext().setAccessibleDescription(look.texts().format("start.example.hint", title));
    }

    /** Shows the picture of the file; {@code pixels} is its density. */
    void show(ScenePictures.Made made, double pixels) {
        image = made.image();
        density = pixels;
        name();
        repaint();
    }

    /** Tells whether the picture is there. */
    boolean isShown() {
        return image.isPresent();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        boolean marked = isFocusOwner() || getModel().isRollover();
        int below = getHeight() - Math.round(TITLE * getHeight() / (float) (HEIGHT + TITLE + 2));
        g.setColor(getModel().isRollover() ? look.hovered() : look.color(Tone.PANEL));
        g.fillRoundRect(0, 0, getWidth() - 1, getHeight() - 1, ARC, ARC);
        g.setColor(look.color(Tone.CANVAS));
        g.fillRoundRect(0, 0, getWidth() - 1, below, ARC, ARC);
        g.fillRect(0, below - ARC, getWidth() - 1, ARC);
        image.ifPresent(picture -> {
            int width = (int) Math.round(picture.getWidth() / density);
            int height = (int) Math.round(picture.getHeight() / density);
            g.drawImage(picture, (getWidth() - width) / 2, (below - height) / 2, width, height, null);
        });
        g.setColor(look.color(marked ? Tone.ACCENT : Tone.LINE));
        g.drawRoundRect(0, 0, getWidth() - 1, getHeight() - 1, ARC, ARC);
        if (isFocusOwner()) {
            g.drawRoundRect(1, 1, getWidth() - 3, getHeight() - 3, ARC, ARC);
        }
        g.setFont(getFont());
        g.setColor(look.color(Tone.TEXT));
        FontMetrics metrics = g.getFontMetrics();
        int base = below + (getHeight() - below - metrics.getHeight()) / 2 + metrics.getAscent();
        g.drawString(title, look.px(12), base);
        g.dispose();
    }
}
