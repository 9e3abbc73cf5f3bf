package troupe.scene.setting;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.ToDoubleFunction;
import troupe.scene.Crowd;
import troupe.scene.Numbers;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Lists the settings of a crowd: {@code motion}, {@code split}, {@code weight.separation}, {@code
 * relation.1.cohesion}, … There are relation keys for each depth of the crowd's tree.
 */
public final class CrowdSettings {
    private CrowdSettings() {}

    /** A number that may be changed while a crowd moves: its key, its range with both ends, and its value. */
    public record Live(String key, double min, double max, double value) {}

    /** Returns the numbers that may change while the crowd moves: the weights and the relation vectors. */
    public static List<Live> live(Crowd crowd) {
        List<Live> all = new ArrayList<>();
        SettingTable<Crowd> table = table(crowd);
        Map<String, String> values = table.values(alone(crowd), crowd);
        for (String key : table.keys()) {
            if (key.startsWith("weight.") || key.startsWith("relation.")) {
                all.add(new Live(key, 0, Crowd.Weights.MOST, Double.parseDouble(values.get(key))));
            }
        }
        return all;
    }

    /**
     * Returns the crowd with one of its {@linkplain #live live} numbers changed.
     *
     * @throws IllegalArgumentException if there is no such number or the value is out of range
     */
    public static Crowd with(Crowd crowd, String key, double value) {
        return (Crowd) Settings.apply(alone(crowd), crowd.id(), key, Double.toString(value))
                .task(crowd.id())
                .orElseThrow();
    }

    private static Scene alone(Crowd crowd) {
        return new Scene("", World.of(1, 1), List.of(), List.of(), List.of(), List.of(crowd));
    }

    static SettingTable<Crowd> table(Crowd crowd) {
        SettingTable<Crowd> all = new SettingTable<>(Crowd.class, c -> "");
        all.task("motion", c -> SettingTable.word(c.manner().motion()), (c, v) -> {
            Crowd.Manner m = c.manner();
            Crowd.Motion motion = SettingTable.word(Crowd.Motion.class, v);
            return c.with(new Crowd.Manner(motion, m.split(), m.view(), m.bodyHeight(), m.stepHeight()));
        });
        all.task("split", c -> SettingTable.word(c.manner().split()), (c, v) -> {
            Crowd.Manner m = c.manner();
            Crowd.Split split = SettingTable.word(Crowd.Split.class, v);
            return c.with(new Crowd.Manner(m.motion(), split, m.view(), m.bodyHeight(), m.stepHeight()));
        });
        all.task("view", c -> Numbers.text(c.manner().view()), (c, v) -> {
            Crowd.Manner m = c.manner();
            double view = SettingTable.finite(v);
            return c.with(new Crowd.Manner(m.motion(), m.split(), view, m.bodyHeight(), m.stepHeight()));
        });
        all.task("seconds", c -> Numbers.text(c.seconds()), (c, v) -> c.lasting(SettingTable.finite(v)));
        all.task("seed", c -> Long.toString(c.seed()), (c, v) -> c.seeded(Numbers.whole(v)));
        weights(all);
        for (int depth = 0; depth <= crowd.deepest(); depth++) {
            relations(all, depth);
        }
        all.cell();
        return all;
    }

    private static void weights(SettingTable<Crowd> all) {
        weight(
                all,
                "separation",
                Crowd.Weights::separation,
                (w, v) -> new Crowd.Weights(v, w.cohesion(), w.alignment(), w.path(), w.anticipation()));
        weight(
                all,
                "cohesion",
                Crowd.Weights::cohesion,
                (w, v) -> new Crowd.Weights(w.separation(), v, w.alignment(), w.path(), w.anticipation()));
        weight(
                all,
                "alignment",
                Crowd.Weights::alignment,
                (w, v) -> new Crowd.Weights(w.separation(), w.cohesion(), v, w.path(), w.anticipation()));
        weight(
                all,
                "path",
                Crowd.Weights::path,
                (w, v) -> new Crowd.Weights(w.separation(), w.cohesion(), w.alignment(), v, w.anticipation()));
        weight(
                all,
                "anticipation",
                Crowd.Weights::anticipation,
                (w, v) -> new Crowd.Weights(w.separation(), w.cohesion(), w.alignment(), w.path(), v));
    }

    private static void weight(
            SettingTable<Crowd> all,
            String name,
            ToDoubleFunction<Crowd.Weights> value,
            BiFunction<Crowd.Weights, Double, Crowd.Weights> change) {
        all.task(
                "weight." + name,
                c -> Numbers.text(value.applyAsDouble(c.weights())),
                (c, v) -> c.with(change.apply(c.weights(), factor(v))));
    }

    private static void relations(SettingTable<Crowd> all, int depth) {
        relation(
                all,
                depth,
                "cohesion",
                Crowd.Relation::cohesion,
                (r, v) -> new Crowd.Relation(depth, v, r.alignment(), r.separation()));
        relation(
                all,
                depth,
                "alignment",
                Crowd.Relation::alignment,
                (r, v) -> new Crowd.Relation(depth, r.cohesion(), v, r.separation()));
        relation(
                all,
                depth,
                "separation",
                Crowd.Relation::separation,
                (r, v) -> new Crowd.Relation(depth, r.cohesion(), r.alignment(), v));
    }

    private static void relation(
            SettingTable<Crowd> all,
            int depth,
            String name,
            ToDoubleFunction<Crowd.Relation> value,
            BiFunction<Crowd.Relation, Double, Crowd.Relation> change) {
        all.task(
                "relation." + depth + "." + name,
                c -> Numbers.text(value.applyAsDouble(c.relation(depth))),
                (c, v) -> c.with(change.apply(c.relation(depth), factor(v))));
    }

    private static double factor(String value) {
        double number = SettingTable.finite(value);
        if (!(number >= 0 && number <= Crowd.Weights.MOST)) {
            throw new IllegalArgumentException("needs a number from 0 to " + Numbers.text(Crowd.Weights.MOST));
        }
        return number;
    }
}
