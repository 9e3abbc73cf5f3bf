package troupe.scene.setting;

import troupe.scene.Numbers;
import troupe.scene.Ordering;
import troupe.scene.Preferences;

/** Reads and writes orderings and preference factors as the words of files and settings. */
public final class Orderings {
    private Orderings() {}

    /** Returns an ordering as the word that {@link #ordering} reads. */
    public static String text(Ordering ordering) {
        if (ordering instanceof Ordering.Paper paper) {
            boolean plain = paper.potentialWeight() == 1 && paper.costWeight() == 1;
            return plain
                    ? "paper"
                    : "paper(" + Numbers.text(paper.potentialWeight()) + "," + Numbers.text(paper.costWeight()) + ")";
        }
        if (ordering instanceof Ordering.Bounded bounded) {
            return "bounded(" + Numbers.text(bounded.weight()) + ")";
        }
        return "optimal";
    }

    /**
     * Reads {@code optimal}, {@code paper}, {@code paper(a,b)} or {@code bounded(w)}.
     *
     * @throws IllegalArgumentException if it is none of them or a number is out of range
     */
    public static Ordering ordering(String text) {
        String word = text.strip();
        if (word.equals("optimal")) {
            return Ordering.OPTIMAL;
        }
        if (word.equals("paper")) {
            return new Ordering.Paper(1, 1);
        }
        if (word.startsWith("paper(") && word.endsWith(")")) {
            String[] weights = word.substring(6, word.length() - 1).split(",", -1);
            if (weights.length == 2) {
                return new Ordering.Paper(Numbers.number(weights[0]), Numbers.number(weights[1]));
            }
        }
        if (word.startsWith("bounded(") && word.endsWith(")")) {
            return new Ordering.Bounded(Numbers.number(word.substring(8, word.length() - 1)));
        }
        throw new IllegalArgumentException(
                "'" + word + "' where an ordering is expected: optimal, paper, paper(a,b) or bounded(w)");
    }

    /** Returns a preference factor as a number, or {@code off}. */
    public static String factor(double factor) {
        return factor == Preferences.OFF ? "off" : Numbers.text(factor);
    }

    /**
     * Reads a preference factor or {@code off}.
     *
     * @throws IllegalArgumentException if it is neither; the range is checked by {@link Preferences}
     */
    public static double factor(String text) {
        return text.strip().equals("off") ? Preferences.OFF : Numbers.number(text);
    }
}
