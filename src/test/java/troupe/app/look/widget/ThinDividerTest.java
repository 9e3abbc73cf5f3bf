package troupe.app.look.widget;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.util.Locale;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import org.junit.jupiter.api.Test;
import troupe.app.OnEventThread;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.paint.Theme;

class ThinDividerTest {
    private final JPanel side = new JPanel();
    private final JPanel middle = new JPanel();
    private final JSplitPane split = OnEventThread.get(() -> {
        side.setPreferredSize(new Dimension(200, 100));
        side.setMinimumSize(new Dimension(20, 20));
        middle.setMinimumSize(new Dimension(20, 20));
        Look look = new Look(Theme.LIGHT, new Texts(Locale.ENGLISH));
        return ThinDivider.split(JSplitPane.HORIZONTAL_SPLIT, side, middle, 0, look);
    });

    private void wide(int pixels) {
        split.setSize(pixels, 300);
        split.doLayout();
    }

    private int hideAndShow() {
        return OnEventThread.get(() -> {
            ThinDivider.show(split, side, false);
            split.doLayout();
            wide(900);
            ThinDivider.show(split, side, true);
            split.doLayout();
            return side.getWidth();
        });
    }

    @Test
    void whatWasSqueezedBeforeItWasHiddenIsShownAsWideAsItLikes() {
        OnEventThread.run(() -> {
            wide(900);
            wide(120);
            assertTrue(side.getWidth() < 110, "not squeezed: " + side.getWidth());
        });
        assertEquals(200, hideAndShow());
        assertEquals(200, hideAndShow());
    }

    @Test
    void whatWasMadeWiderIsShownAsWideAsItWas() {
        OnEventThread.run(() -> {
            wide(900);
            split.setDividerLocation(330);
            split.doLayout();
        });
        assertEquals(330, hideAndShow());
    }
}
