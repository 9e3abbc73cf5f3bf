package troupe.risk;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** What the actor did about its plan in one step. */
public enum Action {
    /** It kept the plan. */
    KEPT,
    /** It changed stretches of the plan. */
    UPDATED,
    /** It planned anew from where it is. */
    REPLANNED,
    /** It found nothing and waits. */
    WAITED,
    /** It found nothing, could not stay, and stepped aside. */
    EVADED;

    /** Returns the word for it in reports. */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Returns all words in order, comma-separated, as the unit of a channel of codes. */
    static String words() {
        return Arrays.stream(values()).map(Action::key).collect(Collectors.joining(","));
    }
}
