package troupe.app.panel.timeline;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.List;
import java.util.Locale;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import troupe.app.look.Icons;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.look.widget.FlatButton;
import troupe.app.panel.Panel;
import troupe.app.play.Figures;
import troupe.app.play.Playback;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;

/** Plays the run: buttons, clock, and the timeline with its plot. */
public final class TimelinePanel extends Panel {
    private static final int HEIGHT = 168;
    private static final int CONTROLS = 236;

    private final JLabel clock = new JLabel();
    private final JLabel length = new JLabel();
    private final JLabel doing = new JLabel();
    private final FlatButton speed;

    /** Makes the timeline; {@code transport} are the commands first, back, play, forward, loop. */
    public TimelinePanel(Look look, Session session, List<Action> transport) {
        super(look, session, new BorderLayout(16, 0));
        setName("timeline");
        setBorder(BorderFactory.createCompoundBorder(
                look.line(1, 0, 0, 0), BorderFactory.createEmptyBorder(9, 16, 6, 16)));
        setPreferredSize(new Dimension(100, HEIGHT));
        setMinimumSize(new Dimension(100, 96));
        speed = new FlatButton(look, FlatButton.Style.PILL);
        add(controls(transport), BorderLayout.WEST);
        add(new TimelineView(look, session, this::observing), BorderLayout.CENTER);
        observing(session.playback().listeners().add(p -> refresh()));
        observing(session.plans().add(p -> refresh()));
        refresh();
    }

    private JPanel controls(List<Action> transport) {
        JPanel buttons = line(4);
        for (Action action : transport) {
            FlatButton button = new FlatButton(look(), FlatButton.Style.ICON, action);
            button.setName("transport." + action.getValue(Action.ACTION_COMMAND_KEY));
            buttons.add(Look.sized(button, 30, 30));
        }
        speed.setName("transport.speed");
        speed.setToolTipText(look().text("speed.hint"));
        speed.addActionListener(e -> chooseSpeed());
        buttons.add(Box.createHorizontalStrut(2));
        buttons.add(speed);
        clock.setFont(look().bold(20));
        clock.setForeground(look().color(Tone.TEXT));
        length.setFont(look().font());
        length.setForeground(look().color(Tone.DIM));
        doing.setFont(look().font());
        doing.setForeground(look().color(Tone.DIM));
        JPanel times = line(8);
        times.add(clock);
        times.add(length);
        JPanel line = line(8);
        line.add(doing);
        JPanel all = new JPanel();
        all.setLayout(new BoxLayout(all, BoxLayout.Y_AXIS));
        all.setOpaque(false);
        all.add(buttons);
        all.add(Box.createVerticalStrut(6));
        all.add(times);
        all.add(Box.createVerticalStrut(2));
        all.add(line);
        all.add(Box.createVerticalGlue());
        for (JPanel part : List.of(buttons, times, line)) {
            part.setAlignmentX(LEFT_ALIGNMENT);
        }
        all.setPreferredSize(new Dimension(CONTROLS, 100));
        return all;
    }

    /** Makes a line as wide as the panel and no higher than it needs to be. */
    private static JPanel line(int gap) {
        JPanel line = new JPanel(new FlowLayout(FlowLayout.LEFT, gap, 0)) {
            @Override
            public Dimension getMaximumSize() {
                return new Dimension(Short.MAX_VALUE, getPreferredSize().height);
            }
        };
        line.setOpaque(false);
        return line;
    }

    private void chooseSpeed() {
        speed.setSelected(false);
        JPopupMenu menu = new JPopupMenu();
        for (double factor : Playback.speeds()) {
            JMenuItem item = new JMenuItem(word(factor));
            item.addActionListener(e -> session().playback().setSpeed(factor));
            menu.add(item);
        }
        menu.show(speed, 0, -menu.getPreferredSize().height - 4);
    }

    private static String word(double factor) {
        String number =
                factor == Math.rint(factor) ? String.format(Locale.ROOT, "%.0f", factor) : String.valueOf(factor);
        return number + "\u00d7";
    }

    private void refresh() {
        Playback playback = session().playback();
        clock.setText(time(playback.time()));
        length.setText(look().texts().format("clock.of", time(playback.duration())));
        speed.setText(word(playback.speed()));
        doing.setText(session().run().map(run -> doing(run, playback.time())).orElse(look().text("clock.nothing")));
    }

    private String doing(Run run, double time) {
        if (run.scene().task(run.task()).orElse(null) instanceof Crowd crowd) {
            int people = crowd.allGroups()
                    .flatMap(group -> group.members().stream())
                    .mapToInt(CrowdGroup.Members::count)
                    .sum();
            return look().texts().format("clock.people", people);
        }
        return Figures.legAt(run, time)
                .map(leg -> {
                    String word = Figures.ability(leg.ability())
                            .map(Ability::key)
                            .map(key -> look().text("doing." + key))
                            .orElse(leg.ability());
                    double energy = Figures.energyUntil(run, time);
                    return look().texts().format("clock.doing", word, Texts.number(energy, 1));
                })
                .orElseGet(() -> look().text(run.frames().count() > 0 ? "clock.simulated" : "clock.nothing"));
    }

    private static String time(double seconds) {
        // by hand: it is told with every frame, and a format takes as long as painting much of the window
        int minutes = (int) (seconds / 60);
        int hundredths = (int) Math.floor((seconds - 60.0 * minutes) * 100);
        return twoDigits(minutes) + ":" + twoDigits(hundredths / 100) + "." + twoDigits(hundredths % 100);
    }

    private static String twoDigits(int number) {
        return number < 10 ? "0" + number : String.valueOf(number);
    }

    /** Returns the icon of the command that plays or stops. */
    public static Icons icon(boolean playing) {
        return playing ? Icons.PAUSE : Icons.PLAY;
    }
}
