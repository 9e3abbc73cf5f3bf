package troupe.app.panel;

import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.IntConsumer;
import javax.swing.AbstractAction;
import javax.swing.JList;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import troupe.app.document.SceneDocument;
import troupe.app.look.Look;
import troupe.app.look.widget.FlatButton;
import troupe.app.look.widget.ThinScrollBarUI;
import troupe.app.plan.Plan;
import troupe.app.plan.Views;
import troupe.app.session.OverlayChoice;
import troupe.app.session.RunViews;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.run.view.Aspect;

/**
 * Lets a person choose of what the views are, such as the search space or the heading: a button for each
 * aspect of the task, while it offers more than one thing and one of the views that it changes is shown.
 */
public final class AspectBar extends Panel {
    private static final int GAP = 6;
    private static final int ROWS = 12;
    private static final int ROOM = 150;

    private transient List<Aspect> aspects = List.of();
    private transient List<Aspect> ofRun = List.of();
    private transient List<Object> built = List.of();

    /** Makes the bar. */
    public AspectBar(Look look, Session session) {
        super(look, session, new FlowLayout(FlowLayout.RIGHT, GAP, 0));
        setName("aspects");
        setOpaque(false);
        observing(session.plans().add(plan -> refresh()));
        observing(session.document().listeners().add(change -> {
            if (change == SceneDocument.Change.OPENED) {
                aspects = List.of();
                refresh();
            }
        }));
        observing(session.overlays().listeners().add(choice -> build()));
        refresh();
    }

    private void refresh() {
        Views views = session().plan().map(Plan::views).orElse(Views.NONE);
        boolean working = views.overlays().isEmpty() && session().plan().isPresent();
        aspects = working ? aspects : views.aspects();
        ofRun = session().plan().map(RunViews::aspects).orElse(List.of());
        if (!choices().equals(built)) {
            build();
        }
    }

    /** Returns all that the buttons depend on but which views are shown. */
    private List<Object> choices() {
        OverlayChoice shown = session().overlays();
        List<Integer> picked =
                ofRun.stream().map(aspect -> shown.picked(aspect.key())).toList();
        return List.of(aspects, ofRun, shown.chosen(), picked);
    }

    private void build() {
        built = choices();
        removeAll();
        List<Integer> chosen = session().overlays().chosen();
        for (int i = 0; i < aspects.size(); i++) {
            int index = i;
            if (offered(aspects.get(i)) && !replaced(aspects.get(i))) {
                int choice = aspects.get(i).chosen(chosen, i);
                add(button(aspects.get(i), choice, c -> session().overlays().choose(index, c)));
            }
        }
        for (Aspect aspect : ofRun) {
            if (offered(aspect)) {
                int choice = aspect.chosen(List.of(session().overlays().picked(aspect.key())), 0);
                add(button(aspect, choice, c -> session().overlays().pick(aspect.key(), c)));
            }
        }
        setVisible(getComponentCount() > 0);
        revalidate();
        repaint();
    }

    /** Tells whether what an aspect changes is shown for each moment instead, with a choice of its own. */
    private boolean replaced(Aspect aspect) {
        return !aspect.views().isEmpty()
                && session()
                        .plan()
                        .filter(plan -> aspect.views().stream().allMatch(key -> RunViews.replaces(plan, key)))
                        .isPresent();
    }

    private boolean offered(Aspect aspect) {
        OverlayChoice shown = session().overlays();
        return aspect.choices().size() > 1
                && (aspect.views().isEmpty() || aspect.views().stream().anyMatch(shown::shows));
    }

    private FlatButton button(Aspect aspect, int choice, IntConsumer chooser) {
        FlatButton button = new FlatButton(look(), FlatButton.Style.CHIP);
        String name = look().texts().get("aspect." + aspect.key(), aspect.key());
        String text = texts(aspect).get(choice);
        button.setName("aspect." + aspect.key());
        button.setText(name + ": " + Ellipsis.fit(text, button.getFontMetrics(button.getFont()), look().px(ROOM)));
        button.setHint("\u25be");
        button.setToolTipText(text);
        button.getAccessibleContext().setAccessibleName(name + ": " + text);
        button.addActionListener(e -> {
            button.setSelected(false);
            offer(button, aspect, choice, chooser);
        });
        return button;
    }

    /** Returns a choice in the studio's language, or as the planner says it. */
    private String text(Aspect.Choice choice) {
        String key = "choice." + choice.word();
        return look().texts().get(key, "").isEmpty()
                ? choice.text()
                : look().texts().format(key, String.join(", ", choice.what()));
    }

    /** Returns the choices of an aspect; those that would read the same are told apart by their numbers. */
    private List<String> texts(Aspect aspect) {
        List<String> plain = aspect.choices().stream().map(this::text).toList();
        List<String> texts = new ArrayList<>();
        for (String text : plain) {
            boolean shared = Collections.frequency(plain, text) > 1;
            texts.add(shared ? (texts.size() + 1) + ": " + text : text);
        }
        return texts;
    }

    /** Opens the list of what there is to choose from; a click or Enter chooses, Escape does not. */
    private void offer(FlatButton button, Aspect aspect, int choice, IntConsumer chooser) {
        JList<String> list = new JList<>(texts(aspect).toArray(String[]::new));
        list.setName("choices." + aspect.key());
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setSelectedIndex(choice);
        list.setVisibleRowCount(Math.min(ROWS, aspect.choices().size()));
        list.setFont(look().font());
        list.setForeground(look().color(Tone.TEXT));
        list.setBackground(look().color(Tone.PANEL));
        list.setSelectionBackground(look().selected());
        list.setSelectionForeground(look().color(Tone.TEXT));
        list.getAccessibleContext().setAccessibleName(look().texts().get("aspect." + aspect.key(), aspect.key()));
        JScrollPane scroll = ThinScrollBarUI.scroll(list, look());
        scroll.setBorder(javax.swing.BorderFactory.createEmptyBorder(4, 6, 4, 6));
        JPopupMenu menu = new JPopupMenu();
        menu.add(scroll);
        Runnable choose = () -> {
            menu.setVisible(false);
            if (list.getSelectedIndex() >= 0) {
                chooser.accept(list.getSelectedIndex());
            }
        };
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseReleased(MouseEvent event) {
                choose.run();
            }
        });
        list.getInputMap().put(KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0), "choose");
        list.getActionMap().put("choose", new AbstractAction() {
            @Override
            public void actionPerformed(java.awt.event.ActionEvent event) {
                choose.run();
            }
        });
        Dimension wanted = menu.getPreferredSize();
        menu.show(button, Math.min(0, button.getWidth() - wanted.width), button.getHeight() + 4);
        list.ensureIndexIsVisible(choice);
        list.requestFocusInWindow();
    }
}
