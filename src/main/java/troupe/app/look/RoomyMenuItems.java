package troupe.app.look;

import java.awt.FontMetrics;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicCheckBoxMenuItemUI;
import javax.swing.plaf.basic.BasicMenuItemUI;

/**
 * Holds the looks of menu items that keep their shortcuts off their texts, by as much as a letter is wide at any scale;
 * {@link SwingTheme} names them to Swing, which makes them. Belongs to the event thread.
 */
public final class RoomyMenuItems {
    private RoomyMenuItems() {}

    private static int gap(JMenuItem item) {
        FontMetrics metrics = item.getFontMetrics(item.getFont());
        return metrics.charWidth('m');
    }

    /** Paints an item that does something. */
    public static final class Plain extends BasicMenuItemUI {
        private Plain() {}

        /** Makes the look of an item. */
        public static ComponentUI createUI(JComponent item) {
            return new Plain();
        }

        @Override
        protected void installDefaults() {
            super.installDefaults();
            defaultTextIconGap = gap(menuItem);
        }
    }

    /** Paints an item that is on or off. */
    public static final class Choice extends BasicCheckBoxMenuItemUI {
        private Choice() {}

        /** Makes the look of an item. */
        public static ComponentUI createUI(JComponent item) {
            return new Choice();
        }

        @Override
        protected void installDefaults() {
            super.installDefaults();
            defaultTextIconGap = gap(menuItem);
        }
    }
}
