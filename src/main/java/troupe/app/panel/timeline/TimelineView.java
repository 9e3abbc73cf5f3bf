package troupe.app.panel.timeline;

import java.awt.Color;
import java.awt.Cursor;
import java.awt.EventQueue;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.KeyStroke;
import troupe.app.document.SceneEdits;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.plan.Plan;
import troupe.app.play.Chronicle;
import troupe.app.play.Chronicles;
import troupe.app.play.Figures;
import troupe.app.play.Playback;
import troupe.app.session.Session;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.run.Run;
import troupe.scene.Ability;

/** Shows a run over its time: seconds, a bar in the colours of the abilities, the energy spent. Dragging scrubs. */
final class TimelineView extends Drawn {
    private static final double[] STEPS = {0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600};

    private final transient Look look;
    private final transient Session session;
    private final int barTop;
    private final int barHeight;
    private final int plotTop;
    private final int side;
    private transient Optional<Chronicle> chronicle = Optional.empty();
    private int curve;
    private double length;
    private double head;

    TimelineView(Look look, Session session, Consumer<Runnable> observing) {
        this.look = look;
        this.barTop = look.px(20);
        this.barHeight = look.px(20);
        this.plotTop = look.px(50);
        this.side = look.px(6);
        this.session = session;
        setName("timeline.view");
        setFocusable(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        getAccessibleContext().setAccessibleName(look.text("timeline.name"));
        observing.accept(session.playback().listeners().add(this::follow));
        Chronicles chronicles = new Chronicles(EventQueue::invokeLater, this::take);
        observing.accept(chronicles::close);
        observing.accept(session.plans().add(plan -> follow(plan, chronicles)));
        session.plan().ifPresent(plan -> follow(plan, chronicles));
        MouseAdapter scrub = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                requestFocusInWindow();
                if (chronicle.isPresent()
                        && event.getY() >= plotTop - look.px(4)
                        && event.getY() < plotTop + look.px(14)) {
                    nextCurve();
                    return;
                }
                session.playback().pause();
                session.playback().seek(timeAt(event.getX()));
            }

            @Override
            public void mouseDragged(MouseEvent event) {
                session.playback().seek(timeAt(event.getX()));
            }
        };
        addMouseListener(scrub);
        addMouseMotionListener(scrub);
        key("LEFT", p -> p.step(-1));
        key("RIGHT", p -> p.step(1));
        key("HOME", p -> p.seek(0));
        key("END", p -> p.seek(p.duration()));
        key("V", p -> nextCurve());
    }

    private void follow(Plan plan, Chronicles chronicles) {
        plan.run()
                .ifPresentOrElse(
                        run -> chronicles.request(run, plan.live().stepMillis()), () -> take(Optional.empty()));
        repaint();
    }

    /** Paints the head anew where only the time has changed, which is all the time while a run is played. */
    private void follow(Playback playback) {
        if (playback.duration() != length) {
            length = playback.duration();
            repaint();
        } else {
            repaintHead(head);
            repaintHead(xAt(playback.time()));
        }
    }

    private void repaintHead(double x) {
        int reach = look.px(8);
        repaint((int) x - reach, 0, 2 * reach + 1, getHeight());
    }

    private void take(Optional<Chronicle> made) {
        chronicle = made;
        repaint();
    }

    /** Shows another of the curves that there are, the one after the last being the first. */
    void nextCurve() {
        curve++;
        repaint();
    }

    private void key(String stroke, Consumer<Playback> action) {
        getInputMap().put(KeyStroke.getKeyStroke(stroke), stroke);
        getActionMap().put(stroke, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                action.accept(session.playback());
            }
        });
    }

    private double width() {
        return Math.max(1, getWidth() - 2.0 * side);
    }

    private double timeAt(int x) {
        return (x - side) / width() * session.playback().duration();
    }

    private double xAt(double time) {
        double duration = session.playback().duration();
        return side + (duration <= 0 ? 0 : time / duration * width());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Look.smooth(graphics);
        g.setFont(look.font());
        Optional<Run> run = session.run().filter(r -> !r.legs().isEmpty());
        if (chronicle.isPresent() && session.playback().duration() > 0) {
            paintSeconds(g);
            ChroniclePainter painter = new ChroniclePainter(
                    look, this::xAt, new ChroniclePainter.Rows(barTop, barHeight, plotTop, getHeight()));
            double told = Math.min(chronicle.get().seconds(), session.playback().duration());
            painter.paintMarks(g, chronicle.get().marks(), told);
            List<Chronicle.Curve> curves = chronicle.get().curves();
            painter.paintCurve(g, curves.get(curve % curves.size()), told);
            paintHead(g);
        } else if (run.isEmpty() || session.playback().duration() <= 0) {
            g.setColor(look.color(Tone.SOFT));
            g.fill(new RoundRectangle2D.Double(side, barTop, width(), barHeight, look.px(8), look.px(8)));
        } else {
            paintSeconds(g);
            paintBar(g, run.get());
            paintPlot(g, run.get());
            paintHead(g);
        }
        g.dispose();
    }

    private void paintSeconds(Graphics2D g) {
        double duration = session.playback().duration();
        double step = STEPS[STEPS.length - 1];
        for (int i = STEPS.length - 1; i >= 0; i--) {
            if (STEPS[i] / duration * width() >= look.px(64)) {
                step = STEPS[i];
            }
        }
        g.setColor(look.color(Tone.DIM));
        for (int k = 0; k * step <= duration + 1e-9; k++) {
            String text = Texts.number(k * step, step < 1 ? 1 : 0) + (k == 1 ? " s" : "");
            double x = Math.min(xAt(k * step), getWidth() - g.getFontMetrics().stringWidth(text));
            g.drawString(text, (float) x, look.px(12));
        }
    }

    private void paintBar(Graphics2D g, Run run) {
        FontMetrics metrics = g.getFontMetrics(look.bold());
        for (Figures.Stretch stretch : Figures.stretches(run)) {
            double from = xAt(stretch.begin());
            double to = Math.max(from + 2, xAt(stretch.end()) - 2);
            Color color = stretch.ability().map(look.theme()::color).orElse(look.color(Tone.DIM));
            g.setColor(color);
            g.fill(new RoundRectangle2D.Double(from, barTop, to - from, barHeight, look.px(8), look.px(8)));
            for (String text : texts(run, stretch)) {
                if (metrics.stringWidth(text) + look.px(14) <= to - from) {
                    g.setFont(look.bold());
                    g.setColor(look.theme().ink(color));
                    g.drawString(text, (float) from + look.px(8), barTop + (barHeight + metrics.getAscent()) / 2 - 2);
                    break;
                }
            }
        }
        g.setFont(look.font());
    }

    /** Returns what a stretch may be called, the longest first. */
    private List<String> texts(Run run, Figures.Stretch stretch) {
        String word = stretch.ability()
                .map(Ability::key)
                .map(key -> look.text("word." + key))
                .orElse("");
        return stretch.what().isEmpty()
                ? List.of(word)
                : List.of(word + " \u00b7 " + SceneEdits.name(run.scene(), stretch.what()), word);
    }

    private void paintPlot(Graphics2D g, Run run) {
        double bottom = getHeight() - look.px(8);
        double top = plotTop + look.px(18);
        if (bottom - top < look.px(12)) {
            return;
        }
        double most = Math.max(1e-9, Figures.energy(run));
        Path2D line = new Path2D.Double();
        line.moveTo(xAt(0), bottom);
        for (Run.Leg leg : run.legs()) {
            line.lineTo(xAt(leg.begin()), y(Figures.energyUntil(run, leg.begin()), most, top, bottom));
            line.lineTo(xAt(leg.end()), y(Figures.energyUntil(run, leg.end()), most, top, bottom));
        }
        Path2D area = new Path2D.Double(line);
        area.lineTo(line.getCurrentPoint().getX(), bottom);
        area.closePath();
        g.setColor(look.theme().color(Tone.ACCENT, 0.13));
        g.fill(area);
        g.setColor(look.color(Tone.LINE));
        g.setStroke(Theme.line(1));
        g.draw(new Line2D.Double(side, bottom, side + width(), bottom));
        g.setColor(look.color(Tone.ACCENT));
        g.setStroke(Theme.line(look.px(1.8)));
        g.draw(line);
        g.setColor(look.color(Tone.DIM));
        g.drawString(look.text("plot.energy"), side, plotTop + look.px(10));
        String total = Texts.number(most, 1);
        g.drawString(total, (float) (side + width() - g.getFontMetrics().stringWidth(total)), plotTop + look.px(10));
    }

    private static double y(double energy, double most, double top, double bottom) {
        return bottom - energy / most * (bottom - top);
    }

    private void paintHead(Graphics2D g) {
        double x = xAt(session.playback().time());
        head = x;
        double knob = look.px(8);
        double ring = look.px(12);
        g.setColor(look.color(Tone.TEXT));
        g.setStroke(Theme.line(1.4f));
        g.draw(new Line2D.Double(x, barTop - 4, x, getHeight() - 4.0));
        g.fill(new Ellipse2D.Double(x - knob / 2, barTop - knob, knob, knob));
        if (isFocusOwner()) {
            g.setColor(look.color(Tone.ACCENT));
            g.draw(new Ellipse2D.Double(x - ring / 2, barTop - (knob + ring) / 2, ring, ring));
        }
    }
}
