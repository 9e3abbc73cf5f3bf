package troupe.app.solid;

import java.awt.BorderLayout;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.RoundRectangle2D;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import javax.swing.AbstractAction;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import troupe.app.look.Look;
import troupe.app.panel.Panel;
import troupe.app.plan.Views;
import troupe.app.session.OverlayChoice;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.scene.Scene;

/**
 * Shows the scene, the plan and whoever moves in three dimensions. Dragging turns it, with Shift or another button
 * it is moved; the wheel zooms; a double click shows all of it again; arrow keys, plus, minus and Home do the same.
 */
public final class SolidView extends Panel {
    private static final double TURN = 0.008;
    private static final double ZOOM = 1.12;
    /** Pictures of more pixels are made in a hurry while something moves. */
    private static final int LARGE = 120_000;

    private static final int SETTLED_MS = 160;
    private static final int ARC = 14;
    private static final int CAPTION = 16;

    private final transient SolidPictures pictures;
    private final Timer settled = new Timer(SETTLED_MS, e -> wish(false));
    private transient Eye eye;
    private transient SolidPictures.Made made;
    private boolean card;
    private double density = 1;

    /** Makes the view. */
    public SolidView(Look look, Session session, Eye eye, Executor eventThread) {
        super(look, session, new BorderLayout());
        this.eye = eye;
        this.pictures = new SolidPictures(eventThread, this::take);
        setName("solid");
        setOpaque(false);
        setFocusable(true);
        settled.setRepeats(false);
        setToolTipText(look.text("solid.hint"));
        getAccessibleContext().setAccessibleName(look.text("solid.name"));
        getAccessibleContext().setAccessibleDescription(look.text("solid.hint"));
        setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        Mouse mouse = new Mouse();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        addKeys();
        observing(session.document().listeners().add(change -> moving()));
        observing(session.plans().add(plan -> moving()));
        observing(session.selection().listeners().add(s -> moving()));
        observing(session.overlays().listeners().add(choice -> moving()));
        observing(session.playback().listeners().add(playback -> moving()));
    }

    private void addKeys() {
        key("LEFT", () -> look(eye.turned(-0.1, 0)));
        key("RIGHT", () -> look(eye.turned(0.1, 0)));
        key("UP", () -> look(eye.turned(0, 0.06)));
        key("DOWN", () -> look(eye.turned(0, -0.06)));
        key("PLUS", () -> look(eye.zoomed(ZOOM, 0, 0)));
        key("EQUALS", () -> look(eye.zoomed(ZOOM, 0, 0)));
        key("MINUS", () -> look(eye.zoomed(1 / ZOOM, 0, 0)));
        key("HOME", () -> look(Eye.DEFAULT));
    }

    private void key(String stroke, Runnable action) {
        getInputMap().put(KeyStroke.getKeyStroke(stroke), stroke);
        getActionMap().put(stroke, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }

    /** Returns from where it is looked at. */
    public Eye eye() {
        return eye;
    }

    private void look(Eye from) {
        eye = from;
        moving();
    }

    /** Shows it as a card with a caption, or as wide as there is room. */
    void setCard(boolean on) {
        card = on;
    }

    private void moving() {
        wish(true);
    }

    private void wish(boolean moves) {
        if (!isShowing() || getWidth() < 8 || getHeight() < 8) {
            return;
        }
        Scene scene = session().document().shown();
        boolean planned = session().overlays().shows(OverlayChoice.PLAN);
        boolean draft = moves && getWidth() * density * getHeight() * density > LARGE;
        SolidPictures.Wish wish = new SolidPictures.Wish(
                scene,
                session().run().filter(run -> planned),
                look().theme(),
                session().playback().time(),
                elevation(),
                Set.copyOf(session().selection().ids()),
                eye.camera(scene, getWidth(), getHeight() - CAPTION, card ? 8 : 24)
                        .panned(0, CAPTION),
                new SolidPictures.Frame(
                        getWidth(), getHeight(), density, draft, look().color(card ? Tone.PANEL : Tone.CANVAS)));
        pictures.wish(wish);
        if (draft) {
            settled.restart();
        }
    }

    /** Returns how high the floors of the layer looked at go; infinity for all layers. */
    private double elevation() {
        int layer = session().overlays().layer();
        return session()
                .plan()
                .map(plan -> plan.views().layers())
                .filter(layers -> layer >= 0 && layer < layers.size())
                .map(layers -> layers.get(layer))
                .map(Views.Layer::highest)
                .filter(highest -> !Double.isNaN(highest))
                .orElse(Double.POSITIVE_INFINITY);
    }

    private void take(SolidPictures.Made newer) {
        made = newer;
        repaint();
    }

    /** Returns the picture that is shown; empty before the first is made. */
    Optional<SolidPictures.Made> shown() {
        return Optional.ofNullable(made);
    }

    @Override
    public Dimension getPreferredSize() {
        return isPreferredSizeSet() ? super.getPreferredSize() : new Dimension(360, 300);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        double dense = Math.max(1, Math.min(3, g.getTransform().getScaleX()));
        boolean fits = made != null
                && made.wish().frame().width() == getWidth()
                && made.wish().frame().height() == getHeight();
        if (dense != density || !fits) {
            density = dense;
            wish(false);
        }
        RoundRectangle2D shape = new RoundRectangle2D.Double(
                0.5, 0.5, getWidth() - 1.0, getHeight() - 1.0, card ? ARC : 0, card ? ARC : 0);
        g.setColor(look().color(card ? Tone.PANEL : Tone.CANVAS));
        g.fill(shape);
        if (made != null) {
            Graphics2D inside = (Graphics2D) g.create();
            inside.clip(shape);
            SolidPictures.Frame frame = made.wish().frame();
            inside.drawImage(made.image(), 0, 0, frame.width(), frame.height(), null);
            inside.dispose();
        }
        if (card) {
            g.setColor(look().color(Tone.LINE));
            g.draw(shape);
        }
        g.setFont(look().font());
        g.setColor(look().color(isFocusOwner() ? Tone.ACCENT : Tone.DIM));
        g.drawString(look().text("solid.caption"), look().px(11), look().px(19));
        g.dispose();
    }

    @Override
    public void close() {
        super.close();
        settled.stop();
        pictures.close();
    }

    /** Turns, moves and zooms. */
    private final class Mouse extends MouseAdapter {
        private int x;
        private int y;

        @Override
        public void mousePressed(MouseEvent event) {
            requestFocusInWindow();
            x = event.getX();
            y = event.getY();
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            double dx = event.getX() - x;
            double dy = event.getY() - y;
            x = event.getX();
            y = event.getY();
            boolean moves = event.isShiftDown() || !SwingUtilities.isLeftMouseButton(event);
            double width = Math.max(1, getWidth());
            look(moves ? eye.moved(dx / width, dy / width) : eye.turned(-dx * TURN, dy * TURN));
        }

        @Override
        public void mouseClicked(MouseEvent event) {
            if (event.getClickCount() == 2) {
                look(new Eye(eye.angle(), 1, 0, 0));
            }
        }

        @Override
        public void mouseWheelMoved(MouseWheelEvent event) {
            double width = Math.max(1, getWidth());
            double factor = Math.pow(ZOOM, -event.getPreciseWheelRotation());
            look(eye.zoomed(factor, (event.getX() - width / 2) / width, (event.getY() - getHeight() / 2.0) / width));
        }
    }
}
