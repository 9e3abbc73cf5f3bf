package troupe.app.canvas;

import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Point2D;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import troupe.app.tool.PanTool;
import troupe.app.tool.Pointer;
import troupe.app.tool.SteerTool;
import troupe.app.tool.Tool;

/** Leads the events of the pointer to the tool in hand, or to the view. */
final class CanvasMouse extends MouseAdapter {
    private static final double ZOOM = 1.15;

    private final Canvas canvas;
    private final PanTool pan;
    private final SteerTool steer;
    private Tool working;
    private int button;

    CanvasMouse(Canvas canvas, SteerTool steer) {
        this.canvas = canvas;
        this.steer = steer;
        this.pan = new PanTool((dx, dy) -> canvas.show(canvas.view().panned(dx, dy)));
        canvas.addMouseListener(this);
        canvas.addMouseMotionListener(this);
        canvas.addMouseWheelListener(this);
        key("ESCAPE", this::escape);
        key("ENTER", () -> with(Tool::finish));
        key("BACK_SPACE", () -> with(Tool::stepBack));
    }

    private void key(String stroke, Runnable action) {
        canvas.getInputMap().put(KeyStroke.getKeyStroke(stroke), stroke);
        canvas.getActionMap().put(stroke, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    private void with(Consumer<Tool> action) {
        if (canvas.tool() != null && working == null) {
            action.accept(canvas.tool());
            told();
        }
    }

    /** Tells whether the pointer is on an avatar that can be steered, and the tool in hand lets it. */
    private boolean steers(MouseEvent event) {
        return canvas.tool() != null && canvas.tool().key().equals("select") && steer.takes(pointer(event));
    }

    private void told() {
        canvas.gestures().tell(canvas.tool());
        canvas.repaint();
    }

    private void escape() {
        Tool tool = working == null ? canvas.tool() : working;
        working = null;
        if (tool != null) {
            tool.cancel();
        }
        told();
    }

    private Pointer pointer(MouseEvent event) {
        Point2D place = canvas.place(event);
        return new Pointer(
                canvas.view().point(place.getX(), place.getY()),
                place.getX(),
                place.getY(),
                event.isShiftDown(),
                event.isAltDown() == canvas.isSnapping(),
                event.getClickCount());
    }

    @Override
    public void mousePressed(MouseEvent event) {
        canvas.requestFocusInWindow();
        if (working != null) {
            return;
        }
        if (SwingUtilities.isMiddleMouseButton(event)) {
            working = pan;
        } else if (SwingUtilities.isLeftMouseButton(event)) {
            working = steers(event) ? steer : canvas.tool();
        }
        if (working != null) {
            button = event.getButton();
            working.press(pointer(event));
            told();
        }
    }

    @Override
    public void mouseDragged(MouseEvent event) {
        if (working != null) {
            working.drag(pointer(event));
            told();
        }
        canvas.pointers().tell(Optional.of(pointer(event).at()));
    }

    @Override
    public void mouseReleased(MouseEvent event) {
        Tool tool = working;
        if (tool != null && event.getButton() == button) {
            working = null;
            tool.release(pointer(event));
            told();
        }
    }

    @Override
    public void mouseMoved(MouseEvent event) {
        Tool tool = canvas.tool();
        if (tool != null) {
            Object before = tool.stamp();
            tool.move(pointer(event));
            canvas.setCursor((steers(event) ? steer : tool).cursor(pointer(event)));
            if (!before.equals(tool.stamp())) {
                told();
            }
        }
        canvas.pointers().tell(Optional.of(pointer(event).at()));
    }

    @Override
    public void mouseExited(MouseEvent event) {
        canvas.pointers().tell(Optional.empty());
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
        double factor = Math.pow(ZOOM, -event.getPreciseWheelRotation());
        Point2D place = canvas.place(event);
        canvas.show(canvas.view().zoomed(factor, place.getX(), place.getY()));
        canvas.pointers().tell(Optional.of(pointer(event).at()));
    }
}
