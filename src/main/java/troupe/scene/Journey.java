package troupe.scene;

import java.util.function.Consumer;

/**
 * Asks the unified planner to take an actor from start to goal.
 *
 * @param actor id of the actor
 * @param spread the order in which NF2 spreads along its skeleton
 * @param manipulation whether the actor's body takes part when it moves an obstacle
 * @param headings the number of headings in which a moved obstacle may stand, 1 to {@link #MOST_HEADINGS}
 * @param slice expansions that one turn of the search buys a manipulation instance, at least 1
 * @param expansions the most labels the search may expand before it gives up as exhausted, at least 1
 * @param spaces the most search spaces, the scene as it stands among them, before it gives up as exhausted, at least 1
 */
public record Journey(
        String id,
        String label,
        String actor,
        Place start,
        Place goal,
        Preferences preferences,
        Ordering ordering,
        Spread spread,
        Manipulation manipulation,
        int headings,
        int slice,
        long expansions,
        int spaces,
        long seed)
        implements Task {
    /** The headings of a journey that names none. */
    public static final int DEFAULT_HEADINGS = 24;
    /** The most headings in which a moved obstacle may stand: one for each degree. */
    public static final int MOST_HEADINGS = 360;
    /** The slice of a journey that names none, in expansions. */
    public static final int DEFAULT_SLICE = 2_000;
    /** The limit of a journey that names none, in expansions. */
    public static final long DEFAULT_EXPANSIONS = 50_000_000;

    /** As many as a heap of 512 MB holds, even of rooms full of movable obstacles. */
    public static final int DEFAULT_SPACES = 300;

    /** Order in which NF2 spreads along the skeleton: one wave after another, or widest place first. */
    public enum Spread {
        BREADTH,
        CLEARANCE
    }

    /** What moving an obstacle asks of the actor: nothing but to stand beside it, or to hold it all the while. */
    public enum Manipulation {
        FREE,
        GRIP
    }

    /** Makes a journey with every setting at its default. */
    public static Journey of(String id, String actor, Place start, Place goal) {
        return new Journey(
                id,
                "",
                actor,
                start,
                goal,
                Preferences.NEUTRAL,
                Ordering.OPTIMAL,
                Spread.BREADTH,
                Manipulation.GRIP,
                DEFAULT_HEADINGS,
                DEFAULT_SLICE,
                DEFAULT_EXPANSIONS,
                DEFAULT_SPACES,
                1);
    }

    @Override
    public String kind() {
        return "journey";
    }

    /** Returns this journey between other places. */
    public Journey between(Place from, Place to) {
        return changed(draft -> {
            draft.start = from;
            draft.goal = to;
        });
    }

    /** Returns this journey with other preferences. */
    public Journey preferring(Preferences changed) {
        return changed(draft -> draft.preferences = changed);
    }

    /** Returns this journey with another ordering. */
    public Journey with(Ordering changed) {
        return changed(draft -> draft.ordering = changed);
    }

    /** Returns this journey with another spreading order of NF2. */
    public Journey with(Spread changed) {
        return changed(draft -> draft.spread = changed);
    }

    /** Returns this journey with another way of moving obstacles. */
    public Journey with(Manipulation changed) {
        return changed(draft -> draft.manipulation = changed);
    }

    /** Returns this journey with another number of headings for moved obstacles. */
    public Journey withHeadings(int changed) {
        return changed(draft -> draft.headings = changed);
    }

    /** Returns this journey with other budgets. */
    public Journey limited(long newSlice, long newExpansions) {
        return changed(draft -> {
            draft.slice = Math.toIntExact(newSlice);
            draft.expansions = newExpansions;
        });
    }

    /** Returns this journey with another limit of search spaces. */
    public Journey withSpaces(int changed) {
        return changed(draft -> draft.spaces = changed);
    }

    /** Returns this journey with another seed. */
    public Journey seeded(long changed) {
        return changed(draft -> draft.seed = changed);
    }

    @Override
    public Journey named(String otherId, String otherLabel) {
        return changed(draft -> {
            draft.id = otherId;
            draft.label = otherLabel;
        });
    }

    /** Returns the same journey of another actor. */
    public Journey withActor(String other) {
        return changed(draft -> draft.actor = other);
    }

    private Journey changed(Consumer<Draft> change) {
        Draft draft = new Draft(this);
        change.accept(draft);
        return draft.journey();
    }

    /** A journey whose parts can be changed one by one. */
    private static final class Draft {
        private String id;
        private String label;
        private String actor;
        private Place start;
        private Place goal;
        private Preferences preferences;
        private Ordering ordering;
        private Spread spread;
        private Manipulation manipulation;
        private int headings;
        private int slice;
        private long expansions;
        private int spaces;
        private long seed;

        Draft(Journey of) {
            id = of.id;
            label = of.label;
            actor = of.actor;
            start = of.start;
            goal = of.goal;
            preferences = of.preferences;
            ordering = of.ordering;
            spread = of.spread;
            manipulation = of.manipulation;
            headings = of.headings;
            slice = of.slice;
            expansions = of.expansions;
            spaces = of.spaces;
            seed = of.seed;
        }

        Journey journey() {
            return new Journey(
                    id,
                    label,
                    actor,
                    start,
                    goal,
                    preferences,
                    ordering,
                    spread,
                    manipulation,
                    headings,
                    slice,
                    expansions,
                    spaces,
                    seed);
        }
    }
}
