package troupe.app.panel.inspector;

import java.awt.Color;
import java.awt.Container;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.GridBagLayout;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import troupe.app.document.SceneEdits;
import troupe.app.look.Look;
import troupe.app.look.Prose;
import troupe.app.look.Texts;
import troupe.app.look.widget.FlatButton;
import troupe.app.panel.Panel;
import troupe.app.panel.Rows;
import troupe.app.problem.Diagnosis;
import troupe.app.problem.Finding;
import troupe.app.problem.Findings;
import troupe.app.problem.Fix;
import troupe.app.session.Session;
import troupe.app.tool.Hits;
import troupe.geometry.Box;
import troupe.paint.Tone;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.work.inspect.Blockage;

/**
 * Lists what is wrong, worst first, with what can be done about it at hand; a click on a text goes there. Not to
 * be seen while nothing is wrong.
 */
public final class ProblemsSection extends Panel {
    private static final int MOST = 6;
    private static final int WIDEST = 228;
    private static final int REST_MS = 600;

    private final transient Diagnosis diagnosis;
    private final transient Consumer<Box> zoom;
    private final Timer later = new Timer(REST_MS, e -> changed());
    private final transient Function<ProblemsSection, Point> pointing;
    private Point pointer;

    /** Makes the list; {@code zoom} shows a part of the scene. */
    public ProblemsSection(Look look, Session session, Diagnosis diagnosis, Consumer<Box> zoom) {
        this(look, session, diagnosis, zoom, ProblemsSection::pointer);
    }

    /** Makes the list; {@code pointing} tells where the pointer is in the panel around it, null if it is elsewhere. */
    ProblemsSection(
            Look look,
            Session session,
            Diagnosis diagnosis,
            Consumer<Box> zoom,
            Function<ProblemsSection, Point> pointing) {
        super(look, session, new GridBagLayout());
        this.pointing = pointing;
        this.diagnosis = diagnosis;
        this.zoom = zoom;
        setName("problems");
        later.setRepeats(false);
        observing(diagnosis.listeners().add(f -> changed()));
        observing(later::stop);
        refresh();
    }

    private static Point pointer(ProblemsSection section) {
        Container panel = SwingUtilities.getAncestorOfClass(InspectorPanel.class, section);
        return panel == null ? null : panel.getMousePosition(true);
    }

    /** Shows what was found; while the pointer is busy in the panel, once it rests: what it is about to press stays. */
    private void changed() {
        Point now = pointing.apply(this);
        boolean busy = now != null && !now.equals(pointer);
        pointer = now;
        if (busy) {
            later.restart();
        } else {
            refresh();
        }
    }

    private void refresh() {
        Findings found = diagnosis.findings();
        Rows rows = new Rows(this, look());
        int count = found.problems().size() + (found.blockage().isPresent() ? 1 : 0);
        setVisible(count > 0);
        rows.heading(look().texts().format("problems.name", count));
        found.blockage().ifPresent(blockage -> addBlockage(rows, found, blockage));
        int shown = 0;
        for (Finding finding : found.problems()) {
            if (shown++ < MOST) {
                add(rows, found, finding);
            }
        }
        if (shown > MOST) {
            rows.wide(look().label(look().texts().format("problems.more", shown - MOST), Tone.DIM), 4);
        }
        revalidate();
        repaint();
    }

    private void add(Rows rows, Findings found, Finding finding) {
        Problem problem = finding.problem();
        Scene scene = session().document().shown();
        String name = problem.element().isEmpty() ? "" : SceneEdits.name(scene, problem.element()) + ": ";
        String cure = problem.cure().isEmpty() ? "" : "\n" + look().texts().tell(problem.cure());
        boolean error = problem.severity() == Severity.ERROR;
        String key = error ? "problems.error" : "problems.warning";
        String text = look().text(key) + " \u2013 " + name + look().texts().tell(problem.message()) + cure;
        rows.wide(
                new Remark(text, look().color(error ? Tone.MOVE : Tone.VAULT), () -> goTo(List.of(problem.element()))),
                4);
        finding.fixes().forEach(fix -> rows.wide(button(found, fix), 4));
    }

    private void addBlockage(Rows rows, Findings found, Blockage blockage) {
        Scene scene = session().document().shown();
        StringBuilder text = new StringBuilder();
        if (!blockage.obstacles().isEmpty()) {
            String names = blockage.obstacles().stream()
                    .map(id -> SceneEdits.name(scene, id))
                    .collect(Collectors.joining(look().text("problems.and")));
            text.append(look().texts().format("problems.blocked", names));
        }
        for (Blockage.Gap gap : blockage.gaps()) {
            text.append(text.length() == 0 ? "" : "\n")
                    .append(look().texts()
                            .format(
                                    "problems.gap",
                                    SceneEdits.name(scene, gap.first()),
                                    SceneEdits.name(scene, gap.second()),
                                    Texts.number(gap.width(), 2),
                                    Texts.number(gap.needed(), 2)));
        }
        Runnable there = blockage.obstacles().isEmpty()
                ? () -> zoom.accept(around(blockage.gaps().get(0)))
                : () -> goTo(blockage.obstacles());
        rows.wide(new Remark(text.toString(), look().color(Tone.MOVE), there), 4);
        if (!found.openings().isEmpty()) {
            rows.wide(look().label(look().text("problems.opens"), Tone.DIM), 4);
        }
        found.openings().forEach(fix -> rows.wide(button(found, fix), 4));
    }

    private static Box around(Blockage.Gap gap) {
        double x = gap.at().x();
        double y = gap.at().y();
        return new Box(x - 1, y - 1, x + 1, y + 1);
    }

    private void goTo(List<String> ids) {
        Scene scene = session().document().shown();
        List<String> there =
                ids.stream().filter(id -> scene.element(id).isPresent()).toList();
        if (!there.isEmpty()) {
            session().selection().set(there);
            scene.element(there.get(0))
                    .flatMap(Hits::outline)
                    .ifPresent(outline -> zoom.accept(outline.bounds().grown(1.5)));
        }
    }

    private FlatButton button(Findings found, Fix fix) {
        FlatButton button = new FlatButton(look(), FlatButton.Style.PILL);
        String text = look().texts().format(fix.key(), fix.what());
        button.setText(text);
        button.setWidest(WIDEST);
        button.setName(fix.key());
        button.addActionListener(e -> {
            button.setSelected(false);
            boolean fresh = found.snapshot().isPresent()
                    && found.snapshot().get().scene() == session().document().scene();
            if (fresh) {
                session().document().commit(text, fix.mended());
            }
        });
        return button;
    }

    @Override
    public Dimension getMaximumSize() {
        return new Dimension(Integer.MAX_VALUE, getPreferredSize().height);
    }

    /** A text on a soft card with a coloured edge, broken into lines; a click, or Enter, goes there. */
    private final class Remark extends Prose {
        private Remark(String text, Color edge, Runnable go) {
            super(look(), text);
            setName("problem");
            setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
            setBorder(BorderFactory.createCompoundBorder(
                    BorderFactory.createMatteBorder(0, 3, 0, 0, edge), BorderFactory.createEmptyBorder(6, 9, 6, 9)));
            addMouseListener(new MouseAdapter() {
                @Override
                public void mouseClicked(MouseEvent event) {
                    go.run();
                }
            });
            getInputMap().put(javax.swing.KeyStroke.getKeyStroke("ENTER"), "go");
            getActionMap().put("go", new javax.swing.AbstractAction() {
                @Override
                public void actionPerformed(java.awt.event.ActionEvent event) {
                    go.run();
                }
            });
        }
    }
}
