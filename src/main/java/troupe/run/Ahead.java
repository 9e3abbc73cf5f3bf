package troupe.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Says how many seconds ahead of the moment shown a person can look at what is expected. Pure. */
public final class Ahead {
    /** The seconds that can be chosen, where the prediction goes so far. */
    public static final List<Double> SECONDS = List.of(0.0, 0.4, 0.8, 1.6, 3.2);

    /** The key of the aspect. */
    public static final String KEY = "time";

    private Ahead() {}

    /**
     * Returns the choice: those of {@link #SECONDS} up to the horizon in seconds.
     *
     * @param views the keys of the views that it changes
     */
    public static Aspect aspect(double horizon, List<String> views) {
        List<Aspect.Choice> choices = new ArrayList<>();
        for (double seconds : SECONDS) {
            if (seconds == 0) {
                choices.add(Aspect.Choice.of("now"));
            } else if (seconds <= horizon) {
                choices.add(Aspect.Choice.of("seconds", String.format(Locale.ROOT, "%.1f", seconds)));
            }
        }
        return new Aspect(KEY, choices, views);
    }

    /** Returns the seconds of a choice of {@link #aspect}, 0 where there is no such choice. */
    public static double seconds(double horizon, int choice) {
        boolean there = choice >= 0 && choice < SECONDS.size() && SECONDS.get(choice) <= horizon;
        return there ? SECONDS.get(choice) : 0;
    }
}
