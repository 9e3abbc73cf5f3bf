package troupe.app.solid;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import troupe.app.canvas.Canvas;
import troupe.app.look.Icons;
import troupe.app.look.Look;
import troupe.app.look.widget.FlatButton;
import troupe.app.look.widget.ThinDivider;

/** Lays out the plan and the view in three dimensions: one in a corner of the other, side by side, or alone. */
public final class SolidDeck extends JPanel {
    private static final Dimension CARD = new Dimension(218, 168);
    private static final int GAP = 12;
    /** The least canvas that has room for the card. */
    private static final Dimension ROOM = new Dimension(600, 360);

    private final transient Look look;
    private final Canvas canvas;
    private final SolidView view;
    private final JPanel corner = new JPanel(new BorderLayout());
    private final FlatButton hide;
    private SolidMode mode = SolidMode.HIDDEN;

    /** Makes a deck that shows the plan alone; {@code hidden} is told when the person closes the card. */
    public SolidDeck(Look look, Canvas canvas, SolidView view, Runnable hidden) {
        super(new BorderLayout());
        this.look = look;
        this.canvas = canvas;
        this.view = view;
        setMinimumSize(new Dimension(300, 200));
        corner.setOpaque(false);
        corner.setBorder(BorderFactory.createEmptyBorder(0, 0, 0, GAP));
        hide = new FlatButton(look, FlatButton.Style.ICON);
        hide.setIcon(Icons.CLOSE.icon(14));
        hide.setName("solid.hide");
        hide.setToolTipText(look.text("solid.hide"));
        hide.getAccessibleContext().setAccessibleName(look.text("solid.hide"));
        hide.addActionListener(e -> {
            hide.setSelected(false);
            hidden.run();
        });
        canvas.addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                makeRoom();
            }
        });
        add(canvas, BorderLayout.CENTER);
    }

    /** Shows the view in another place. */
    public void show(SolidMode other) {
        mode = other;
        removeAll();
        canvas.remove(corner);
        corner.removeAll();
        view.removeAll();
        view.setCard(mode == SolidMode.INSET);
        view.setPreferredSize(mode == SolidMode.INSET ? CARD : null);
        switch (mode) {
            case ALONE -> add(view, BorderLayout.CENTER);
            case BESIDE -> {
                canvas.setMinimumSize(new Dimension(150, 200));
                view.setMinimumSize(new Dimension(150, 200));
                JSplitPane split = ThinDivider.split(JSplitPane.HORIZONTAL_SPLIT, canvas, view, 0.5, look);
                add(split, BorderLayout.CENTER);
                SwingUtilities.invokeLater(() -> split.setDividerLocation(0.5));
            }
            case INSET -> {
                JPanel top = new JPanel(new BorderLayout());
                top.setOpaque(false);
                top.setBorder(BorderFactory.createEmptyBorder(5, 5, 5, 5));
                top.add(Look.sized(hide, 22, 22), BorderLayout.EAST);
                view.add(top, BorderLayout.NORTH);
                corner.add(view, BorderLayout.NORTH);
                canvas.add(corner, BorderLayout.EAST);
                add(canvas, BorderLayout.CENTER);
            }
            default -> add(canvas, BorderLayout.CENTER);
        }
        makeRoom();
        revalidate();
        repaint();
    }

    /** Has the plan leave room for the card, and hides the card where there is none. */
    private void makeRoom() {
        boolean room = canvas.getWidth() >= ROOM.width && canvas.getHeight() >= ROOM.height;
        boolean shown = mode == SolidMode.INSET && room;
        corner.setVisible(shown || canvas.getWidth() == 0);
        Dimension size = view.getPreferredSize();
        canvas.leaveCorner(shown ? new Dimension(size.width + 2 * GAP, size.height + GAP) : new Dimension());
    }
}
