package troupe.app.panel;

import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.List;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import troupe.app.look.FlatButton;
import troupe.app.look.Look;
import troupe.paint.Tone;

/** Holds the tools, one icon each, below one another. */
public final class ToolStrip extends JPanel {

    /** Makes the strip of the commands that take a tool in hand. */
    public ToolStrip(Look look, List<Action> tools) {
        super(new FlowLayout(FlowLayout.CENTER, 0, 4));
        setName("tools");
        setBackground(look.color(Tone.PANEL));
        setBorder(
                BorderFactory.createCompoundBorder(look.line(0, 0, 0, 1), BorderFactory.createEmptyBorder(4, 0, 4, 0)));
        setPreferredSize(new Dimension(46, 100));
        for (Action action : tools) {
            FlatButton button = new FlatButton(look, FlatButton.Style.ICON, action);
            button.setName("tool." + action.getValue(Action.ACTION_COMMAND_KEY));
            add(Look.sized(button, 34, 34));
        }
    }
}
