package troupe.app.panel.inspector;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.GridBagLayout;
import java.awt.KeyboardFocusManager;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;
import troupe.app.document.Parts;
import troupe.app.document.SceneEdits;
import troupe.app.look.Look;
import troupe.app.look.widget.Entry;
import troupe.app.look.widget.FlatButton;
import troupe.app.look.widget.Switch;
import troupe.app.panel.Panel;
import troupe.app.panel.Rows;
import troupe.app.property.Group;
import troupe.app.property.Properties;
import troupe.app.property.Property;
import troupe.app.session.Session;
import troupe.paint.Tone;
import troupe.scene.Scene;

/**
 * Shows and edits the properties of what is selected, those in common where several are, or of the scene where
 * nothing is. A field keeps the focus while its thing changes.
 */
final class PropertiesSection extends Panel {
    private static final String RELATION = "relation.";

    private final transient Map<String, Shown> fields = new LinkedHashMap<>();
    private transient List<?> structure = List.of();
    private transient Scene shown;

    /** A field that shows a property of the elements that are selected. */
    private interface Shown {
        void show(String value);
    }

    PropertiesSection(Look look, Session session) {
        super(look, session, new GridBagLayout());
        setName("properties");
        observing(session.selection().listeners().add(s -> refresh()));
        observing(session.document().listeners().add(c -> refresh()));
        refresh();
    }

    private List<String> ids() {
        Scene scene = session().document().shown();
        return session().selection().ids().stream()
                .filter(id -> Parts.isThere(scene, id))
                .toList();
    }

    private void refresh() {
        Scene scene = session().document().shown();
        List<String> ids = ids();
        if (scene == shown && structure.contains(ids)) {
            return;
        }
        shown = scene;
        List<Group> groups = Properties.of(scene, ids);
        List<?> now = List.of(
                ids,
                heading(scene, ids),
                groups.stream()
                        .map(g -> g.properties().stream()
                                .map(p -> p.key() + p.choices())
                                .toList())
                        .toList());
        if (!now.equals(structure)) {
            structure = now;
            build(scene, ids, groups);
        }
        for (Group group : groups) {
            for (Property property : group.properties()) {
                fields.get(property.key()).show(property.common(scene, ids).orElse(""));
            }
        }
        repaint();
    }

    private String heading(Scene scene, List<String> ids) {
        if (ids.isEmpty()) {
            return scene.title().isEmpty() ? look().text("inspector.scene") : scene.title();
        }
        return ids.size() == 1
                ? SceneEdits.name(scene, ids.get(0))
                : look().texts().format("inspector.several", ids.size());
    }

    private void build(Scene scene, List<String> ids, List<Group> groups) {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        String focused = owner != null && isAncestorOf(owner) ? String.valueOf(owner.getName()) : "";
        fields.clear();
        Rows rows = new Rows(this, look());
        rows.heading(heading(scene, ids));
        if (ids.isEmpty()) {
            String grid = scene.world().cols() + " \u00d7 " + scene.world().rows();
            rows.field(look().text("property.grid"), Look.sized(look().label(grid, Tone.TEXT), 100, 24));
        }
        for (Group group : groups) {
            if (!group.key().isEmpty()) {
                rows.subheading(groupWord(group.key()));
            }
            build(rows, group.properties(), ids);
        }
        revalidate();
        if (!focused.isEmpty()) {
            for (Component group : getComponents()) {
                if (group instanceof JComponent row) {
                    refocus(row, focused);
                }
            }
        }
    }

    private static void refocus(JComponent row, String name) {
        for (Component field : row.getComponents()) {
            if (name.equals(field.getName())) {
                field.requestFocusInWindow();
            }
        }
    }

    /** Adds the rows of a group; neighbours with the same row stand beside each other. */
    private void build(Rows rows, List<Property> properties, List<String> ids) {
        List<JComponent> row = new ArrayList<>();
        for (int i = 0; i < properties.size(); i++) {
            Property property = properties.get(i);
            row.add(field(property, ids));
            boolean last =
                    i + 1 == properties.size() || !properties.get(i + 1).row().equals(property.row());
            if (last) {
                rows.field(word(property.row()), row.toArray(JComponent[]::new));
                row.clear();
            }
        }
    }

    private String groupWord(String key) {
        return key.startsWith(RELATION)
                ? look().texts().format("control.depth", key.substring(RELATION.length()))
                : look().text("group." + key);
    }

    /** Returns the word for a property; weights are called as the sliders that change them while a crowd runs. */
    private String word(String key) {
        String plain = key.substring(key.lastIndexOf('.') + 1);
        return look().texts().get("property." + key, look().texts().get("control." + plain, plain));
    }

    /** Returns the word for one of the values that there are to choose from. */
    private String valueWord(Property property, String value) {
        String key = property.key().replace("setting.", "value.") + ".";
        int open = value.indexOf('(');
        if (open > 0 && value.endsWith(")")) {
            String words = look().texts().get(key + value.substring(0, open), "");
            return words.isEmpty() || value.indexOf(',') > 0
                    ? value
                    : look().texts()
                            .format(key + value.substring(0, open), value.substring(open + 1, value.length() - 1));
        }
        return look().texts()
                .get(key + value, SceneEdits.name(session().document().shown(), value));
    }

    /** Makes the field of a property of elements, those that are selected now even if it is left later. */
    private JComponent field(Property property, List<String> ids) {
        JComponent made = property.isSwitch()
                ? onOff(property, ids)
                : property.choices().isEmpty() ? entry(property, ids) : choice(property, ids);
        made.setName("property." + property.key());
        made.getAccessibleContext().setAccessibleName(word(property.row()));
        return made;
    }

    private Entry entry(Property property, List<String> ids) {
        Entry entry = new Entry(look(), property.unit());
        entry.onText(text -> wrong(property, ids, text), text -> commit(property, ids, text));
        fields.put(property.key(), value -> {
            entry.setAbsent(absent(property, ids));
            entry.showText(value);
        });
        return entry;
    }

    private String absent(Property property, List<String> ids) {
        return ids.size() > 1
                ? look().text("property.mixed")
                : look().texts().get("property." + property.key() + ".none", "");
    }

    private Switch onOff(Property property, List<String> ids) {
        Switch made = new Switch(look());
        made.addActionListener(e -> commit(property, ids, Boolean.toString(made.isSelected())));
        fields.put(property.key(), value -> made.setSelected(Boolean.parseBoolean(value)));
        return made;
    }

    private FlatButton choice(Property property, List<String> ids) {
        FlatButton button = new FlatButton(look(), FlatButton.Style.PILL);
        button.setHint("\u25be");
        Look.sized(button, 60, 24);
        String[] present = {""};
        fields.put(property.key(), value -> {
            present[0] = value;
            button.setText(valueWord(property, value));
        });
        button.addActionListener(e -> {
            button.setSelected(false);
            JPopupMenu menu = new JPopupMenu();
            for (String offered : property.choices()) {
                String name = valueWord(property, offered);
                JRadioButtonMenuItem item = new JRadioButtonMenuItem(name, offered.equals(present[0]));
                item.setName("choice." + offered);
                item.addActionListener(chosen -> commit(property, ids, offered));
                menu.add(item);
            }
            menu.show(button, 0, button.getHeight() + 4);
        });
        return button;
    }

    private Optional<String> wrong(Property property, List<String> ids, String text) {
        return areThere(ids)
                ? property.wrong(session().document().scene(), ids, text).map(look().texts()::tell)
                : Optional.empty();
    }

    /** Tells whether the scene still has what a field is about: its thing may be undone while the field has the keys. */
    private boolean areThere(List<String> ids) {
        Scene scene = session().document().scene();
        return ids.stream().allMatch(id -> Parts.isThere(scene, id));
    }

    private void commit(Property property, List<String> ids, String text) {
        Scene scene = session().document().scene();
        if (!areThere(ids)) {
            return;
        }
        Optional<String> wrong = property.wrong(scene, ids, text);
        if (wrong.isEmpty()) {
            session().document().commit(name(property, scene, ids), property.with(scene, ids, text));
        }
        shown = null;
        refresh();
    }

    private String name(Property property, Scene scene, List<String> ids) {
        String what = ids.size() > 1
                ? look().texts().format("edit.things", ids.size())
                : ids.isEmpty() ? look().text("inspector.scene") : SceneEdits.name(scene, ids.get(0));
        String key = "edit." + property.row();
        return look().texts().get(key, "").isEmpty()
                ? look().texts().format("edit.property", word(property.row()), what)
                : look().texts().format(key, what);
    }

    @Override
    public Dimension getMaximumSize() {
        return new Dimension(Integer.MAX_VALUE, getPreferredSize().height);
    }
}
