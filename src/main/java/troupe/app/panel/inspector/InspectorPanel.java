package troupe.app.panel.inspector;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JPanel;
import javax.swing.Scrollable;
import javax.swing.SwingConstants;
import troupe.app.look.Look;
import troupe.app.look.widget.ThinScrollBarUI;
import troupe.app.panel.Panel;
import troupe.app.session.Session;
import troupe.paint.Tone;

/** Shows the selection's properties, what the actor prefers or the simulation can be told, and why the plan goes this way. */
public final class InspectorPanel extends Panel {

    /** Makes the inspector without a list of problems. */
    public InspectorPanel(Look look, Session session) {
        this(look, session, List.of());
    }

    /** Makes the inspector with sections above the others, such as the list of problems. */
    public InspectorPanel(Look look, Session session, List<? extends Panel> above) {
        super(look, session, new BorderLayout());
        setName("inspector");
        setBorder(look.line(0, 1, 0, 0));
        setMinimumSize(new Dimension(230, 100));
        setPreferredSize(new Dimension(292, 100));
        JPanel sections = new Sections();
        sections.setLayout(new BoxLayout(sections, BoxLayout.Y_AXIS));
        sections.setBackground(look.color(Tone.PANEL));
        PropertiesSection properties = new PropertiesSection(look, session);
        PreferencesSection preferences = new PreferencesSection(look, session);
        ControlsSection controls = new ControlsSection(look, session);
        ForesightSection foresight = new ForesightSection(look, session);
        WhySection why = new WhySection(look, session);
        List<Panel> all = new ArrayList<>(above);
        all.addAll(List.of(properties, preferences, controls, foresight, why));
        for (Panel section : all) {
            section.setBorder(BorderFactory.createCompoundBorder(
                    look.line(0, 0, section == why ? 0 : 1, 0), BorderFactory.createEmptyBorder(11, 16, 11, 16)));
            section.setAlignmentX(LEFT_ALIGNMENT);
            sections.add(section);
            observing(section::close);
        }
        add(ThinScrollBarUI.scroll(sections, look), BorderLayout.CENTER);
    }

    /** Keeps the sections as wide as the panel. */
    private static final class Sections extends JPanel implements Scrollable {
        @Override
        public Dimension getPreferredScrollableViewportSize() {
            return getPreferredSize();
        }

        @Override
        public int getScrollableUnitIncrement(java.awt.Rectangle visible, int orientation, int direction) {
            return 20;
        }

        @Override
        public int getScrollableBlockIncrement(java.awt.Rectangle visible, int orientation, int direction) {
            return orientation == SwingConstants.VERTICAL ? visible.height : visible.width;
        }

        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true;
        }

        @Override
        public boolean getScrollableTracksViewportHeight() {
            return false;
        }
    }
}
