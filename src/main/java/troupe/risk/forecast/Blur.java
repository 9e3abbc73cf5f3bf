package troupe.risk.forecast;

import troupe.scene.Encounter;

/** Tells the standard deviation of an avatar's place with time: Avatars, equation 3, with alpha in seconds. */
public record Blur(double sigma, Encounter.Growth growth, double mobility) {

    /** Returns the standard deviation in metres after {@code seconds}, at least 0. */
    public double after(double seconds) {
        return sigma
                * switch (growth) {
                    case LINEAR -> 1 + mobility * seconds;
                    case ROOT -> 1 + mobility * Math.sqrt(seconds);
                    case CONSTANT -> 1;
                };
    }
}
