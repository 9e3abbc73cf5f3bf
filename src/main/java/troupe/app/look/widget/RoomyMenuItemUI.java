package troupe.app.look.widget;

import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicMenuItemUI;

/** Keeps the shortcut of a menu item off its text, by as much as a letter is wide at any scale. */
public final class RoomyMenuItemUI extends BasicMenuItemUI {
    private RoomyMenuItemUI() {}

    /** Makes the look of a menu item; named by the defaults of Swing. */
    public static ComponentUI createUI(JComponent item) {
        return new RoomyMenuItemUI();
    }

    @Override
    protected void installDefaults() {
        super.installDefaults();
        defaultTextIconGap = menuItem.getFontMetrics(menuItem.getFont()).charWidth('m');
    }
}
