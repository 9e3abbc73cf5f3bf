package troupe.app.look.widget;

import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicCheckBoxMenuItemUI;

/** Keeps the shortcut of a menu item that is on or off away from its text, as {@link RoomyMenuItemUI} does. */
public final class RoomyChoiceItemUI extends BasicCheckBoxMenuItemUI {
    private RoomyChoiceItemUI() {}

    /** Makes the look of a menu item; named by the defaults of Swing. */
    public static ComponentUI createUI(JComponent item) {
        return new RoomyChoiceItemUI();
    }

    @Override
    protected void installDefaults() {
        super.installDefaults();
        defaultTextIconGap = menuItem.getFontMetrics(menuItem.getFont()).charWidth('m');
    }
}
