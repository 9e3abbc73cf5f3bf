package troupe.paint;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.Frames;
import troupe.run.view.Overlay;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.search.Outcome;

/** A scene, overlays and a run made by hand, with one of everything that painters draw. */
public final class Sketch {
    private Sketch() {}

    /** Returns a yard of 18 by 13 metres: walls, a low wall, a canal, a gallery on a stair, crate and table. */
    public static Scene scene() {
        List<Obstacle> all = new ArrayList<>();
        all.add(fixed("north", 0, 12.7, 18, 13, 0, 3, ""));
        all.add(fixed("south", 0, 0, 18, 0.3, 0, 3, ""));
        all.add(fixed("west", 0, 0.3, 0.3, 12.7, 0, 3, ""));
        all.add(fixed("east", 17.7, 0.3, 18, 12.7, 0, 3, ""));
        all.add(fixed("inner-1", 8, 8.4, 8.3, 10.4, 0, 3, ""));
        all.add(fixed("inner-2", 8, 4, 8.3, 6.8, 0, 3, ""));
        all.add(fixed("inner-3", 8.3, 10.1, 15.5, 10.4, 0, 3, ""));
        all.add(fixed("inner-4", 8.3, 4, 15.5, 4.3, 0, 3, ""));
        all.add(fixed("inner-5", 15.2, 4.3, 15.5, 10.1, 0, 3, ""));
        all.add(fixed("low-wall", 0.3, 5.2, 6, 5.55, 0, 0.8, ""));
        all.add(fixed("planter", 1.2, 2.4, 2, 3.2, 0, 0.5, "#9aa58f"));
        all.add(fixed("pedestal", 10.5, 1.4, 11.6, 2.5, 0, 1.5, ""));
        for (int k = 0; k < 12; k++) {
            double x = 9.4 - 0.35 * k;
            all.add(fixed("stair-" + (12 - k), x, 11.2, x + 0.35, 12.4, 0, 0.215 * (k + 1), ""));
        }
        all.add(new Obstacle("gallery", "Gallery", Polygon.rectangle(1, 11.2, 5.55, 12.4), 2.4, 0.2, false, 20, ""));
        all.add(new Obstacle("crate", "Crate", Polygon.rectangle(7.7, 7, 8.6, 8), 0, 1, true, 22, ""));
        all.add(new Obstacle("table", "Table", Polygon.rectangle(12.4, 8, 14.4, 9), 0.7, 0.06, false, 30, ""));
        all.add(new Obstacle("fountain", "", circle(12, 6.6, 0.6), 0, 0.6, false, 500, "#8fb7cc"));
        return new Scene(
                "Sketch",
                new World(18, 13, 18.0 / 256),
                all,
                List.of(new Ditch("canal", "Canal", Polygon.of(12.5, 3.4, 17.7, 2.7, 17.7, 1.7, 12.2, 2.5), 1.2)),
                List.of(Actor.standard("ann")),
                List.of(Journey.of("to-the-fountain", "ann", Place.of(1.1, 1.1), Place.of(11.1, 7.2))));
    }

    private static Obstacle fixed(
            String id, double x0, double y0, double x1, double y1, double offset, double height, String colour) {
        return new Obstacle(id, "", Polygon.rectangle(x0, y0, x1, y1), offset, height, false, 20, colour);
    }

    private static Polygon circle(double x, double y, double radius) {
        double[] at = new double[64];
        for (int i = 0; i < 32; i++) {
            at[2 * i] = x + radius * StrictMath.cos(Math.PI * i / 16);
            at[2 * i + 1] = y + radius * StrictMath.sin(Math.PI * i / 16);
        }
        return Polygon.of(at);
    }

    /** Returns a run that walks, vaults, sidesteps, strides, moves and walks, 25 frames a second. */
    public static Run run() {
        List<Run.Leg> legs = List.of(
                leg("walk", "", 0, 3, 1.1, 1.1, 0, 2.9, 3.9, 0, 3, 4.8, 0),
                leg("vault", "low-wall", 3, 4, 3, 4.8, 0, 3.3, 6.1, 0),
                leg("walk", "", 4, 6, 3.3, 6.1, 0, 4.3, 7.1, 0, 6, 7.3, 0),
                leg("sidestep", "", 6, 7, 6, 7.3, 0, 7.2, 7.4, 0),
                leg("move", "crate", 7, 9, 7.2, 7.4, 0, 8.4, 7.6, 0, 9.3, 8.1, 0),
                leg("stride", "", 9, 9.5, 9.3, 8.1, 0, 10.1, 8, 0),
                leg("walk", "", 9.5, 10, 10.1, 8, 0, 11.1, 7.2, 0));
        return new Run(
                scene(), "to-the-fountain", Outcome.FOUND, Report.builder().build(), frames(legs), legs, List.of());
    }

    /** Returns the run with the crate going along while it is moved: 2.1 m to the right, 0.7 m up, turned by 1.2 rad. */
    public static Run haul() {
        Run run = run();
        List<Channel> channels = new ArrayList<>(run.frames().channels());
        channels.add(new Channel("x", "m", Channel.Type.F64, "crate", 1));
        channels.add(new Channel("y", "m", Channel.Type.F64, "crate", 1));
        channels.add(new Channel("heading", "rad", Channel.Type.F64, "crate", 1));
        List<double[]> rows = new ArrayList<>();
        for (int frame = 0; frame < run.frames().count(); frame++) {
            double share = Math.max(0, Math.min(1, (frame / 25.0 - 7) / 2));
            double[] row = new double[channels.size()];
            for (int c = 0; c < row.length - 3; c++) {
                row[c] = run.frames().value(frame, c, 0);
            }
            row[row.length - 3] = 8.15 + 2.1 * share;
            row[row.length - 2] = 7.5 + 0.7 * share;
            row[row.length - 1] = 1.2 * share;
            rows.add(row);
        }
        Frames frames = frames(List.copyOf(channels), rows);
        return new Run(run.scene(), run.task(), run.outcome(), run.report(), frames, run.legs(), List.of());
    }

    private static Run.Leg leg(String ability, String what, double begin, double end, double... xyz) {
        List<double[]> points = new ArrayList<>();
        for (int i = 0; i < xyz.length; i += 3) {
            points.add(new double[] {xyz[i], xyz[i + 1], xyz[i + 2]});
        }
        return new Run.Leg("ann", ability, what, begin, end, 1, points);
    }

    private static Frames frames(List<Run.Leg> legs) {
        List<Channel> channels = List.of(
                new Channel("x", "m", Channel.Type.F64, "ann", 1),
                new Channel("y", "m", Channel.Type.F64, "ann", 1),
                new Channel("z", "m", Channel.Type.F64, "ann", 1),
                new Channel("heading", "rad", Channel.Type.F64, "ann", 1),
                new Channel("ability", "walk,sidestep,stride,vault,move", Channel.Type.U8, "ann", 1));
        List<double[]> rows = new ArrayList<>();
        for (int k = 0; k <= 250; k++) {
            rows.add(at(legs, k / 25.0));
        }
        return frames(channels, rows);
    }

    private static Frames frames(List<Channel> channels, List<double[]> rows) {
        return new Frames() {
            @Override
            public List<Channel> channels() {
                return channels;
            }

            @Override
            public double rate() {
                return 25;
            }

            @Override
            public int count() {
                return rows.size();
            }

            @Override
            public double value(int frame, int channel, int k) {
                return rows.get(frame)[channel];
            }
        };
    }

    private static double[] at(List<Run.Leg> legs, double time) {
        Run.Leg leg = legs.stream().filter(l -> time <= l.end()).findFirst().orElseThrow();
        double share =
                (time - leg.begin()) / (leg.end() - leg.begin()) * (leg.points().size() - 1);
        int k = Math.min((int) share, leg.points().size() - 2);
        double[] a = leg.points().get(k);
        double[] b = leg.points().get(k + 1);
        double s = share - k;
        int ability = List.of("walk", "sidestep", "stride", "vault", "move").indexOf(leg.ability());
        return new double[] {
            a[0] + s * (b[0] - a[0]),
            a[1] + s * (b[1] - a[1]),
            a[2] + s * (b[2] - a[2]),
            StrictMath.atan2(b[1] - a[1], b[0] - a[0]),
            ability
        };
    }

    /** Returns a field of distances to the goal, without values inside what stands on the ground. */
    public static Overlay.Field potential() {
        GridFrame frame = GridFrame.of(scene().world());
        float[] values = new float[frame.size()];
        for (int i = 0; i < values.length; i++) {
            double x = frame.centreX(frame.col(i));
            double y = frame.centreY(frame.row(i));
            values[i] = blocked(x, y) ? Float.NaN : (float) Math.hypot(x - 11.1, y - 7.2);
        }
        return new Overlay.Field("potential", 0, frame, values, new Overlay.Continuous("m", 0, 12, 1));
    }

    /** Returns a field of five categories: classes of configurations, by hand. */
    public static Overlay.Field classes() {
        GridFrame frame = GridFrame.of(scene().world());
        float[] values = new float[frame.size()];
        for (int i = 0; i < values.length; i++) {
            double x = frame.centreX(frame.col(i));
            double y = frame.centreY(frame.row(i));
            boolean vault = Math.abs(y - 5.375) < 0.43 && x > 0.55 && x < 6.2;
            boolean gap = scene().ditches().get(0).outline().contains(x, y) && x > 14;
            values[i] = vault ? 3 : gap ? 2 : blocked(x, y) ? 4 : y > 11 && x > 5.5 && x < 9.8 ? 1 : 0;
        }
        List<String> words = List.of("stable", "border", "gap", "jumpable", "forbidden");
        return new Overlay.Field("class", 0, frame, values, new Overlay.Categories(words));
    }

    private static boolean blocked(double x, double y) {
        return x < 0
                || y < 0
                || x > 18
                || y > 13
                || SOLID.stream().anyMatch(o -> o.outline().bounds().grown(0.25).contains(x, y));
    }

    private static final List<Obstacle> SOLID = scene().obstacles().stream()
            .filter(o -> o.offset() == 0 && o.height() > 0.3 && !o.movable())
            .toList();

    /** Returns two lines of a skeleton. */
    public static Overlay.Lines skeleton() {
        return new Overlay.Lines(
                "skeleton", 0, List.of(new double[] {1.1, 1.1, 3, 3, 7, 3, 7, 7.5, 9, 7.5, 11.1, 7.2}, new double[] {
                    7, 7.5, 7, 10.8, 16.5, 11.5, 16.6, 4, 12, 3.8, 7, 3
                }));
    }

    /** Returns a handful of trigger points around the crate. */
    public static Overlay.Points triggers() {
        return new Overlay.Points("trigger-points", 0, new double[] {7.4, 7.1, 7.4, 7.5, 7.4, 7.9, 8.9, 7.2, 8.9, 7.8});
    }

    /** Returns what a search shows that moves the crate: trigger points, the expected path, the poses that bar it. */
    public static List<Overlay> moving() {
        GridFrame frame = GridFrame.of(scene().world());
        float[] values = new float[frame.size()];
        for (int i = 0; i < values.length; i++) {
            double x = frame.centreX(frame.col(i));
            double y = frame.centreY(frame.row(i));
            values[i] = x > 7 && x < 11.5 && Math.abs(y - 7.4) < 0.7 ? 0 : Float.NaN;
        }
        return List.of(
                new Overlay.Field("instance", 0, frame, values, new Overlay.Categories(List.of("bars-path"))),
                new Overlay.Points("triggers", 0, triggers().coordinates()),
                new Overlay.Lines("expected-path", 0, List.of(new double[] {7.4, 7.5, 9, 7.5, 11.1, 7.2})));
    }
}
