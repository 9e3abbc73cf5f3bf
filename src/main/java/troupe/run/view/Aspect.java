package troupe.run.view;

import java.util.List;

/**
 * Names one respect in which a task has several sets of views, such as its search spaces or the moments of a
 * simulation, and what there is to choose from. Immutable.
 *
 * @param key a word for the respect: {@code space}, {@code instance}, {@code heading}, {@code time}, …
 * @param choices what there is to choose from, at least one; the first is chosen unless another is
 * @param views the keys of the overlays that the choice changes, so that a front offers it while one of them is
 *     shown; empty: of all
 */
public record Aspect(String key, List<Choice> choices, List<String> views) {

    /** Copies the lists and checks that there is a choice. */
    public Aspect {
        choices = List.copyOf(choices);
        views = List.copyOf(views);
        if (choices.isEmpty()) {
            throw new IllegalArgumentException("aspect '" + key + "' without a choice; needs at least one");
        }
    }

    /** Makes an aspect that changes all overlays. */
    public Aspect(String key, List<Choice> choices) {
        this(key, choices, List.of());
    }

    /**
     * Names one choice in such a way that a front can put it into its own language.
     *
     * @param word a word that a front may translate: {@code scene}, {@code moved}, {@code degrees}, …
     * @param what the names and numbers that go with it, may be empty
     */
    public record Choice(String word, List<String> what) {

        /** Copies the list. */
        public Choice {
            what = List.copyOf(what);
        }

        /** Makes a choice of a word and what goes with it. */
        public static Choice of(String word, String... what) {
            return new Choice(word, List.of(what));
        }

        /** Returns the choice as one line: {@code scene}, {@code moved Crate, Bench}, {@code degrees 15}. */
        public String text() {
            return what.isEmpty() ? word : word + ' ' + String.join(", ", what);
        }
    }

    /** Returns which choice of the aspect at {@code index} is meant: 0 where none, or one that it lacks, is given. */
    public int chosen(List<Integer> chosen, int index) {
        int choice = index < chosen.size() ? chosen.get(index) : 0;
        return choice >= 0 && choice < choices.size() ? choice : 0;
    }
}
