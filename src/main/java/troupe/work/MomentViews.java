package troupe.work;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.risk.forecast.Blur;
import troupe.risk.forecast.Forecast;
import troupe.risk.forecast.History;
import troupe.risk.forecast.ProbabilityMap;
import troupe.risk.forecast.Ways;
import troupe.run.Frames;
import troupe.run.Overlay;
import troupe.run.Run;
import troupe.scene.Actor;
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

    /** The density in persons for each square metre at which the colours end: people stand shoulder to shoulder. */
    private static final double MOST_DENSITY = 5;

    /** Of the peak of a bell; less probable places are left plain. */
    private static final double LEAST_SHARE = 0.01;

    private Scene surveyed;
    private String task = "";
    private CrowdDensity crowded;
    private GridFrame grid;
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
        int frame = (int) Math.max(0, Math.min(frames.count() - 1.0, Math.floor(time * frames.rate() + 1e-6)));
        Task what = run.scene().task(run.task()).orElse(null);
        if (what instanceof Crowd crowd && keys.contains(DENSITY)) {
            Overlay.Scale scale = scale(crowd, DENSITY, 0).orElseThrow();
            if (crowded == null || !crowded.isOf(run.scene())) {
                crowded = new CrowdDensity(run.scene());
            }
            made.add(crowded.at(crowd, frames, frame, scale));
        }
        if (what instanceof Encounter encounter && keys.contains(PROBABILITY)) {
            made.add(probability(run.scene(), encounter, frames, frame, aheadSeconds));
        }
        if (what instanceof Encounter encounter && keys.contains(BEFORE)) {
            before(encounter, frames, frame).ifPresent(made::add);
        }
        return made;
    }

    private Overlay probability(Scene scene, Encounter encounter, Frames frames, int frame, double aheadSeconds) {
        Ways ground = survey(scene, encounter);
        Forecast forecast = new Forecast(encounter, ground);
        List<History> pasts = new ArrayList<>();
        for (Avatar avatar : encounter.avatars()) {
            pasts.add(past(encounter, frames, avatar.id(), frame));
        }
        forecast.compute(pasts);
        float[] density = new float[grid.size()];
        ProbabilityMap map = new ProbabilityMap(forecast, ground);
        double ahead = Math.max(0, Math.min(encounter.number(Quantity.HORIZON), aheadSeconds));
        for (int a = 0; a < pasts.size(); a++) {
            if (forecast.has(a)) {
                map.add(a, ahead, density);
            }
        }
        double peak = peak(encounter, ahead);
        for (int i = 0; i < density.length; i++) {
            density[i] = density[i] < LEAST_SHARE * peak ? Float.NaN : density[i];
        }
        return new Overlay.Field(
                PROBABILITY,
                0,
                grid,
                density,
                scale(encounter, PROBABILITY, ahead).orElseThrow());
    }

    private Ways survey(Scene scene, Encounter encounter) {
        if (ways == null || !scene.equals(surveyed) || !encounter.id().equals(task)) {
            Region region = Region.of(scene, Actor.walker("avatar", 0, 0));
            grid = region.frame();
            ways = new Ways(region);
            surveyed = scene;
            task = encounter.id();
        }
        return ways;
    }

    /** Returns what had been seen of an avatar by a frame. */
    private static History past(Encounter encounter, Frames frames, String avatar, int frame) {
        int capacity = Forecast.capacity(encounter);
        History history = new History(capacity);
        int x = frames.channel(avatar, "x");
        int y = frames.channel(avatar, "y");
        for (int f = Math.max(0, frame - capacity + 1); f <= frame && x >= 0 && y >= 0; f++) {
            double atX = frames.value(f, x, 0);
            if (Double.isNaN(atX)) {
                history.clear();
            } else {
                history.see(f / frames.rate(), atX, frames.value(f, y, 0));
            }
        }
        return history;
    }

    /** Finds the plan before the last frame that changed it; none before it has changed. */
    private static Optional<Overlay> before(Encounter encounter, Frames frames, int frame) {
        int action = frames.channel(encounter.actor(), "action");
        int x = frames.channel(encounter.actor(), "plan.x");
        int y = frames.channel(encounter.actor(), "plan.y");
        if (action < 0 || x < 0 || y < 0) {
            return Optional.empty();
        }
        int kept = List.of(frames.channels().get(action).unit().split(",")).indexOf("kept");
        for (int f = frame; f > 0; f--) {
            if (frames.value(f, action, 0) != kept) {
                int width = frames.channels().get(x).width();
                double[] line = new double[2 * width];
                for (int k = 0; k < width; k++) {
                    line[2 * k] = frames.value(f - 1, x, k);
                    line[2 * k + 1] = frames.value(f - 1, y, k);
                }
                return Optional.of(new Overlay.Lines(BEFORE, 0, List.of(line)));
            }
        }
        return Optional.empty();
    }
}
