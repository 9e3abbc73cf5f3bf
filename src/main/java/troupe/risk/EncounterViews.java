package troupe.risk;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.risk.forecast.Forecast;
import troupe.risk.forecast.History;
import troupe.risk.forecast.ProbabilityMap;
import troupe.risk.forecast.Ways;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.run.view.Ahead;
import troupe.run.view.Aspect;
import troupe.run.view.Overlay;
import troupe.run.view.Strip;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Quantity;
import troupe.scene.Scene;

/**
 * Shows what the actor expected at a frame of a run, worked out again from the frames alone: where the avatars may
 * be so many seconds later (Avatars, figure 4), the risk of standing anywhere then, the ways expected of them, the
 * plan before and after the update, and how likely it is over time to meet one of them on the plan (figure 3).
 */
public final class EncounterViews {
    private static final List<String> BY_TIME = List.of("probability", "risk");

    private final Encounter encounter;
    private final Frames frames;
    private final Ways ways;
    private final double radius;

    /** Makes the views of a run of an encounter. Cost O(cells). */
    public EncounterViews(Run run) {
        this(run.scene(), (Encounter) run.scene().task(run.task()).orElseThrow(), run.frames(), ways(run.scene()));
    }

    /** Makes the views of frames over a ground that is known already, from {@link #ways}. */
    public EncounterViews(Scene scene, Encounter encounter, Frames frames, Ways ways) {
        this.encounter = encounter;
        this.frames = frames;
        this.ways = ways;
        this.radius = scene.actor(encounter.actor()).map(a -> a.walk().radius()).orElse(0.0);
    }

    /** Returns the ways over the ground of a scene: a walker without extent can be wherever there is no wall. */
    public static Ways ways(Scene scene) {
        return new Ways(Region.of(scene, Actor.walker("avatar", 0, 0)));
    }

    /** Returns the choice of how many seconds ahead to look. */
    static Aspect ahead(Encounter encounter) {
        return Ahead.aspect(encounter.number(Quantity.HORIZON), BY_TIME);
    }

    /** Returns the views at a frame, looking {@code ahead} seconds further; none if there is no such frame. */
    public List<Overlay> overlays(int frame, double ahead) {
        if (frame < 0 || frame >= frames.count()) {
            return List.of();
        }
        Forecast forecast = forecast(frame);
        double seconds = Math.min(ahead, forecast.steps() * Forecast.STEP);
        List<Overlay> views = new ArrayList<>();
        views.add(probability(forecast, seconds));
        views.add(risk(forecast, seconds));
        views.add(new Overlay.Lines("expected-path", 0, expected(forecast)));
        if (frame > 0) {
            views.add(new Overlay.Lines("plan-before", 0, List.of(plan(frame - 1))));
        }
        views.add(new Overlay.Lines("plan", 0, List.of(plan(frame))));
        return views;
    }

    private Forecast forecast(int frame) {
        List<History> pasts = new ArrayList<>();
        int capacity = Forecast.capacity(encounter);
        for (Avatar avatar : encounter.avatars()) {
            History past = new History(capacity);
            int x = frames.channel(avatar.id(), "x");
            int y = frames.channel(avatar.id(), "y");
            for (int f = Math.max(0, frame - capacity); f <= frame; f++) {
                double atX = frames.value(f, x, 0);
                if (Double.isNaN(atX)) {
                    past.clear();
                } else {
                    past.see(f / encounter.number(Quantity.RATE), atX, frames.value(f, y, 0));
                }
            }
            pasts.add(past);
        }
        Forecast forecast = new Forecast(encounter, ways);
        forecast.compute(pasts);
        return forecast;
    }

    private Overlay probability(Forecast forecast, double seconds) {
        GridFrame frame = ways.frame();
        float[] density = new float[frame.size()];
        ProbabilityMap map = new ProbabilityMap(forecast, ways);
        for (int a = 0; a < encounter.avatars().size(); a++) {
            if (forecast.has(a)) {
                map.add(a, seconds, density);
            }
        }
        return field("probability", "1/m²", density);
    }

    private Overlay risk(Forecast forecast, double seconds) {
        GridFrame frame = ways.frame();
        float[] risk = new float[frame.size()];
        int step = forecast.step(seconds);
        for (int cell = 0; cell < risk.length; cell++) {
            risk[cell] = ways.isFree(cell)
                    ? (float) forecast.risk(frame.centreX(frame.col(cell)), frame.centreY(frame.row(cell)), 0, 0, step)
                    : 0;
        }
        return field("risk", "", risk);
    }

    private Overlay field(String key, String unit, float[] values) {
        float most = 0;
        for (int cell = 0; cell < values.length; cell++) {
            most = Math.max(most, values[cell]);
        }
        // what is next to nothing is not shown
        for (int cell = 0; cell < values.length; cell++) {
            values[cell] = values[cell] <= 1e-3f * most ? Float.NaN : values[cell];
        }
        double top = most > 0 ? most : 1;
        return new Overlay.Field(key, 0, ways.frame(), values, new Overlay.Continuous(unit, 0, top, 0));
    }

    private List<double[]> expected(Forecast forecast) {
        List<double[]> lines = new ArrayList<>();
        double last = forecast.steps() * Forecast.STEP;
        for (int a = 0; a < encounter.avatars().size(); a++) {
            if (forecast.has(a)) {
                lines.add(new double[] {
                    forecast.expectedX(a, 0),
                    forecast.expectedY(a, 0),
                    forecast.expectedX(a, last),
                    forecast.expectedY(a, last)
                });
            }
        }
        return lines;
    }

    private double[] plan(int frame) {
        int x = frames.channel(encounter.actor(), "plan.x");
        int y = frames.channel(encounter.actor(), "plan.y");
        double[] line = new double[2 * EncounterFrames.POINTS];
        for (int k = 0; k < EncounterFrames.POINTS; k++) {
            line[2 * k] = frames.value(frame, x, k);
            line[2 * k + 1] = frames.value(frame, y, k);
        }
        return line;
    }

    /**
     * Returns for each uncertain avatar how likely it is, over the seconds to the horizon, to be where the plan of a
     * frame leads: Avatars, figure 3. NaN where the plan has ended or the avatar is not there.
     */
    public Strip strip(int frame) {
        Forecast forecast = forecast(frame);
        int t = frames.channel(encounter.actor(), "plan.t");
        double[] times = new double[EncounterFrames.POINTS];
        for (int k = 0; k < times.length; k++) {
            times[k] = frames.value(frame, t, k);
        }
        double[] line = plan(frame);
        List<String> names = new ArrayList<>();
        List<double[]> rows = new ArrayList<>();
        for (int a = 0; a < encounter.avatars().size(); a++) {
            Avatar avatar = encounter.avatars().get(a);
            if (avatar.kind() == Avatar.Kind.UNCERTAIN && forecast.has(a)) {
                double[] row = new double[forecast.steps() + 1];
                for (int step = 0; step < row.length; step++) {
                    row[step] = meeting(forecast, a, avatar, step, times, line);
                }
                names.add(avatar.name());
                rows.add(row);
            }
        }
        return new Strip("probability", Forecast.STEP, names, rows);
    }

    private double meeting(Forecast forecast, int a, Avatar avatar, int step, double[] times, double[] line) {
        double time = times[0] + step * Forecast.STEP;
        if (time > times[times.length - 1] + 1e-6) {
            return Double.NaN;
        }
        int at = Arrays.binarySearch(times, time);
        int k = Math.max(0, Math.min(times.length - 2, at >= 0 ? at : -at - 2));
        double span = times[k + 1] - times[k];
        double share = span > 0 ? Math.min(1, (time - times[k]) / span) : 0;
        double x = line[2 * k] + share * (line[2 * k + 2] - line[2 * k]);
        double y = line[2 * k + 1] + share * (line[2 * k + 3] - line[2 * k + 1]);
        return forecast.contact(a, x, y, radius + avatar.radius(), step);
    }
}
