package troupe.app.look;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.GridLayout;
import java.awt.Insets;
import java.awt.event.ContainerAdapter;
import java.awt.event.ContainerEvent;
import java.util.function.DoubleSupplier;
import javax.swing.CellRendererPane;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JSplitPane;
import javax.swing.border.Border;
import javax.swing.border.CompoundBorder;
import javax.swing.border.EmptyBorder;
import javax.swing.plaf.UIResource;

/**
 * Enlarges what components say in pixels at 100 %: sizes, the space in borders and between parts. Fonts come from
 * {@link Look} at their size, and what draws itself asks {@link Look#px}. Each component is enlarged once; one that
 * is added later is enlarged then. Belongs to the event thread.
 */
public final class Scaling {
    private static final String DONE = "troupe.scaled";
    private final DoubleSupplier scale;

    /** Makes an enlargement by a factor, 1 or more, that is asked for whenever it is needed. */
    public Scaling(DoubleSupplier scale) {
        this.scale = scale;
    }

    /** Enlarges a component, all that is in it, and what is added to it from now on. */
    public <C extends Component> C apply(C root) {
        enlarge(root);
        return root;
    }

    private void enlarge(Component component) {
        if (!(component instanceof JComponent part)
                || component instanceof CellRendererPane
                || part.getClientProperty(DONE) != null) {
            return;
        }
        part.putClientProperty(DONE, true);
        double by = scale.getAsDouble();
        if (by != 1) {
            sizes(part, by);
            if (part.getBorder() != null) {
                part.setBorder(border(part.getBorder(), by));
            }
            gaps(part, by);
        }
        for (Component inner : part.getComponents()) {
            enlarge(inner);
        }
        part.addContainerListener(new ContainerAdapter() {
            @Override
            public void componentAdded(ContainerEvent event) {
                Component added = event.getChild();
                boolean fresh = added instanceof JComponent inner && inner.getClientProperty(DONE) == null;
                enlarge(added);
                if (fresh) {
                    insets(part, added, scale.getAsDouble());
                }
            }
        });
    }

    private static void sizes(JComponent part, double by) {
        if (part.isPreferredSizeSet()) {
            part.setPreferredSize(size(part.getPreferredSize(), by));
        }
        if (part.isMinimumSizeSet()) {
            part.setMinimumSize(size(part.getMinimumSize(), by));
        }
        if (part.isMaximumSizeSet()) {
            part.setMaximumSize(size(part.getMaximumSize(), by));
        }
    }

    private static Dimension size(Dimension size, double by) {
        return new Dimension(length(size.width, by), length(size.height, by));
    }

    private static int length(int pixels, double by) {
        return pixels >= Short.MAX_VALUE ? pixels : (int) Math.round(pixels * by);
    }

    private static Border border(Border border, double by) {
        if (border instanceof UIResource) {
            return border;
        }
        if (border instanceof CompoundBorder both) {
            return new CompoundBorder(border(both.getOutsideBorder(), by), border(both.getInsideBorder(), by));
        }
        if (border != null && border.getClass() == EmptyBorder.class) {
            return new EmptyBorder(insets(((EmptyBorder) border).getBorderInsets(), by));
        }
        return border;
    }

    private static Insets insets(Insets at, double by) {
        return new Insets(length(at.top, by), length(at.left, by), length(at.bottom, by), length(at.right, by));
    }

    private static void gaps(JComponent part, double by) {
        if (part.getLayout() instanceof BorderLayout layout) {
            layout.setHgap(length(layout.getHgap(), by));
            layout.setVgap(length(layout.getVgap(), by));
        } else if (part.getLayout() instanceof FlowLayout layout) {
            layout.setHgap(length(layout.getHgap(), by));
            layout.setVgap(length(layout.getVgap(), by));
        } else if (part.getLayout() instanceof GridLayout layout) {
            layout.setHgap(length(layout.getHgap(), by));
            layout.setVgap(length(layout.getVgap(), by));
        }
        for (Component inner : part.getComponents()) {
            insets(part, inner, by);
        }
        if (part instanceof JSplitPane split) {
            split.setDividerSize(length(split.getDividerSize(), by));
        } else if (part instanceof JList<?> list && list.getFixedCellHeight() > 0) {
            list.setFixedCellHeight(length(list.getFixedCellHeight(), by));
        }
    }

    private static void insets(Container part, Component inner, double by) {
        if (by != 1 && part.getLayout() instanceof GridBagLayout layout) {
            GridBagConstraints at = layout.getConstraints(inner);
            at.insets = insets(at.insets, by);
            layout.setConstraints(inner, at);
        }
    }
}
