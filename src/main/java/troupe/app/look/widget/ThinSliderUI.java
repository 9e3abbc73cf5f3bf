package troupe.app.look.widget;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.JSlider;
import javax.swing.plaf.basic.BasicSliderUI;
import troupe.app.look.Look;
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

    private int knob() {
        return look.px(KNOB);
    }

    @Override
    protected Dimension getThumbSize() {
        return new Dimension(knob(), knob());
    }

    @Override
    public void paintTrack(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        int thick = look.px(3);
        int y = trackRect.y + (trackRect.height - thick) / 2;
        int knob = thumbRect.x + knob() / 2;
        g.setColor(look.color(Tone.LINE));
        g.fillRoundRect(trackRect.x, y, trackRect.width, thick, thick, thick);
        g.setColor(look.color(slider.isEnabled() ? Tone.ACCENT : Tone.LINE));
        g.fillRoundRect(trackRect.x, y, knob - trackRect.x, thick, thick, thick);
        g.dispose();
    }

    @Override
    public void paintThumb(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        int edge = look.px(2);
        g.setColor(look.color(slider.isEnabled() ? Tone.ACCENT : Tone.LINE));
        g.fillOval(thumbRect.x, thumbRect.y, knob(), knob());
        g.setColor(look.color(slider.isFocusOwner() ? Tone.ACCENT : Tone.PANEL));
        g.fillOval(thumbRect.x + edge, thumbRect.y + edge, knob() - 2 * edge, knob() - 2 * edge);
        g.dispose();
    }

    @Override
    public void paintFocus(Graphics graphics) {
        // the knob shows the focus
    }
}
