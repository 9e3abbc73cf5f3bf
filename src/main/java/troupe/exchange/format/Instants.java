package troupe.exchange.format;

import troupe.run.Run;

/** Finds the instants of an animation. */
public final class Instants {
    private static final int MOST = 20_000;

    private Instants() {}

    /** Returns the times in seconds of the pictures: equally spaced from 0, the end last; at least one. */
    public static double[] of(Run run, ExportSettings settings) throws ExchangeException {
        double duration = run.frames().duration();
        double count = Math.ceil(duration * settings.rate() - 1e-9) + 1;
        if (!(count <= MOST)) {
            throw new ExchangeException(
                    "the run of " + Math.round(duration) + " s",
                    0,
                    0,
                    "more than " + MOST + " pictures",
                    "lower the rate");
        }
        double[] instants = new double[(int) count];
        for (int k = 0; k < instants.length; k++) {
            instants[k] = Math.min(duration, k / settings.rate());
        }
        return instants;
    }
}
