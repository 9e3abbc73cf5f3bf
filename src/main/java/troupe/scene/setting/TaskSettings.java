package troupe.scene.setting;

import static troupe.scene.setting.SettingTable.positive;
import static troupe.scene.setting.SettingTable.word;

import java.util.Arrays;
import java.util.List;
import troupe.scene.Ability;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Numbers;

/** Lists the settings of each kind of task, in the order in which help lists them. */
final class TaskSettings {
    private TaskSettings() {}

    static SettingTable<Journey> journey() {
        SettingTable<Journey> all = new SettingTable<>(Journey.class, Journey::actor);
        all.task("ordering", j -> Orderings.text(j.ordering()), (j, v) -> j.with(Orderings.ordering(v)));
        all.task("spread", j -> word(j.spread()), (j, v) -> j.with(word(Journey.Spread.class, v)));
        all.task("manipulation", j -> word(j.manipulation()), (j, v) -> j.with(word(Journey.Manipulation.class, v)));
        all.task(
                "headings",
                j -> Integer.toString(j.headings()),
                (j, v) -> j.withHeadings((int) positive(v, Journey.MOST_HEADINGS)));
        all.task(
                "slice",
                j -> Integer.toString(j.slice()),
                (j, v) -> j.limited(positive(v, Integer.MAX_VALUE), j.expansions()));
        all.task(
                "limit.expansions",
                j -> Long.toString(j.expansions()),
                (j, v) -> j.limited(j.slice(), positive(v, Long.MAX_VALUE)));
        all.task(
                "limit.spaces",
                j -> Integer.toString(j.spaces()),
                (j, v) -> j.withSpaces((int) positive(v, Integer.MAX_VALUE)));
        all.task("seed", j -> Long.toString(j.seed()), (j, v) -> j.seeded(Numbers.whole(v)));
        all.task("start", j -> Numbers.text(j.start()), (j, v) -> j.between(Numbers.place(v), j.goal()));
        all.task("goal", j -> Numbers.text(j.goal()), (j, v) -> j.between(j.start(), Numbers.place(v)));
        for (Ability ability : Ability.values()) {
            all.task(
                    "preference." + ability.key(),
                    j -> Orderings.factor(j.preferences().of(ability)),
                    (j, v) -> j.preferring(j.preferences().with(ability, Orderings.factor(v))));
        }
        all.actor(Arrays.asList(Ability.values()));
        all.cell();
        return all;
    }

    static SettingTable<Encounter> encounter() {
        SettingTable<Encounter> all = new SettingTable<>(Encounter.class, Encounter::actor);
        all.task("method", e -> word(e.method()), (e, v) -> e.with(word(Encounter.Method.class, v)));
        all.task("ordering", e -> word(e.ordering()), (e, v) -> e.with(word(Encounter.Order.class, v)));
        all.task("influence", e -> word(e.influence()), (e, v) -> e.with(word(Encounter.Influence.class, v)));
        all.task("growth", e -> word(e.growth()), (e, v) -> e.with(word(Encounter.Growth.class, v)));
        for (Encounter.Quantity quantity : Encounter.Quantity.values()) {
            all.task(
                    quantity.key(),
                    e -> Numbers.text(e.number(quantity)),
                    (e, v) -> e.with(quantity, Numbers.number(v)));
        }
        all.task("seed", e -> Long.toString(e.seed()), (e, v) -> e.seeded(Numbers.whole(v)));
        all.task("start", e -> Numbers.text(e.start()), (e, v) -> e.between(Numbers.place(v), e.goal()));
        all.task("goal", e -> Numbers.text(e.goal()), (e, v) -> e.between(e.start(), Numbers.place(v)));
        all.actor(List.of(Ability.WALK));
        all.cell();
        return all;
    }
}
