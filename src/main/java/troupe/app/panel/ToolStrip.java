package troupe.app.panel;

import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.ArrayList;
import java.util.List;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import troupe.app.look.Icons;
import troupe.app.look.Look;
import troupe.app.look.widget.FlatButton;
import troupe.paint.Tone;

/** Holds the tools, one icon each, below one another; those for which there is no room are behind the last button. */
public final class ToolStrip extends JPanel {
    private static final int GAP = 4;
    private static final int SIDE = 34;

    private final transient Look look;
    private final transient List<Action> tools;
    private final List<FlatButton> buttons = new ArrayList<>();
    private final FlatButton more;

    /** Makes the strip of the commands that take a tool in hand. */
    public ToolStrip(Look look, List<Action> tools) {
        super(new FlowLayout(FlowLayout.CENTER, 0, GAP));
        this.look = look;
        this.tools = List.copyOf(tools);
        setName("tools");
        setBackground(look.color(Tone.PANEL));
        setBorder(
                BorderFactory.createCompoundBorder(look.line(0, 0, 0, 1), BorderFactory.createEmptyBorder(4, 0, 4, 0)));
        setPreferredSize(new Dimension(46, 100));
        for (Action action : tools) {
            FlatButton button = new FlatButton(look, FlatButton.Style.ICON, action);
            button.setName("tool." + action.getValue(Action.ACTION_COMMAND_KEY));
            buttons.add(button);
            add(Look.sized(button, SIDE, SIDE));
        }
        more = new FlatButton(look, FlatButton.Style.ICON);
        more.setIcon(Icons.DOWN.icon(19));
        more.setName("tool.more");
        more.setToolTipText(look.text("tools.more"));
        more.getAccessibleContext().setAccessibleName(look.text("tools.more"));
        more.addActionListener(e -> showMore());
        add(Look.sized(more, SIDE, SIDE));
    }

    /** {@inheritDoc} Before, it decides which tools have room. */
    @Override
    public void doLayout() {
        int each = look.px(SIDE) + look.px(GAP);
        int room = (getHeight() - getInsets().top - getInsets().bottom - look.px(GAP)) / each;
        boolean all = room >= buttons.size();
        for (int i = 0; i < buttons.size(); i++) {
            buttons.get(i).setVisible(all || i < room - 1);
        }
        more.setVisible(!all);
        super.doLayout();
    }

    private void showMore() {
        more.setSelected(false);
        JPopupMenu menu = new JPopupMenu();
        for (int i = 0; i < buttons.size(); i++) {
            if (!buttons.get(i).isVisible()) {
                JMenuItem item = new JMenuItem(tools.get(i));
                item.setName("more." + tools.get(i).getValue(Action.ACTION_COMMAND_KEY));
                item.setIcon((Icon) tools.get(i).getValue(Action.LARGE_ICON_KEY));
                item.setToolTipText(null);
                menu.add(item);
            }
        }
        menu.show(more, more.getWidth() + look.px(GAP), 0);
    }
}
