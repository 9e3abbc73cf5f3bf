package troupe.run.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Says how many seconds ahead of the moment shown a person can look at what is expected. Pure. */
public final class Ahead {
    /** The seconds that can be chosen, where the prediction goes so far. */
    public static final List<Double> SECONDS = List.of(0.4, 0.8, 1.6, 3.2);

    /** The key of the aspect. */
    public static final String KEY = "time";

    private Ahead() {}

    /**
     * Returns the choice: those of {@link #SECONDS} up to the horizon in seconds; if none is, the moment itself.
     *
     * @param views the keys of the views that it changes
     */
    public static Aspect aspect(double horizon, List<String> views) {
        List<Aspect.Choice> choices = new ArrayList<>();
        for (double seconds : SECONDS) {
            if (seconds <= horizon) {
                choices.add(Aspect.Choice.of("seconds", String.format(Locale.ROOT, "%.1f", seconds)));
            }
        }
        if (choices.isEmpty()) {
            choices.add(Aspect.Choice.of("now"));
        }
        return new Aspect(KEY, choices, views);
    }

    /** Returns the seconds of a choice of {@link #aspect}, those of its first where there is no such choice. */
    public static double seconds(double horizon, int choice) {
        boolean there = choice >= 0 && choice < SECONDS.size() && SECONDS.get(choice) <= horizon;
        double first = SECONDS.get(0) <= horizon ? SECONDS.get(0) : 0;
        return there ? SECONDS.get(choice) : first;
    }
}
