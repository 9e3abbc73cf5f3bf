package troupe.app.panel.inspector;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GridBagLayout;
import java.util.Optional;
import java.util.StringJoiner;
import javax.swing.JLabel;
import troupe.app.look.Drawn;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.panel.Panel;
import troupe.app.panel.Rows;
import troupe.app.play.Foresight;
import troupe.app.session.RunViews;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.paint.picture.StripPainter;
import troupe.run.Run;
import troupe.run.view.Strip;
import troupe.scene.Encounter;

/**
 * Shows whom the actor of an encounter may meet on its plan, and how soon, at the moment shown: a strip of greys for
 * each of those who are likeliest. Not to be seen for other tasks.
 */
final class ForesightSection extends Panel {
    private static final int MOST = 6;

    private final transient Foresight foresight;
    private final Strips strips = new Strips();
    private final JLabel more;
    private transient Optional<Run> asked = Optional.empty();
    private double askedTime;

    ForesightSection(Look look, Session session) {
        super(look, session, new GridBagLayout());
        setName("foresight");
        foresight = new Foresight(EventQueue::invokeLater, this::take);
        observing(foresight::close);
        Rows rows = new Rows(this, look);
        rows.heading(look.text("inspector.foresight"));
        more = look.label("", Tone.DIM);
        more.setName("foresight.more");
        rows.wide(strips, 4);
        rows.wide(more, 2);
        setVisible(false);
        observing(session.plans().add(plan -> refresh()));
        observing(session.playback().listeners().add(playback -> refresh()));
        refresh();
    }

    private void refresh() {
        boolean meets = session().plan().flatMap(RunViews::task).orElse(null) instanceof Encounter encounter
                && !encounter.avatars().isEmpty();
        Optional<Run> run = session().run().filter(r -> meets && r.frames().count() > 0);
        setVisible(run.isPresent());
        double time = session().playback().time();
        if (run.isEmpty()) {
            asked = run;
            take(Optional.empty());
        } else if (!(run.equals(asked) && time == askedTime)) {
            asked = run;
            askedTime = time;
            foresight.request(run.get(), time);
        }
    }

    private void take(Optional<Strip> newest) {
        Optional<Strip> made = newest.filter(strip -> asked.isPresent());
        Optional<Strip> shown = made.map(strip -> strip.greatest(MOST));
        int all = made.map(strip -> strip.rows().size()).orElse(0);
        int rows = shown.map(strip -> strip.rows().size()).orElse(0);
        String text = all == 0
                ? look().text("foresight.nobody")
                : all > rows ? look().texts().format("foresight.more", all - rows) : "";
        if (!text.equals(more.getText())) {
            more.setText(text);
        }
        strips.show(shown.filter(strip -> !strip.rows().isEmpty()));
    }

    @Override
    public Dimension getMaximumSize() {
        return new Dimension(Integer.MAX_VALUE, getPreferredSize().height);
    }

    /** Paints the strips as wide as there is room. */
    private final class Strips extends Drawn {
        private transient Optional<StripPainter> painter = Optional.empty();

        private Strips() {
            setName("foresight.strips");
            Look.sized(this, 100, 1);
        }

        private void show(Optional<Strip> strip) {
            int before = height();
            painter = strip.map(s -> new StripPainter(s, look().theme()));
            if (height() != before) {
                Look.sized(this, 100, Math.max(1, height()));
                ForesightSection.this.revalidate();
            }
            getAccessibleContext().setAccessibleName(strip.map(this::said).orElse(look().text("foresight.nobody")));
            repaint();
        }

        private int height() {
            return painter.map(StripPainter::height).orElse(0);
        }

        private String said(Strip strip) {
            StringJoiner said = new StringJoiner("; ");
            for (int row = 0; row < strip.rows().size(); row++) {
                double[] values = strip.rows().get(row);
                double most = strip.most(row);
                int at = 0;
                while (at + 1 < values.length && values[at] != most) {
                    at++;
                }
                said.add(look().texts()
                        .format(
                                "foresight.row",
                                strip.names().get(row),
                                Texts.number(100 * most, 0),
                                Texts.number(at * strip.step(), 1)));
            }
            return said.toString();
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            Graphics2D g = (Graphics2D) graphics.create();
            g.scale(look().scale(), look().scale());
            painter.ifPresent(p -> p.paint(g, (int) (getWidth() / look().scale())));
            g.dispose();
        }
    }
}
