package troupe.app.panel.inspector;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GridBagLayout;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.app.look.Prose;
import troupe.app.look.Texts;
import troupe.app.panel.Panel;
import troupe.app.panel.PlanWords;
import troupe.app.panel.Rows;
import troupe.app.plan.Plan;
import troupe.app.play.Figures;
import troupe.app.session.RunViews;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Journey;
import troupe.search.Outcome;
import troupe.work.explain.Explanation;
import troupe.work.explain.Route;

/** Explains the plan: its energy by ability as a bar, what it would be without an ability, and what would change it. */
final class WhySection extends Panel {

    WhySection(Look look, Session session) {
        super(look, session, new GridBagLayout());
        setName("why");
        observing(session.plans().add(p -> refresh()));
        observing(session.document().listeners().add(c -> {
            if (session.plan().isEmpty()) {
                refresh();
            }
        }));
        refresh();
    }

    private void refresh() {
        setVisible(
                session().plan().filter(plan -> !RunViews.keys(plan).isEmpty()).isEmpty());
        if (!isVisible()) {
            return;
        }
        Rows rows = new Rows(this, look());
        Optional<Run> run = session().run();
        boolean found = run.isEmpty() || run.get().outcome().isFound();
        boolean infeasible =
                run.filter(r -> r.outcome() instanceof Outcome.Infeasible).isPresent();
        boolean simulated = run.filter(r -> !(r.scene().task(r.task()).orElse(null) instanceof Journey))
                .isPresent();
        setVisible(!simulated || infeasible);
        Optional<Plan> unplanned = session().plan().filter(plan -> plan.run().isEmpty());
        boolean wrong = unplanned.isPresent() && PlanWords.errors(unplanned.get()) > 0;
        rows.heading(look().text(wrong ? "inspector.wrong" : found ? "inspector.why" : "inspector.why.not"));
        if (wrong) {
            rows.wide(new Note(PlanWords.allErrors(unplanned.get(), look().texts())), 0);
        } else if (run.isEmpty()) {
            rows.wide(look().label(look().text(unplanned.isPresent() ? "status.notask" : "why.nothing"), Tone.DIM), 0);
        } else if (!found) {
            rows.wide(new Note(PlanWords.outcome(run.get(), look().texts())), 0);
        } else {
            rows.wide(new EnergyBar(Figures.energyByAbility(run.get())), 9);
            rows.wide(new Table(table(run.get())), 9);
            Optional<Explanation> why = session().plan().flatMap(Plan::why);
            String sentences = PlanWords.moves(run.get(), look().texts())
                    + why.map(e -> PlanWords.flips(e, look().texts()))
                            .filter(flips -> !flips.isEmpty())
                            .map(flips -> "\n" + flips)
                            .orElse("");
            if (!sentences.isEmpty()) {
                rows.wide(new Note(sentences.strip()), 0);
            }
        }
        revalidate();
        repaint();
    }

    /** One line: what, energy, length. */
    private record Line(String what, String energy, String length, boolean strong) {}

    private List<Line> table(Run run) {
        List<Line> lines = new ArrayList<>();
        lines.add(line(look().text("why.this"), run, true));
        List<Route> without =
                session().plan().flatMap(Plan::why).map(Explanation::without).orElse(List.of());
        for (Route route : without) {
            String name = name(route.without());
            if (route.isFound()) {
                lines.add(line(name, route.run(), false));
            } else {
                lines.add(new Line(name, look().text("why.no"), "", false));
            }
        }
        return lines;
    }

    private String name(Set<Ability> without) {
        return without.size() == 1
                ? look().text("why.without." + without.iterator().next().key())
                : look().text("why.walking");
    }

    private static Line line(String what, Run run, boolean strong) {
        return new Line(
                what, Texts.number(Figures.energy(run), 1) + " J", Texts.number(Figures.length(run), 1) + " m", strong);
    }

    @Override
    public Dimension getMaximumSize() {
        return new Dimension(Integer.MAX_VALUE, getPreferredSize().height);
    }

    /** The energy by ability. */
    private final class EnergyBar extends Drawn {
        private final double[] energy;

        private EnergyBar(double[] energy) {
            this.energy = energy;
            setName("why.bar");
            setPreferredSize(new Dimension(100, 18));
            StringBuilder text = new StringBuilder();
            for (Ability ability : Ability.values()) {
                double joules = energy[ability.ordinal()];
                if (joules > 0) {
                    text.append(text.length() == 0 ? "" : ", ")
                            .append(look().text("word." + ability.key()))
                            .append(' ')
                            .append(Texts.number(joules, 1))
                            .append(" J");
                }
            }
            setToolTipText(text.toString());
            getAccessibleContext().setAccessibleName(text.toString());
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            Graphics2D g = Look.smooth(graphics);
            double sum = 0;
            for (double part : energy) {
                sum += part;
            }
            g.clip(new RoundRectangle2D.Double(0, 0, getWidth(), getHeight(), 10, 10));
            double x = 0;
            for (Ability ability : Ability.values()) {
                double width = sum <= 0 ? 0 : energy[ability.ordinal()] / sum * getWidth();
                g.setColor(look().theme().color(ability));
                g.fill(new Rectangle2D.Double(x, 0, width, getHeight()));
                x += width;
            }
            g.dispose();
        }
    }

    /** Lines in three columns. */
    private final class Table extends Drawn {
        private static final int ROW = 21;
        private static final int LENGTH = 52;
        private final transient List<Line> lines;

        private Table(List<Line> lines) {
            this.lines = lines;
            setName("why.table");
            setPreferredSize(new Dimension(100, ROW * lines.size()));
            getAccessibleContext()
                    .setAccessibleName(lines.stream()
                            .map(l -> look().texts()
                                    .format("why.row", l.what(), l.energy(), l.length())
                                    .strip())
                            .collect(Collectors.joining(", ")));
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            Graphics2D g = Look.smooth(graphics);
            for (int i = 0; i < lines.size(); i++) {
                Line line = lines.get(i);
                g.setFont(line.strong() ? look().bold() : look().font());
                FontMetrics metrics = g.getFontMetrics();
                int base = i * look().px(ROW) + look().px(14);
                g.setColor(look().color(Tone.TEXT));
                g.drawString(line.what(), 0, base);
                boolean way = !line.length().isEmpty();
                g.setColor(look().color(way ? Tone.TEXT : Tone.DIM));
                int right = getWidth() - (way ? look().px(LENGTH) : 0);
                g.drawString(line.energy(), right - metrics.stringWidth(line.energy()), base);
                g.setFont(look().font());
                g.setColor(look().color(Tone.DIM));
                g.drawString(line.length(), getWidth() - g.getFontMetrics().stringWidth(line.length()), base);
            }
            g.dispose();
        }
    }

    /** A text on a soft card, broken into lines. */
    private final class Note extends Prose {
        private Note(String text) {
            super(look(), text);
            setName("why.note");
            getAccessibleContext().setAccessibleName(look().text("inspector.why"));
            setBorder(javax.swing.BorderFactory.createEmptyBorder(8, 10, 8, 10));
        }
    }
}
