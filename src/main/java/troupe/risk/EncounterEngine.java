package troupe.risk;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import troupe.grid.GridLimitException;
import troupe.grid.region.Region;
import troupe.risk.forecast.Ways;
import troupe.risk.plan.Ground;
import troupe.run.Inputs;
import troupe.run.Run;
import troupe.run.Simulation;
import troupe.run.frame.Frames;
import troupe.run.view.Ahead;
import troupe.run.view.Aspect;
import troupe.run.view.Overlay;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Quantity;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.search.Outcome;

/**
 * Simulates an encounter: at every step the avatars move, the actor follows its plan, looks, and revises it. A
 * unit of work is a step, which makes a frame; step 0 shows where all begin and the first plan. The times in the
 * report are wall time; everything else depends on scene, task and inputs only.
 */
public final class EncounterEngine implements Simulation {
    private static final String PREFIX = "avatar.";

    private final Scene scene;
    private final Encounter encounter;
    private final Actor actor;
    private final List<Course> courses;
    private final EncounterFrames frames;
    private final EncounterReport report;
    private final Inputs inputs = new Inputs();
    private final boolean[] touching;
    private Outcome outcome = Outcome.RUNNING;
    private Ground ground;
    private Ways ways;
    private Thinking thinking;
    private double x;
    private double y;
    private int q;
    private double heading;
    private long steps;

    private EncounterEngine(Scene scene, Encounter encounter, Actor actor) {
        this.scene = scene;
        this.encounter = encounter;
        this.actor = actor;
        this.courses = encounter.avatars().stream().map(Course::of).toList();
        this.frames = new EncounterFrames(encounter, actor);
        this.report = new EncounterReport(encounter);
        this.touching = new boolean[courses.size()];
        this.x = encounter.start().x();
        this.y = encounter.start().y();
    }

    /**
     * Prepares an encounter of a scene; no work is done yet.
     *
     * @throws IllegalArgumentException if the scene lacks the actor
     */
    public static EncounterEngine of(Scene scene, Encounter encounter) {
        Actor actor = scene.actor(encounter.actor())
                .orElseThrow(() -> new IllegalArgumentException("encounter '" + encounter.id() + "' is of the actor '"
                        + encounter.actor() + "'; needs the id of an actor of the scene"));
        return new EncounterEngine(scene, encounter, actor);
    }

    @Override
    public List<Control> controls() {
        List<Control> controls = new ArrayList<>();
        for (Avatar avatar : encounter.avatars()) {
            if (avatar.motion() instanceof Avatar.Pointer pointer) {
                Place start = pointer.start();
                String key = PREFIX + avatar.id();
                controls.add(new Control(
                        key + ".x", avatar.id(), "m", 0, scene.world().width(), start.x()));
                controls.add(new Control(
                        key + ".y", avatar.id(), "m", 0, scene.world().depth(), start.y()));
            }
        }
        return controls;
    }

    @Override
    public void give(Run.Input input) {
        inputs.give(input, controls(), steps);
    }

    @Override
    public Outcome step(long budget) {
        if (budget < 1) {
            throw new IllegalArgumentException("budget=" + budget + "; needs at least 1");
        }
        try {
            for (long left = budget; left > 0 && outcome.isRunning(); left--) {
                if (thinking == null) {
                    prepare();
                }
                if (outcome.isRunning()) {
                    simulate();
                }
            }
        } catch (GridLimitException tooMuch) {
            outcome = new Outcome.Infeasible(tooMuch.getMessage());
        }
        return outcome;
    }

    private void prepare() {
        long begin = System.nanoTime();
        ground = new Ground(scene, actor, encounter.goal());
        Region region = ground.region();
        q = region.locate(encounter.start());
        if (q < 0 || !region.open(q)) {
            outcome = none("the start", encounter.start());
        } else if (ground.goal() < 0 || !region.open(ground.goal())) {
            outcome = none("the goal", encounter.goal());
        } else if (!ground.leads(q)) {
            outcome = new Outcome.Infeasible("no path: walls keep start and goal apart");
        } else {
            ways = EncounterViews.ways(scene);
            thinking = new Thinking(encounter, actor.walk().radius(), ground, ways, courses);
        }
        report.prepared(System.nanoTime() - begin);
    }

    private static Outcome none(String what, Place place) {
        return new Outcome.Infeasible(String.format(
                Locale.ROOT,
                "no path: %s (%.2f, %.2f) is in or too near to a wall; it takes the actor's radius and a cell",
                what,
                place.x(),
                place.y()));
    }

    private void simulate() {
        double now = steps / encounter.number(Quantity.RATE);
        inputs.take(steps, this::steer);
        courses.forEach(course -> course.goOn(1 / encounter.number(Quantity.RATE)));
        for (int a = 0; a < courses.size(); a++) {
            thinking.see(a, now, courses.get(a).x(now), courses.get(a).y(now));
        }
        if (steps > 0) {
            follow(now);
        }
        meet(now);
        long begin = System.nanoTime();
        Action action = thinking.decide(now, x, y, q);
        report.decided(action, System.nanoTime() - begin, thinking.expanded());
        double risk = thinking.risk(now);
        report.risk(risk);
        frames.add(new EncounterFrames.State(x, y, heading, risk, action), thinking.path(), courses, now);
        steps++;
        if (arrived()) {
            outcome = Outcome.FOUND;
        } else if (steps > encounter.number(Quantity.DURATION) * encounter.number(Quantity.RATE)) {
            outcome = Outcome.EXHAUSTED;
        }
    }

    private void steer(Run.Input input) {
        for (int a = 0; a < courses.size(); a++) {
            String key = PREFIX + encounter.avatars().get(a).id();
            Course course = courses.get(a);
            if (input.key().equals(key + ".x")) {
                course.sendToX(input.value());
            } else if (input.key().equals(key + ".y")) {
                course.sendToY(input.value());
            }
        }
    }

    /** Goes on along the plan. */
    private void follow(double now) {
        double toX = thinking.path().xAt(now);
        double toY = thinking.path().yAt(now);
        double dx = toX - x;
        double dy = toY - y;
        double way = Math.sqrt(dx * dx + dy * dy);
        if (way > 1e-9) {
            heading = StrictMath.atan2(dy, dx);
        }
        x = toX;
        y = toY;
        q = ground.near(x, y, thinking.path().qAt(now));
        report.walked(way, x, y);
    }

    private void meet(double now) {
        for (int a = 0; a < courses.size(); a++) {
            double dx = courses.get(a).x(now) - x;
            double dy = courses.get(a).y(now) - y;
            double apart = Math.sqrt(dx * dx + dy * dy);
            double bodies = actor.walk().radius() + encounter.avatars().get(a).radius();
            boolean touches = apart < bodies - 1e-9;
            if (!Double.isNaN(apart)) {
                report.apart(apart, apart - bodies, touches && !touching[a]);
            }
            touching[a] = touches;
        }
    }

    private boolean arrived() {
        double dx = encounter.goal().x() - x;
        double dy = encounter.goal().y() - y;
        return dx * dx + dy * dy < 1e-12;
    }

    @Override
    public Outcome outcome() {
        return outcome;
    }

    @Override
    public void cancel() {
        if (outcome.isRunning()) {
            outcome = Outcome.CANCELLED;
        }
    }

    @Override
    public Progress progress() {
        return new Progress(steps, outcome.isRunning() ? Double.NaN : 1);
    }

    @Override
    public List<Overlay> overlays() {
        return overlays(List.of());
    }

    @Override
    public List<Aspect> aspects(List<Integer> chosen) {
        return List.of(EncounterViews.ahead(encounter));
    }

    @Override
    public List<Overlay> overlays(List<Integer> chosen) {
        if (thinking == null) {
            return List.of();
        }
        int choice = chosen.isEmpty() ? 0 : chosen.get(0);
        double ahead = Ahead.seconds(encounter.number(Quantity.HORIZON), choice);
        Frames recorded = frames.frames();
        return new EncounterViews(scene, encounter, recorded, ways).overlays(recorded.count() - 1, ahead);
    }

    @Override
    public Run run() {
        return new Run(
                scene,
                encounter.id(),
                outcome,
                report.build(outcome.isFound(), frames.frames()),
                frames.frames(),
                frames.legs(),
                inputs.all());
    }
}
