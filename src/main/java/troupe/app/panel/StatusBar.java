package troupe.app.panel;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import troupe.app.document.SceneDocument;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.look.widget.FlatButton;
import troupe.app.plan.Plan;
import troupe.app.plan.Work;
import troupe.app.play.Figures;
import troupe.app.session.Notice;
import troupe.app.session.RunViews;
import troupe.app.session.Session;
import troupe.geometry.Point;
import troupe.paint.Tone;
import troupe.run.Report;
import troupe.run.Run;
import troupe.scene.Crowd;

/** Says what happened, what the mouse would do now, and what is under the pointer. */
public final class StatusBar extends Panel {
    private static final int PATIENCE_MS = 250;
    private static final Set<String> PLACE = Set.of("class", "clearance", "elevation");

    private final Dot dot = new Dot();
    private final JLabel happened = new JLabel();
    private final JLabel details = new JLabel();
    private final JLabel hint = new JLabel("", JLabel.CENTER);
    private final JLabel position = new JLabel();
    private final JLabel values = new JLabel();
    private final JLabel zoom = new JLabel();
    private final Gauge gauge = new Gauge();
    private final FlatButton cancel;
    private final transient Timer patience;
    private Tone state = Tone.DIM;
    private String hinted = "";
    private boolean working;
    private transient Optional<Point> pointer = Optional.empty();

    /** Makes the status bar. */
    public StatusBar(Look look, Session session) {
        super(look, session, new BorderLayout(18, 0));
        setName("status");
        setBorder(BorderFactory.createCompoundBorder(
                look.line(1, 0, 0, 0), BorderFactory.createEmptyBorder(0, 14, 0, 14)));
        setPreferredSize(new Dimension(100, 27));
        cancel = new FlatButton(look, FlatButton.Style.PILL);
        cancel.setName("status.cancel");
        cancel.setText(look.text("status.cancel"));
        cancel.addActionListener(e -> {
            cancel.setSelected(false);
            session.planner().cancel();
        });
        Look.sized(cancel, (int) Math.ceil(cancel.getPreferredSize().width / look.scale()), 20);
        patience = new Timer(PATIENCE_MS, e -> showWork(true));
        patience.setRepeats(false);
        build();
        observing(session.plans().add(this::show));
        observing(session.planner().works().add(this::show));
        observing(session.notices().add(this::show));
        observing(session.document().listeners().add(change -> {
            if (change == SceneDocument.Change.OPENED) {
                state = Tone.DIM;
                happened(look.text("status.ready"), "");
            }
        }));
        session.plan().ifPresentOrElse(this::show, () -> happened(look.text("status.ready"), ""));
    }

    private void build() {
        for (JLabel label : List.of(happened, details, hint, position, values, zoom)) {
            label.setFont(look().font());
            label.setForeground(look().color(Tone.DIM));
        }
        happened.setForeground(look().color(Tone.TEXT));
        happened.setName("status.happened");
        position.setForeground(look().color(Tone.TEXT));
        position.setName("status.position");
        values.setName("status.values");
        hint.setName("status.hint");
        hint.setMinimumSize(new Dimension(0, 20));
        JPanel left = line();
        left.add(dot);
        left.add(happened);
        left.add(Box.createHorizontalStrut(6));
        left.add(details);
        left.add(gauge);
        left.add(Box.createHorizontalStrut(8));
        left.add(cancel);
        JPanel right = line();
        right.add(position);
        right.add(Box.createHorizontalStrut(14));
        right.add(values);
        right.add(Box.createHorizontalStrut(14));
        right.add(zoom);
        add(left, BorderLayout.WEST);
        add(hint, BorderLayout.CENTER);
        add(right, BorderLayout.EAST);
        showWork(false);
    }

    private static JPanel line() {
        JPanel line = new JPanel();
        line.setLayout(new BoxLayout(line, BoxLayout.X_AXIS));
        line.setOpaque(false);
        return line;
    }

    /** Says what the mouse would do now; nothing where there is no room for all of it. */
    public void hint(String text) {
        hinted = text;
        hint.setToolTipText(text);
        revalidate();
    }

    /** {@inheritDoc} Where there is little room, the details give way first, then what the mouse would do. */
    @Override
    public void doLayout() {
        Insets around = getInsets();
        int room = getWidth() - around.left - around.right - 2 * ((BorderLayout) getLayout()).getHgap();
        details.setPreferredSize(null);
        int told = hint.getFontMetrics(hint.getFont()).stringWidth(hinted) + 1;
        int taken = line(details) + line(position);
        if (taken + told > room) {
            taken -= details.getPreferredSize().width;
            details.setPreferredSize(new Dimension(0, details.getPreferredSize().height));
        }
        hint.setText(taken + told > room ? "" : hinted);
        super.doLayout();
    }

    private static int line(Component part) {
        part.getParent().invalidate();
        return part.getParent().getPreferredSize().width;
    }

    /** Says how many pixels a metre has, as a share of what fits the window. */
    public void zoom(double share) {
        zoom.setText(Math.round(share * 100) + " %");
    }

    /** Says what is under the pointer, empty when it is elsewhere. */
    public void pointAt(Optional<Point> place) {
        pointer = place;
        position.setText(place.map(p -> "x " + Texts.number(p.x(), 2) + "  y " + Texts.number(p.y(), 2))
                .orElse(""));
        values.setText(place.flatMap(p -> session().plan().map(plan -> values(plan, p)))
                .orElse(""));
    }

    private String values(Plan plan, Point place) {
        return PointerReadout.at(plan, place, session().overlays(), look().texts()).stream()
                .filter(v -> PLACE.contains(v.key()) || session().overlays().shows(v.key()))
                .map(v -> v.key().equals("class") ? v.text() : name(v.key()) + " " + v.text())
                .collect(Collectors.joining("   "));
    }

    private String name(String key) {
        return look().texts().get("value." + key, key);
    }

    private void show(Work work) {
        gauge.share = work.share();
        gauge.repaint();
        if (!work.planning()) {
            patience.stop();
            showWork(false);
            if (working) {
                session().plan().ifPresentOrElse(this::show, () -> happened(look().text("outcome.cancelled"), ""));
            }
        } else if (!patience.isRunning() && !cancel.isVisible()) {
            patience.restart();
        }
    }

    private void showWork(boolean on) {
        gauge.setVisible(on);
        cancel.setVisible(on);
        details.setVisible(!on);
        if (on) {
            boolean simulates = session()
                    .plan()
                    .filter(plan -> !RunViews.keys(plan).isEmpty())
                    .isPresent();
            happened(look().text(simulates ? "status.simulates" : "status.planning"), "");
            state = Tone.ACCENT;
            working = true;
        }
        dot.repaint();
    }

    private void show(Notice notice) {
        state = notice.wrong() ? Tone.MOVE : Tone.SKELETON;
        happened(look().texts().tell(notice.text()), "");
    }

    private void show(Plan plan) {
        if (plan.run().isEmpty()) {
            boolean wrong = PlanWords.errors(plan) > 0;
            state = wrong ? Tone.MOVE : Tone.DIM;
            happened(wrong ? PlanWords.firstError(plan, look().texts()) : look().text("status.notask"), "");
        } else {
            show(plan, plan.run().get());
        }
        pointAt(pointer);
    }

    private void show(Plan plan, Run run) {
        if (run.outcome().isRunning()) {
            if (cancel.isVisible()) {
                happened.setText(look().text("status.simulates"));
            } else {
                state = Tone.ACCENT;
                happened(
                        look().texts()
                                .format(
                                        "status.simulating",
                                        Texts.number(run.frames().duration(), 1)),
                        "");
            }
            return;
        }
        boolean found = run.outcome().isFound();
        state = found ? Tone.SKELETON : Tone.MOVE;
        List<String> ended = PlanWords.encounter(run, look().texts());
        if (!ended.isEmpty()) {
            String rest = String.join(" \u00b7 ", ended.subList(1, ended.size()));
            happened(ended.get(0), rest.isEmpty() ? "" : "\u00b7 " + rest);
            details.setToolTipText(null);
            return;
        }
        String millis = Texts.number(plan.millis(), plan.millis() < 10 ? 1 : 0);
        boolean simulated = run.scene().task(run.task()).orElse(null) instanceof Crowd;
        String text = found
                ? look().texts()
                        .format(
                                simulated ? "status.simulated" : "status.planned",
                                simulated ? Texts.number(plan.millis() / 1000, 1) : millis)
                : PlanWords.outcome(run, look().texts());
        List<String> more = new ArrayList<>();
        if (found && run.report().values().get("expanded") instanceof Long expanded) {
            more.add(look().texts().format("status.expanded", expanded));
        }
        List<Figures.Move> moves = Figures.moves(run);
        double metres = moves.stream().mapToDouble(Figures.Move::metres).sum();
        if (found && metres > 0) {
            more.add(look().texts().format("status.moved", moves.size(), Texts.number(metres, 1)));
        }
        int shown = Math.min(2, more.size());
        if (found && run.report().values().get("times_ms") instanceof Report times) {
            times.values().forEach((stage, ms) -> {
                if (ms instanceof Double d && d >= 0.05) {
                    more.add(look().texts().get("stage." + stage, stage) + " " + Texts.number(d, 1));
                }
            });
        }
        happened(text, shown == 0 ? "" : "\u00b7 " + String.join(" \u00b7 ", more.subList(0, shown)));
        details.setToolTipText(more.isEmpty() ? null : String.join(" \u00b7 ", more));
    }

    private void happened(String text, String more) {
        working = false;
        happened.setText(text);
        happened.setToolTipText(text);
        details.setText(more);
        dot.repaint();
    }

    /** A dot in the colour of how things stand. */
    private final class Dot extends Drawn {
        private Dot() {
            Look.sized(this, 14, 12);
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            Graphics2D g = Look.smooth(graphics);
            g.setColor(look().color(state));
            g.fillOval(look().px(1), look().px(2), look().px(8), look().px(8));
            g.dispose();
        }
    }

    /** How far the work has come; a plain bar where that is not known. */
    private final class Gauge extends Drawn {
        private double share = Double.NaN;

        private Gauge() {
            Look.sized(this, 120, 14);
            setName("status.progress");
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            Graphics2D g = Look.smooth(graphics);
            int thick = look().px(4);
            int y = (getHeight() - thick) / 2;
            g.setColor(look().color(Tone.LINE));
            g.fillRoundRect(0, y, getWidth(), thick, thick, thick);
            g.setColor(look().color(Tone.ACCENT));
            int width = Double.isNaN(share) ? getWidth() / 3 : (int) (getWidth() * share);
            g.fillRoundRect(0, y, width, thick, thick, thick);
            g.dispose();
        }
    }
}
