package troupe.scene.setting;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import troupe.scene.Ability;
import troupe.scene.Actor;

/**
 * Holds the numbers of an actor as a flat form, so that the file codec and the settings read and write
 * them by name: first those of the body, then those of each ability, in the order of {@link Ability}.
 */
public final class ActorForm {
    /** Names of the body's numbers. */
    public static final List<String> BODY = List.of("bodyHeight", "footRadius", "stepHeight", "maxBorder");

    private static final Map<Ability, List<String>> NAMES = new EnumMap<>(Map.of(
            Ability.WALK, List.of("radius", "energy", "speed"),
            Ability.SIDESTEP, List.of("radius", "energy", "speed"),
            Ability.STRIDE, List.of("gait", "maxGap", "energy", "takeOff", "speed"),
            Ability.VAULT,
                    List.of("minHeight", "maxHeight", "reach", "bodyHeight", "maxJump", "energy", "takeOff", "speed"),
            Ability.MOVE, List.of("energy", "turnEnergy", "speed")));

    /** How much farther than the straight length a crossing may be travelled along the grid (02 section 1). */
    private static final double GRID_DETOUR = 1.1;

    private final double[] body;
    private final Map<Ability, double[]> abilities = new EnumMap<>(Ability.class);

    private ActorForm(double[] body) {
        this.body = body;
    }

    /** Starts a form with the body of the standard actor and no ability. */
    public static ActorForm bare() {
        return new ActorForm(bodyOf(Actor.standard("actor")));
    }

    /** Fills a form with the numbers of an actor. */
    public static ActorForm of(Actor actor) {
        ActorForm form = new ActorForm(bodyOf(actor));
        Actor.Walk w = actor.walk();
        form.abilities.put(Ability.WALK, new double[] {w.radius(), w.energy(), w.speed()});
        actor.sidestep()
                .ifPresent(a -> form.abilities.put(Ability.SIDESTEP, new double[] {a.radius(), a.energy(), a.speed()}));
        actor.stride()
                .ifPresent(a -> form.abilities.put(
                        Ability.STRIDE, new double[] {a.gait(), a.maxGap(), a.energy(), a.takeOff(), a.speed()}));
        actor.vault()
                .ifPresent(a -> form.abilities.put(Ability.VAULT, new double[] {
                    a.minHeight(),
                    a.maxHeight(),
                    a.reach(),
                    a.bodyHeight(),
                    a.maxJump(),
                    a.energy(),
                    a.takeOff(),
                    a.speed()
                }));
        actor.move()
                .ifPresent(a -> form.abilities.put(Ability.MOVE, new double[] {a.energy(), a.turnEnergy(), a.speed()}));
        return form;
    }

    private static double[] bodyOf(Actor actor) {
        return new double[] {actor.bodyHeight(), actor.footRadius(), actor.stepHeight(), actor.maxBorder()};
    }

    /** Returns the names of an ability's numbers. */
    public static List<String> names(Ability ability) {
        return NAMES.get(ability);
    }

    /** Returns the numbers of an ability that names none. */
    private static double[] defaults(Ability ability) {
        return of(Actor.standard("actor")).abilities.get(ability);
    }

    /** Gives the form an ability with default numbers. */
    public void add(Ability ability) {
        abilities.put(ability, defaults(ability));
    }

    /** Tells whether the form has an ability. */
    public boolean has(Ability ability) {
        return abilities.containsKey(ability);
    }

    /** Returns the abilities of the form. */
    public Set<Ability> abilities() {
        return abilities.keySet();
    }

    /** Returns a number of the body. */
    public double body(String name) {
        return body[BODY.indexOf(name)];
    }

    /** Sets a number of the body. */
    public void setBody(String name, double value) {
        body[BODY.indexOf(name)] = value;
    }

    /** Returns a number of an ability that the form has. */
    public double number(Ability ability, String name) {
        return abilities.get(ability)[names(ability).indexOf(name)];
    }

    /**
     * Sets a number of an ability that the form has. The limits N and J follow the gait and the reach as
     * long as they have their default ratio to them.
     */
    public void set(Ability ability, String name, double value) {
        double[] numbers = abilities.get(ability);
        int i = names(ability).indexOf(name);
        int limit = limitOf(ability, name);
        boolean follows = limit >= 0 && numbers[limit] == GRID_DETOUR * numbers[i];
        numbers[i] = value;
        if (follows) {
            numbers[limit] = GRID_DETOUR * value;
        }
    }

    private static int limitOf(Ability ability, String name) {
        return switch (name) {
            case "gait" -> names(ability).indexOf("maxGap");
            case "reach" -> names(ability).indexOf("maxJump");
            default -> -1;
        };
    }

    /** Tells whether a number of an ability is what it would be if it were not named. */
    public boolean isDefault(Ability ability, String name) {
        return switch (name) {
            case "maxGap" -> number(ability, name) == GRID_DETOUR * number(ability, "gait");
            case "maxJump" -> number(ability, name) == GRID_DETOUR * number(ability, "reach");
            default -> number(ability, name) == defaults(ability)[names(ability).indexOf(name)];
        };
    }

    /** Tells whether a number of the body is the standard one. */
    public boolean isDefault(String name) {
        return body(name) == bare().body(name);
    }

    /** Makes the actor; an ability that the form lacks is absent, but for walking, which every actor has. */
    public Actor actor(String id, String label, String colour) {
        double[] w = abilities.getOrDefault(Ability.WALK, defaults(Ability.WALK));
        return new Actor(
                id,
                label,
                colour,
                body[0],
                body[1],
                body[2],
                body[3],
                new Actor.Walk(w[0], w[1], w[2]),
                numbers(Ability.SIDESTEP).map(n -> new Actor.Sidestep(n[0], n[1], n[2])),
                numbers(Ability.STRIDE).map(n -> new Actor.Stride(n[0], n[1], n[2], n[3], n[4])),
                numbers(Ability.VAULT).map(n -> new Actor.Vault(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7])),
                numbers(Ability.MOVE).map(n -> new Actor.Move(n[0], n[1], n[2])));
    }

    private Optional<double[]> numbers(Ability ability) {
        return Optional.ofNullable(abilities.get(ability));
    }

    @Override
    public String toString() {
        return "ActorForm" + Arrays.toString(body) + abilities.keySet();
    }
}
