package troupe.app.look.widget;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.JToggleButton;
import troupe.app.look.Look;
import troupe.paint.Tone;

/** A small switch: a knob to the left when off, to the right when on. */
public final class Switch extends JToggleButton {
    private static final int WIDTH = 30;
    private static final int HEIGHT = 17;
    private final transient Look look;

    /** Makes a switch that is off. */
    public Switch(Look look) {
        this.look = look;
        setContentAreaFilled(false);
        setBorderPainted(false);
        setFocusPainted(false);
        setOpaque(false);
        setPreferredSize(new Dimension(WIDTH, HEIGHT));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        g.translate(0, (getHeight() - HEIGHT * look.scale()) / 2);
        g.scale(look.scale(), look.scale());
        g.setColor(look.color(isSelected() ? Tone.ACCENT : Tone.LINE));
        g.fillRoundRect(0, 0, WIDTH, HEIGHT, HEIGHT, HEIGHT);
        if (isFocusOwner()) {
            g.setColor(look.color(Tone.TEXT));
            g.drawRoundRect(0, 0, WIDTH - 1, HEIGHT - 1, HEIGHT, HEIGHT);
        }
        g.setColor(look.color(Tone.PANEL));
        g.fillOval(isSelected() ? WIDTH - 15 : 2, 2, 13, 13);
        g.dispose();
    }
}
