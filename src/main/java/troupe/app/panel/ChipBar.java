package troupe.app.panel;

import java.awt.FlowLayout;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JPopupMenu;
import troupe.app.look.Look;
import troupe.app.look.widget.FlatButton;
import troupe.app.plan.Plan;
import troupe.app.session.OverlayChoice;
import troupe.app.session.RunViews;
import troupe.app.session.Session;
import troupe.run.view.Overlay;
import troupe.work.view.MomentViews;

/** A chip for each view that can lie over the scene; those that do not fit are behind the last one. */
public final class ChipBar extends Panel {
    private static final List<String> FIRST = List.of(
            OverlayChoice.PLAN,
            OverlayChoice.TRAILS,
            MomentViews.DENSITY,
            MomentViews.PROBABILITY,
            MomentViews.RISK,
            MomentViews.BEFORE,
            "skeleton",
            "potential",
            "region",
            "class",
            "clearance",
            "effort",
            "triggers",
            "expected-path",
            "instance",
            "layers");
    private static final int GAP = 6;

    private final transient Map<String, FlatButton> chips = new LinkedHashMap<>();
    private final FlatButton more;
    private int shown;

    /** Makes the bar. */
    public ChipBar(Look look, Session session) {
        super(look, session, new FlowLayout(FlowLayout.LEFT, GAP, 0));
        setName("chips");
        setOpaque(false);
        more = new FlatButton(look, FlatButton.Style.CHIP);
        more.setText("\u2026");
        more.setName("chip.more");
        more.setToolTipText(look.text("chips.more"));
        more.addActionListener(e -> showMore());
        observing(session.plans().add(plan -> refresh()));
        observing(session.overlays().listeners().add(choice -> mark()));
        refresh();
    }

    private List<String> keys() {
        List<String> offered = new ArrayList<>(List.of(OverlayChoice.PLAN));
        session().plan().map(RunViews::keys).ifPresent(offered::addAll);
        for (Overlay overlay : session().plan().map(Plan::overlays).orElse(List.of())) {
            if (!offered.contains(overlay.key())) {
                offered.add(overlay.key());
            }
        }
        List<String> sorted = new ArrayList<>(FIRST);
        sorted.retainAll(offered);
        offered.removeAll(sorted);
        sorted.addAll(offered);
        return sorted;
    }

    private void refresh() {
        boolean working = session().plan().map(Plan::overlays).orElse(List.of()).isEmpty();
        List<String> keys = keys();
        if (List.copyOf(chips.keySet()).equals(keys)
                || working && chips.keySet().containsAll(keys)) {
            return;
        }
        chips.clear();
        for (String key : keys) {
            FlatButton chip = new FlatButton(look(), FlatButton.Style.CHIP);
            chip.setText(word(key));
            chip.setName("chip." + key);
            chip.setToolTipText(look().texts().get("overlay." + key + ".hint", word(key)));
            chip.addActionListener(e -> session().overlays().show(key, chip.isSelected()));
            chips.put(key, chip);
        }
        shown = -1;
        mark();
        arrange();
    }

    private String word(String key) {
        return look().texts().get("overlay." + key, key);
    }

    private void mark() {
        chips.forEach((key, chip) -> chip.setSelected(session().overlays().shows(key)));
        more.setSelected(false);
        repaint();
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        arrange();
    }

    /** Puts as many chips into the bar as fit, and the rest behind the last one. */
    private void arrange() {
        int gap = ((FlowLayout) getLayout()).getHgap();
        int room = getWidth() - getInsets().left - getInsets().right - more.getPreferredSize().width - 3 * gap;
        int fit = 0;
        int used = 0;
        for (FlatButton chip : chips.values()) {
            used += chip.getPreferredSize().width + gap;
            if (used > room) {
                break;
            }
            fit++;
        }
        if (fit == shown) {
            return;
        }
        shown = fit;
        removeAll();
        chips.values().stream().limit(fit).forEach(this::add);
        if (fit < chips.size()) {
            add(more);
        }
        revalidate();
        repaint();
    }

    private void showMore() {
        more.setSelected(false);
        JPopupMenu menu = new JPopupMenu();
        chips.keySet().stream().skip(shown).forEach(key -> {
            JCheckBoxMenuItem item =
                    new JCheckBoxMenuItem(word(key), session().overlays().shows(key));
            item.setName("chip." + key);
            item.addActionListener(e -> session().overlays().show(key, item.isSelected()));
            menu.add(item);
        });
        menu.show(more, 0, more.getHeight() + 4);
    }
}
