package troupe.app.panel;

import java.awt.GridBagLayout;
import java.util.List;
import java.util.function.DoubleConsumer;
import java.util.function.DoublePredicate;
import java.util.function.UnaryOperator;
import javax.swing.JComponent;
import javax.swing.JLabel;
import troupe.app.document.SceneEdits;
import troupe.app.look.Look;
import troupe.app.look.NumberField;
import troupe.app.look.Switch;
import troupe.app.look.Texts;
import troupe.app.session.Session;
import troupe.geometry.Point;
import troupe.geometry.Polygon;
import troupe.paint.Tone;
import troupe.scene.Ditch;
import troupe.scene.Element;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;

/** Shows and edits the properties of what is selected, or of the scene where nothing is. */
final class PropertiesSection extends Panel {
    private static final DoublePredicate ANY = Double::isFinite;
    private static final DoublePredicate POSITIVE = v -> Double.isFinite(v) && v > 0;
    private static final DoublePredicate NOT_NEGATIVE = v -> Double.isFinite(v) && v >= 0;
    private Object shown = "";

    PropertiesSection(Look look, Session session) {
        super(look, session, new GridBagLayout());
        setName("properties");
        observing(session.selection().listeners().add(s -> refresh()));
        observing(session.document().listeners().add(c -> refresh()));
        refresh();
    }

    private void refresh() {
        Scene scene = session().document().shown();
        List<String> ids = session().selection().ids();
        Object now = List.of(
                ids, ids.isEmpty() ? scene : ids.stream().map(scene::element).toList());
        if (now.equals(shown)) {
            return;
        }
        shown = now;
        Rows rows = new Rows(this, look());
        Element element = session().selection().single(scene).orElse(null);
        if (element instanceof Obstacle obstacle) {
            show(rows, obstacle);
        } else if (element instanceof Ditch ditch) {
            show(rows, ditch);
        } else if (element instanceof Journey journey) {
            show(rows, journey);
        } else if (element != null) {
            rows.heading(element.name());
        } else if (ids.isEmpty()) {
            show(rows, scene);
        } else {
            rows.heading(look().texts().format("inspector.several", ids.size()));
            rows.wide(look().label(look().text("inspector.several.hint"), Tone.DIM), 0);
        }
        revalidate();
        repaint();
    }

    private void show(Rows rows, Scene scene) {
        rows.heading(scene.title().isEmpty() ? look().text("inspector.scene") : scene.title());
        String size = Texts.number(scene.world().width(), 2) + " \u00d7 "
                + Texts.number(scene.world().depth(), 2) + " m";
        rows.field(look().text("property.size"), value(size));
        String grid = scene.world().cols() + " \u00d7 " + scene.world().rows();
        rows.field(look().text("property.grid"), value(grid));
        rows.field(
                look().text("property.cell"), value(Texts.number(scene.world().cell() * 100, 2) + " cm"));
    }

    private JLabel value(String text) {
        JLabel label = look().label(text, Tone.TEXT);
        Look.sized(label, 100, 24);
        return label;
    }

    private void show(Rows rows, Obstacle obstacle) {
        rows.heading(obstacle.name());
        outline(rows, obstacle.outline(), shape -> obstacle.withOutline(shape));
        rows.field(
                look().text("property.bottom"),
                number(
                        "property.bottom",
                        "m",
                        2,
                        obstacle.offset(),
                        NOT_NEGATIVE,
                        v -> commit(
                                "edit.bottom",
                                with(obstacle, v, obstacle.height(), obstacle.movable(), obstacle.mass()))));
        rows.field(
                look().text("property.height"),
                number(
                        "property.height",
                        "m",
                        2,
                        obstacle.height(),
                        POSITIVE,
                        v -> commit(
                                "edit.height",
                                with(obstacle, obstacle.offset(), v, obstacle.movable(), obstacle.mass()))));
        if (obstacle.movable()) {
            rows.field(
                    look().text("property.mass"),
                    number(
                            "property.mass",
                            "kg",
                            1,
                            obstacle.mass(),
                            POSITIVE,
                            v -> commit("edit.mass", with(obstacle, obstacle.offset(), obstacle.height(), true, v))));
        }
        Switch movable = new Switch(look());
        movable.setName("property.movable");
        movable.setSelected(obstacle.movable());
        movable.addActionListener(e -> commit(
                "edit.movable",
                with(obstacle, obstacle.offset(), obstacle.height(), movable.isSelected(), obstacle.mass())));
        rows.field(look().text("property.movable"), movable);
    }

    private static Obstacle with(Obstacle o, double offset, double height, boolean movable, double mass) {
        return new Obstacle(o.id(), o.label(), o.outline(), offset, height, movable, mass, o.colour());
    }

    private void show(Rows rows, Ditch ditch) {
        rows.heading(ditch.name());
        outline(rows, ditch.outline(), ditch::withOutline);
        rows.field(
                look().text("property.depth"),
                number(
                        "property.depth",
                        "m",
                        2,
                        ditch.depth(),
                        POSITIVE,
                        v -> commit("edit.depth", new Ditch(ditch.id(), ditch.label(), ditch.outline(), v))));
    }

    /** Makes an element out of another outline. */
    private interface Shaping {
        Element with(Polygon outline);
    }

    private void outline(Rows rows, Polygon outline, Shaping shaping) {
        Point centre = outline.centroid();
        rows.field(
                look().text("property.position"),
                number(
                        "property.x",
                        "m",
                        2,
                        centre.x(),
                        ANY,
                        v -> commit(
                                "edit.position", shaping.with(SceneEdits.centred(outline, new Point(v, centre.y()))))),
                number(
                        "property.y",
                        "m",
                        2,
                        centre.y(),
                        ANY,
                        v -> commit(
                                "edit.position", shaping.with(SceneEdits.centred(outline, new Point(centre.x(), v))))));
        rows.field(
                look().text("property.turn"),
                number(
                        "property.turn",
                        "\u00b0",
                        1,
                        0,
                        ANY,
                        v -> commit("edit.turn", shaping.with(SceneEdits.turned(outline, Math.toRadians(v))))));
    }

    private void show(Rows rows, Journey journey) {
        rows.heading(journey.name());
        place(rows, "start", journey.start(), p -> journey.between(p, journey.goal()));
        place(rows, "goal", journey.goal(), p -> journey.between(journey.start(), p));
    }

    /** Makes a journey out of another place. */
    private interface Placing extends java.util.function.Function<Place, Journey> {}

    private void place(Rows rows, String end, Place place, Placing placing) {
        JComponent x = number(
                "property." + end + ".x",
                "m",
                2,
                place.x(),
                ANY,
                v -> commit("edit." + end, placing.apply(new Place(v, place.y(), place.z()))));
        JComponent y = number(
                "property." + end + ".y",
                "m",
                2,
                place.y(),
                ANY,
                v -> commit("edit." + end, placing.apply(new Place(place.x(), v, place.z()))));
        rows.field(look().text("property." + end), x, y);
    }

    private NumberField number(
            String name, String unit, int decimals, double value, DoublePredicate right, DoubleConsumer taker) {
        NumberField field = new NumberField(look(), unit, decimals);
        field.setName(name);
        field.onNumber(right, taker);
        field.show(value);
        return field;
    }

    private void commit(String key, Element changed) {
        String name = look().texts().format(key, changed.name());
        UnaryOperator<Scene> edit = scene -> scene.with(changed);
        session().document().commit(name, edit.apply(session().document().scene()));
    }

    @Override
    public java.awt.Dimension getMaximumSize() {
        return new java.awt.Dimension(Integer.MAX_VALUE, getPreferredSize().height);
    }
}
