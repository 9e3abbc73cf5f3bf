package troupe.app.look.widget;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import troupe.app.OnEventThread;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.paint.Theme;

class NumberFieldTest {
    private final List<Double> taken = new ArrayList<>();

    private NumberField field() {
        NumberField field = new NumberField(new Look(Theme.LIGHT, new Texts(Locale.ENGLISH)), "m", 2);
        field.onNumber(v -> v > 0, taken::add);
        field.show(1.234);
        return field;
    }

    @Test
    void takesARightNumberOnce() {
        OnEventThread.run(() -> {
            NumberField field = field();
            assertEquals("1.23", field.getText());
            field.setText("2,5");
            field.postActionEvent();
            assertEquals(List.of(2.5), taken);
        });
    }

    @Test
    void bringsTheOldOneBackForAWrongOne() {
        OnEventThread.run(() -> {
            NumberField field = field();
            for (String wrong : List.of("-1", "abc", "", "NaN")) {
                field.setText(wrong);
                field.postActionEvent();
                assertEquals("1.23", field.getText());
            }
            assertEquals(List.of(), taken);
        });
    }

    @Test
    void leavesWhatWasNotTypedAsPreciseAsItWas() {
        OnEventThread.run(() -> {
            NumberField field = field();
            field.setText("1.23");
            field.postActionEvent();
            assertEquals(List.of(), taken);
        });
    }
}
