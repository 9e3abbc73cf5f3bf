package troupe.work.view;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import troupe.risk.EncounterViews;
import troupe.risk.forecast.Blur;
import troupe.risk.forecast.Ways;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.run.view.Overlay;
import troupe.run.view.Strip;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Quantity;
import troupe.scene.Scene;
import troupe.scene.Task;

/**
 * Makes the views of a simulation at one moment of its run: how dense a crowd is; where uncertain avatars are
 * expected to be, with what probability (Avatars, figure 4); the plan as it was before its last change (figure 9).
 * They are made from the frames alone, so that a saved run shows them as one does that is still growing. Surveys the
 * ground once for each scene and task. Used by one thread at a time.
 */
public final class MomentViews {
    /** The key of the density of a crowd, in persons for each square metre. */
    public static final String DENSITY = "density";

    /** The key of the probability density of the avatars, for each square metre. */
    public static final String PROBABILITY = "probability";

    /** The key of the plan before its last change. */
    public static final String BEFORE = "plan-before";

    /** The key of the risk of standing anywhere. */
    public static final String RISK = "risk";

    /** The key of the ways expected of the avatars. */
    public static final String EXPECTED = "expected-path";

    /** The density in persons for each square metre at which the colours end: people stand shoulder to shoulder. */
    private static final double MOST_DENSITY = 5;

    private Scene surveyed;
    private String task = "";
    private CrowdDensity crowded;
    private Ways ways;

    /** Makes views; no ground is surveyed before the first that needs one. */
    public MomentViews() {}

    /** Returns how a view is to be read, for its legend; empty for one of lines. */
    public static Optional<Overlay.Scale> scale(Task task, String key, double aheadSeconds) {
        if (key.equals(DENSITY)) {
            return Optional.of(new Overlay.Continuous("1/m\u00b2", 0, MOST_DENSITY, 0));
        }
        if (key.equals(PROBABILITY) && task instanceof Encounter encounter) {
            return Optional.of(new Overlay.Continuous("1/m\u00b2", 0, peak(encounter, aheadSeconds), 0));
        }
        if (key.equals(RISK) && task instanceof Encounter encounter) {
            double most = encounter.number(Quantity.W0);
            return Optional.of(new Overlay.Continuous("", 0, most > 0 ? most : 1, 0));
        }
        return Optional.empty();
    }

    /** Returns the density in the middle of the narrowest bell of an uncertain avatar. */
    private static double peak(Encounter encounter, double aheadSeconds) {
        double most = 0;
        for (Avatar avatar : encounter.avatars()) {
            Blur blur = new Blur(encounter.number(Quantity.SIGMA), encounter.growth(), avatar.mobility());
            double sigma = blur.after(aheadSeconds);
            most = Math.max(most, 1 / (2 * Math.PI * sigma * sigma));
        }
        return most > 0 ? most : 1;
    }

    /**
     * Makes views of a moment.
     *
     * @param time seconds of the run; the last frame that is not later is looked at
     * @param keys which views; unknown ones are left out
     * @param aheadSeconds how far ahead of the moment the avatars are expected, at least 0, at most their horizon
     * @return the views; none of a run without frames, and none that its task does not have
     */
    public List<Overlay> at(Run run, double time, Collection<String> keys, double aheadSeconds) {
        List<Overlay> made = new ArrayList<>();
        Frames frames = run.frames();
        if (frames.count() == 0) {
            return made;
        }
        int frame = frame(frames, time);
        Task what = run.scene().task(run.task()).orElse(null);
        if (what instanceof Crowd crowd && keys.contains(DENSITY)) {
            Overlay.Scale scale = scale(crowd, DENSITY, 0).orElseThrow();
            if (crowded == null || !crowded.isOf(run.scene())) {
                crowded = new CrowdDensity(run.scene());
            }
            made.add(crowded.at(crowd, frames, frame, scale));
        }
        if (what instanceof Encounter encounter) {
            made.addAll(among(run, encounter, frame, keys, aheadSeconds));
        }
        return made;
    }

    /**
     * Returns how likely the plan of a moment meets each uncertain avatar over the seconds to come (Avatars, figure
     * 3); none of a run of another kind than encounters, or without frames.
     */
    public Optional<Strip> strip(Run run, double time) {
        Frames frames = run.frames();
        return frames.count() > 0 && run.scene().task(run.task()).orElse(null) instanceof Encounter encounter
                ? Optional.of(new EncounterViews(run.scene(), encounter, frames, survey(run.scene(), encounter))
                        .strip(frame(frames, time)))
                : Optional.empty();
    }

    private static int frame(Frames frames, double time) {
        return (int) Math.max(0, Math.min(frames.count() - 1.0, Math.floor(time * frames.rate() + 1e-6)));
    }

    private List<Overlay> among(Run run, Encounter encounter, int frame, Collection<String> keys, double aheadSeconds) {
        Ways ground = survey(run.scene(), encounter);
        List<Overlay> all =
                new EncounterViews(run.scene(), encounter, run.frames(), ground).overlays(frame, aheadSeconds);
        return all.stream()
                .filter(overlay -> keys.contains(overlay.key()))
                .map(overlay -> scaled(overlay, scale(encounter, overlay.key(), aheadSeconds)))
                .toList();
    }

    /** Gives a field the same colours at every moment. */
    private static Overlay scaled(Overlay overlay, Optional<Overlay.Scale> scale) {
        return overlay instanceof Overlay.Field f && scale.isPresent()
                ? new Overlay.Field(f.key(), f.layer(), f.frame(), f.values(), scale.get())
                : overlay;
    }

    private Ways survey(Scene scene, Encounter encounter) {
        if (ways == null || !scene.equals(surveyed) || !encounter.id().equals(task)) {
            ways = EncounterViews.ways(scene);
            surveyed = scene;
            task = encounter.id();
        }
        return ways;
    }
}
