package troupe.scene;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Asks the risk planner to take an actor from start to goal among avatars.
 *
 * @param actor id of the actor, which only walks: a disc of its walking radius, at its walking speed
 * @param method how it deals with the avatars
 * @param ordering what a plan is made for
 * @param influence how an avatar's risk is averaged
 * @param growth how an avatar's future blurs
 * @param numbers the value of every {@link Quantity}
 */
public record Encounter(
        String id,
        String label,
        String actor,
        Place start,
        Place goal,
        List<Avatar> avatars,
        Method method,
        Order ordering,
        Influence influence,
        Growth growth,
        Map<Quantity, Double> numbers,
        long seed)
        implements Task {

    /** How the actor deals with the avatars. */
    public enum Method {
        /** Predicts them, and updates its plan at every step. */
        RISK,
        /** Predicts them, plans once and never looks again. */
        ONCE,
        /** Plans at every step as if they stood still. */
        STATIC
    }

    /** What a plan is made for. */
    public enum Order {
        /** Avatars, figure 5: the next state is the one of least potential plus risk. */
        PAPER,
        /** Least length plus caution times accumulated risk. */
        OPTIMAL
    }

    /** How the risk of an avatar is averaged over where it may be. */
    public enum Influence {
        /** The expected risk. */
        EXPECTED,
        /** The bare mean of probability times risk, with the one-dimensional normaliser, as Avatars prints it. */
        PAPER
    }

    /** How the standard deviation of an avatar's place grows with time. */
    public enum Growth {
        /** By 1 + mobility t. */
        LINEAR,
        /** By 1 + mobility sqrt(t). */
        ROOT,
        /** Not at all. */
        CONSTANT
    }

    /** A number of an encounter: its name in files, unit, default and range. */
    public enum Quantity {
        /** Earlier positions that a prediction looks at. */
        HISTORY("history", "", 8, 1, 64, true),
        /** Standard deviation of an avatar's place at the present instant. */
        SIGMA("sigma", "m", 0.1, 0.001, 100, false),
        /** Seconds that are predicted. */
        HORIZON("horizon", "s", 4, 0.1, 30, false),
        /** Risk at no distance. */
        W0("w0", "", 2.5, -1e6, 1e6, false),
        /** Risk for each metre of distance. */
        W1("w1", "1/m", -2, -1e6, 1e6, false),
        /** Risk for each metre per second at which the distance grows. */
        W2("w2", "s/m", -0.5, -1e6, 1e6, false),
        /** What a second of risk 1 counts in the optimal ordering, in metres of way. */
        CAUTION("caution", "m/s", 1, 0, 1e6, false),
        /** How far an update moves the middle of a stretch aside. */
        REACH("reach", "cells", 12, 1, 1000, true),
        /** What mean risk 1 counts when an updated plan is judged, in metres of way. */
        TRADE("trade", "m", 2, 0, 1e6, false),
        /** Steps per second. */
        RATE("rate", "1/s", 30, 2, 120, false),
        /** Seconds after which the actor gives up. */
        DURATION("duration", "s", 120, 0.1, 3600, false);

        private final String key;
        private final String unit;
        private final double usual;
        private final double least;
        private final double most;
        private final boolean whole;

        Quantity(String key, String unit, double usual, double least, double most, boolean whole) {
            this.key = key;
            this.unit = unit;
            this.usual = usual;
            this.least = least;
            this.most = most;
            this.whole = whole;
        }

        /** Returns its name in files and settings. */
        public String key() {
            return key;
        }

        /** Returns its unit, empty for a bare number. */
        public String unit() {
            return unit;
        }

        /** Returns its value where none is given. */
        public double usual() {
            return usual;
        }

        /** Returns its least value, inclusive. */
        public double least() {
            return least;
        }

        /** Returns its greatest value, inclusive. */
        public double most() {
            return most;
        }

        /** Tells whether a value is in its range, and whole if it must be. */
        public boolean takes(double value) {
            return value >= least && value <= most && (!whole || value == Math.rint(value));
        }

        /** Returns what it takes, in words. */
        public String range() {
            return "a " + (whole ? "whole " : "") + "number from " + Numbers.text(least) + " to " + Numbers.text(most);
        }
    }

    /** Copies list and map; a quantity that is absent gets its usual value. */
    public Encounter {
        avatars = List.copyOf(avatars);
        Map<Quantity, Double> all = new EnumMap<>(Quantity.class);
        for (Quantity quantity : Quantity.values()) {
            all.put(quantity, numbers.getOrDefault(quantity, quantity.usual()));
        }
        numbers = Collections.unmodifiableMap(all);
    }

    /** Makes an encounter with every setting at its default. */
    public static Encounter of(String id, String actor, Place start, Place goal, List<Avatar> avatars) {
        return new Encounter(
                id,
                "",
                actor,
                start,
                goal,
                avatars,
                Method.RISK,
                Order.PAPER,
                Influence.EXPECTED,
                Growth.LINEAR,
                Map.of(),
                1);
    }

    @Override
    public String kind() {
        return "encounter";
    }

    /** Returns the value of a quantity. */
    public double number(Quantity quantity) {
        return numbers.get(quantity);
    }

    /** Finds an avatar by its id. Cost O(avatars). */
    public Optional<Avatar> avatar(String avatarId) {
        return avatars.stream().filter(a -> a.id().equals(avatarId)).findFirst();
    }

    /** Returns this encounter between other places. */
    public Encounter between(Place from, Place to) {
        return new Encounter(id, label, actor, from, to, avatars, method, ordering, influence, growth, numbers, seed);
    }

    /** Returns this encounter with other avatars. */
    public Encounter among(List<Avatar> others) {
        return new Encounter(id, label, actor, start, goal, others, method, ordering, influence, growth, numbers, seed);
    }

    /** Returns this encounter with the avatar of the same id replaced; itself if it has none. */
    public Encounter with(Avatar changed) {
        List<Avatar> all = new ArrayList<>(avatars);
        all.replaceAll(a -> a.id().equals(changed.id()) ? changed : a);
        return among(all);
    }

    /** Returns this encounter with another method. */
    public Encounter with(Method changed) {
        return new Encounter(
                id, label, actor, start, goal, avatars, changed, ordering, influence, growth, numbers, seed);
    }

    /** Returns this encounter with another ordering. */
    public Encounter with(Order changed) {
        return new Encounter(id, label, actor, start, goal, avatars, method, changed, influence, growth, numbers, seed);
    }

    /** Returns this encounter with another average of risk. */
    public Encounter with(Influence changed) {
        return new Encounter(id, label, actor, start, goal, avatars, method, ordering, changed, growth, numbers, seed);
    }

    /** Returns this encounter with another growth. */
    public Encounter with(Growth changed) {
        return new Encounter(
                id, label, actor, start, goal, avatars, method, ordering, influence, changed, numbers, seed);
    }

    /**
     * Returns this encounter with another value of a quantity.
     *
     * @throws IllegalArgumentException if the value is outside the quantity's range
     */
    public Encounter with(Quantity quantity, double value) {
        if (!quantity.takes(value)) {
            throw new IllegalArgumentException(
                    quantity.key() + "=" + Numbers.text(value) + ": needs " + quantity.range());
        }
        Map<Quantity, Double> changed = new EnumMap<>(numbers);
        changed.put(quantity, value);
        return new Encounter(
                id, label, actor, start, goal, avatars, method, ordering, influence, growth, changed, seed);
    }

    /** Returns this encounter with another seed. */
    public Encounter seeded(long changed) {
        return new Encounter(
                id, label, actor, start, goal, avatars, method, ordering, influence, growth, numbers, changed);
    }

    @Override
    public Encounter named(String otherId, String otherLabel) {
        return new Encounter(
                otherId, otherLabel, actor, start, goal, avatars, method, ordering, influence, growth, numbers, seed);
    }

    /** Returns the same encounter of another actor. */
    public Encounter withActor(String other) {
        return new Encounter(
                id, label, other, start, goal, avatars, method, ordering, influence, growth, numbers, seed);
    }
}
