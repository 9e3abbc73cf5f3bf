package troupe.app.help;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import javax.swing.JTextField;
import troupe.app.look.Look;
import troupe.paint.Tone;

/** A field for words to find; says so as long as it is empty. */
final class SearchField extends JTextField {
    private final transient Look look;
    private final String invitation;

    SearchField(Look look, String name, String invitation) {
        this.look = look;
        this.invitation = invitation;
        setName(name);
        setFont(look.font());
        setToolTipText(invitation);
        getAccessibleContext().setAccessibleName(invitation);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        if (getText().isEmpty()) {
            Graphics2D g = Look.smooth(graphics);
            Insets insets = getInsets();
            g.setFont(getFont());
            g.setColor(look.color(Tone.DIM));
            int ascent = g.getFontMetrics().getAscent();
            int base = (getHeight() - g.getFontMetrics().getHeight()) / 2 + ascent;
            g.drawString(invitation, insets.left + look.px(3), base);
            g.dispose();
        }
    }
}
