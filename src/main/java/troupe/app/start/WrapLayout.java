package troupe.app.start;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;

/** Lays parts of one size out in rows, as many in a row as there is room for. */
final class WrapLayout implements LayoutManager {
    private final int across;
    private final int down;

    /** Makes a layout with gaps of so many pixels. */
    WrapLayout(int across, int down) {
        this.across = across;
        this.down = down;
    }

    private static Dimension cell(Container parent) {
        Dimension cell = new Dimension(1, 1);
        for (Component part : parent.getComponents()) {
            Dimension size = part.getPreferredSize();
            cell.setSize(Math.max(cell.width, size.width), Math.max(cell.height, size.height));
        }
        return cell;
    }

    private int columns(Container parent, Dimension cell) {
        int width = parent.getWidth() > 0
                ? parent.getWidth()
                : parent.getParent() == null ? 0 : parent.getParent().getWidth();
        return Math.max(1, (width + across) / (cell.width + across));
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        Dimension cell = cell(parent);
        int columns = columns(parent, cell);
        int rows = (parent.getComponentCount() + columns - 1) / columns;
        return new Dimension(columns * (cell.width + across) - across, Math.max(0, rows * (cell.height + down) - down));
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return new Dimension(cell(parent).width, preferredLayoutSize(parent).height);
    }

    @Override
    public void layoutContainer(Container parent) {
        Dimension cell = cell(parent);
        int columns = columns(parent, cell);
        for (int i = 0; i < parent.getComponentCount(); i++) {
            parent.getComponent(i)
                    .setBounds(
                            i % columns * (cell.width + across),
                            i / columns * (cell.height + down),
                            cell.width,
                            cell.height);
        }
        if (parent.getHeight() != preferredLayoutSize(parent).height && parent.getParent() != null) {
            javax.swing.SwingUtilities.invokeLater(((javax.swing.JComponent) parent)::revalidate);
        }
    }

    @Override
    public void addLayoutComponent(String name, Component component) {
        // nothing to remember
    }

    @Override
    public void removeLayoutComponent(Component component) {
        // nothing to forget
    }
}
