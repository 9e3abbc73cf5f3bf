package troupe.unified;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import troupe.geometry.Polygon;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Ditch;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Replays a run against the polygons with code of its own: in every frame the body's cylinder meets no
 * solid, and the feet stand on something. Steps of the grid that smoothing had to keep may come nearer by
 * what it documents, and feet smaller than a step of the grid may miss a narrow drop.
 */
final class RunCheck {
    private static final double SLACK = 1e-6;
    private static final int ROUND = 24;
    private static final int BETWEEN = 4;
    private static final double TURNED = 2e-4;

    private final Scene scene;
    private final Actor actor;
    private final Frames frames;
    private final Run run;
    private final String which;

    private final boolean exact;
    private final HaulCheck hauls;

    /** The obstacles where they stand in the frame that is looked at. */
    private List<Obstacle> obstacles;

    /** What may come near in that frame: an obstacle that is moved without a grip. */
    private String spared = "";

    private RunCheck(Run run, Actor actor, String which, boolean exact) {
        this.exact = exact;
        this.scene = run.scene();
        this.actor = actor;
        this.frames = run.frames();
        this.run = run;
        this.which = which;
        this.hauls = new HaulCheck(run, which);
    }

    /** Fails with the frame and what it meets if the run collides anywhere, steps of the grid as documented. */
    static void assertCollisionFree(Run run, Actor actor, String which) {
        new RunCheck(run, actor, which, false).all();
    }

    /** Fails if any frame comes nearer to anything than the radius of its ability. */
    static void assertKeepsRadius(Run run, Actor actor, String which) {
        new RunCheck(run, actor, which, true).all();
    }

    private void all() {
        for (int frame = 0; frame < run.frames().count(); frame++) {
            obstacles = hauls.at(frame, 0);
            frame(frame);
            for (int k = 0; k < BETWEEN; k++) {
                hauls.check(frame, k / (double) BETWEEN);
            }
        }
    }

    private void frame(int f) {
        double x = frames.value(f, 0, 0);
        double y = frames.value(f, 1, 0);
        double z = frames.value(f, 2, 0);
        switch (Ability.values()[(int) frames.value(f, 4, 0)]) {
            case WALK -> standing(f, x, y, z, actor.walk().radius());
            case SIDESTEP -> standing(f, x, y, z, actor.sidestep().orElseThrow().radius());
            case STRIDE -> striding(f, x, y, z);
            case VAULT -> vaulting(f, x, y, z);
            case MOVE -> moving(f, x, y, z);
        }
    }

    /** Without a grip nothing is asked of the actor's distance from what it moves; with one a turn may take 0.1 mm. */
    private void moving(int f, double x, double y, double z) {
        boolean grips = run.scene().task(run.task()).orElseThrow() instanceof Journey journey
                && journey.manipulation() == Journey.Manipulation.GRIP;
        double time = f / frames.rate();
        for (Run.Leg leg : run.legs()) {
            boolean now = time >= leg.begin() - SLACK && time <= leg.end() + SLACK;
            if (now && !grips && leg.ability().equals(Ability.MOVE.key())) {
                spared = leg.what();
            }
        }
        solids(
                f,
                x,
                y,
                z + actor.stepHeight(),
                z + actor.bodyHeight(),
                actor.walk().radius() - TURNED);
        spared = "";
    }

    private void standing(int f, double x, double y, double z, double radius) {
        double least = least(radius);
        double under = floor(x, y, z + actor.stepHeight() + SLACK);
        boolean covered = actor.footRadius() >= scene.world().cell() * Math.sqrt(0.5);
        if (covered && z > under + actor.stepHeight() + SLACK) {
            fail(at(f, x, y, z) + " floats over the floor at " + under);
        }
        solids(f, x, y, z + actor.stepHeight(), z + actor.bodyHeight(), least);
        for (int k = 0; k < ROUND; k++) {
            double cos = Math.cos(2 * Math.PI * k / ROUND);
            double sin = Math.sin(2 * Math.PI * k / ROUND);
            if (ground(x + least * cos, y + least * sin) > z + actor.stepHeight() + SLACK) {
                fail(at(f, x, y, z) + " meets the wall of a ditch");
            }
            double foot = Math.max(0, least(actor.footRadius()) - SLACK);
            double floor = floor(x + foot * cos, y + foot * sin, z + actor.stepHeight() + SLACK);
            if (floor < under - actor.stepHeight() - SLACK) {
                fail(at(f, x, y, z) + " stands over a drop to " + floor);
            }
        }
    }

    private void striding(int f, double x, double y, double z) {
        double from = takeOff(f);
        double low = Math.max(z, from) + actor.stepHeight();
        solids(
                f,
                x,
                y,
                low,
                Math.min(z, from) + actor.bodyHeight(),
                actor.walk().radius());
    }

    private void vaulting(int f, double x, double y, double z) {
        double from = takeOff(f);
        Actor.Vault vault = actor.vault().orElseThrow();
        for (Obstacle o : obstacles) {
            boolean inTheWay = o.top() > from + actor.stepHeight() + SLACK
                    && o.offset() < z + vault.bodyHeight() - SLACK
                    && distance(o.outline(), x, y) < actor.walk().radius() - SLACK;
            if (!inTheWay) {
                continue;
            }
            boolean vaultable =
                    o.top() >= from + vault.minHeight() - SLACK && o.top() <= from + vault.maxHeight() + SLACK;
            if (!vaultable && distance(o.outline(), x, y) < least(actor.walk().radius()) - SLACK) {
                fail(at(f, x, y, z) + " vaults through " + o.id() + ", " + o.offset() + " to " + o.top());
            }
            if (o.outline().contains(x, y) && z < o.top() - SLACK) {
                fail(at(f, x, y, z) + " vaults below the top of " + o.id() + " at " + o.top());
            }
        }
    }

    /** Returns the take-off floor of the crossing that is under way in a frame, or was the last. */
    private double takeOff(int f) {
        double time = f / frames.rate();
        double floor = Double.NaN;
        for (Run.Leg leg : run.legs()) {
            if (time >= leg.begin() - SLACK && leg.ability().matches("stride|vault")) {
                floor = leg.points().get(0)[2];
            }
        }
        return floor;
    }

    /** What is left of a radius on a step of the grid whose ends keep it. */
    private double least(double radius) {
        double half = scene.world().cell() * Math.sqrt(0.5);
        if (exact) {
            return radius;
        }
        return radius > half ? Math.sqrt(radius * radius - half * half) : 0;
    }

    private void solids(int f, double x, double y, double low, double high, double radius) {
        for (Obstacle o : obstacles) {
            double from = o.movable() ? low - actor.stepHeight() : low;
            if (o.top() > from + SLACK && o.offset() < high - SLACK && !o.id().equals(spared)) {
                double distance = distance(o.outline(), x, y);
                if (distance < radius - SLACK || o.outline().contains(x, y)) {
                    fail(at(f, x, y, low - actor.stepHeight()) + " is " + distance + " m from " + o.id());
                }
            }
        }
        double edge = Math.min(
                Math.min(x, y),
                Math.min(scene.world().width() - x, scene.world().depth() - y));
        if (edge < radius - SLACK) {
            fail(at(f, x, y, low - actor.stepHeight()) + " is " + edge + " m from the edge of the world");
        }
    }

    private double ground(double x, double y) {
        double ground = 0;
        for (Ditch d : scene.ditches()) {
            ground = d.outline().contains(x, y) ? Math.min(ground, -d.depth()) : ground;
        }
        return ground;
    }

    private double floor(double x, double y, double reach) {
        double floor = ground(x, y);
        for (Obstacle o : scene.obstacles()) {
            floor = !o.movable() && o.top() <= reach && o.outline().contains(x, y) ? Math.max(floor, o.top()) : floor;
        }
        return floor;
    }

    private static double distance(Polygon p, double x, double y) {
        if (p.contains(x, y)) {
            return 0;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < p.size(); i++) {
            int j = (i + 1) % p.size();
            double ex = p.x(j) - p.x(i);
            double ey = p.y(j) - p.y(i);
            double share = ((x - p.x(i)) * ex + (y - p.y(i)) * ey) / (ex * ex + ey * ey);
            double t = Math.max(0, Math.min(1, share));
            least = Math.min(least, Math.hypot(x - p.x(i) - t * ex, y - p.y(i) - t * ey));
        }
        return least;
    }

    private String at(int f, double x, double y, double z) {
        return which + ", frame " + f + " at (" + x + ", " + y + ", " + z + ")";
    }

    /** Returns what the report of a run tells, without the times. */
    static Map<String, Object> untimed(Run run) {
        Map<String, Object> values = new TreeMap<>(run.report().values());
        values.remove("times_ms");
        return values;
    }
}
