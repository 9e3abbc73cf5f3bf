package troupe.app.look;

import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;

/** A component that draws itself, with a name and a description for screen readers. */
public abstract class Drawn extends JComponent implements Accessible {

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleDrawn();
        }
        return accessibleContext;
    }

    /** What screen readers are told. */
    protected final class AccessibleDrawn extends AccessibleJComponent {
        @Override
        public AccessibleRole getAccessibleRole() {
            return AccessibleRole.CANVAS;
        }
    }
}
