package troupe.app.look.widget;

import java.util.Optional;
import java.util.function.DoubleConsumer;
import java.util.function.DoublePredicate;
import troupe.app.look.Look;
import troupe.app.look.Texts;

/** A field for a number, its unit dim and inside; see {@link Entry} for how it is typed. */
public final class NumberField extends Entry {
    private final int decimals;

    /** Makes a field with a unit (may be empty) that shows this many decimals. */
    public NumberField(Look look, String unit, int decimals) {
        super(look, unit);
        this.decimals = decimals;
    }

    /** Sets which numbers are right, and who takes a new one. */
    public void onNumber(DoublePredicate right, DoubleConsumer taken) {
        onText(
                text -> right.test(number(text)) ? Optional.empty() : Optional.of(text),
                text -> taken.accept(number(text)));
    }

    /** Shows a number. */
    public void show(double shown) {
        showText(Texts.number(shown, decimals));
    }

    private static double number(String text) {
        try {
            return Double.parseDouble(text.trim().replace('\u2212', '-').replace(',', '.'));
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }
}
