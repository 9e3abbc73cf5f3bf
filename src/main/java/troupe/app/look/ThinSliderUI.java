package troupe.app.look;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.JSlider;
import javax.swing.plaf.basic.BasicSliderUI;
import troupe.paint.Tone;

/** Draws a slider as a thin line with a round knob. */
public final class ThinSliderUI extends BasicSliderUI {
    private static final int KNOB = 13;
    private final Look look;

    /** Makes the looks of one slider. */
    public ThinSliderUI(JSlider slider, Look look) {
        super(slider);
        this.look = look;
    }

    @Override
    protected Dimension getThumbSize() {
        return new Dimension(KNOB, KNOB);
    }

    @Override
    public void paintTrack(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        int y = trackRect.y + trackRect.height / 2 - 1;
        int knob = thumbRect.x + KNOB / 2;
        g.setColor(look.color(Tone.LINE));
        g.fillRoundRect(trackRect.x, y, trackRect.width, 3, 3, 3);
        g.setColor(look.color(slider.isEnabled() ? Tone.ACCENT : Tone.LINE));
        g.fillRoundRect(trackRect.x, y, knob - trackRect.x, 3, 3, 3);
        g.dispose();
    }

    @Override
    public void paintThumb(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        g.setColor(look.color(slider.isEnabled() ? Tone.ACCENT : Tone.LINE));
        g.fillOval(thumbRect.x, thumbRect.y, KNOB, KNOB);
        g.setColor(look.color(slider.isFocusOwner() ? Tone.ACCENT : Tone.PANEL));
        g.fillOval(thumbRect.x + 2, thumbRect.y + 2, KNOB - 4, KNOB - 4);
        g.dispose();
    }

    @Override
    public void paintFocus(Graphics graphics) {
        // the knob shows the focus
    }
}
