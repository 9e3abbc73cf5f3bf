package troupe.risk.plan;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import troupe.grid.GridFrame;
import troupe.grid.field.Nf1;
import troupe.grid.region.Region;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.search.BucketQueue;

/**
 * Holds what does not move: the region of an actor that only walks, and over it the potential of the goal and the
 * ways to it. The region is that of a disc wider by half a cell's diagonal, so that the actor has room anywhere in
 * an open cell, not only at its middle. Immutable but for scratch; used by one thread at a time.
 */
public final class Ground {
    /** Ticks of a straight and of a diagonal move; a tick is the time of a fifth of a cell. */
    static final int STRAIGHT = 5;

    static final int DIAGONAL = 7;
    /** Ticks of a wait. */
    static final int WAIT = 5;

    private final Region region;
    private final GridFrame frame;
    private final double speed;
    private final int goal;
    private final Place goalPlace;
    private final float[] potential;
    private final int[] ticksToGo;
    private final int[] targets = new int[Region.MAX_NEIGHBOURS];
    private final int[] directions = new int[Region.MAX_NEIGHBOURS];

    /**
     * Builds the ground of an actor and a goal. Cost O(cells).
     *
     * @param radius of the disc in metres
     * @param speed of walking in m/s, above 0
     */
    public Ground(Scene scene, Actor actor, Place goalPlace) {
        this.region = Region.of(scene, wider(actor, scene.world().cell() * Math.sqrt(0.5)));
        this.frame = region.frame();
        this.speed = actor.walk().speed();
        this.goalPlace = goalPlace;
        this.goal = region.locate(goalPlace);
        boolean there = goal >= 0 && region.open(goal);
        this.potential = there ? Nf1.compute(region, goal) : new float[0];
        this.ticksToGo = there ? ticks() : new int[0];
    }

    private static Actor wider(Actor actor, double by) {
        Set<Ability> others = EnumSet.complementOf(EnumSet.of(Ability.WALK));
        Actor.Walk walk = actor.walk();
        return new Actor(
                        actor.id(),
                        "",
                        "",
                        actor.bodyHeight(),
                        actor.footRadius(),
                        actor.stepHeight(),
                        actor.maxBorder(),
                        new Actor.Walk(walk.radius() + by, walk.energy(), walk.speed()),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty())
                .without(others);
    }

    /** Finds the ticks of the shortest way to the goal from everywhere. */
    private int[] ticks() {
        int[] ticks = new int[region.size()];
        Arrays.fill(ticks, Integer.MAX_VALUE);
        BucketQueue open = new BucketQueue(0);
        ticks[goal] = 0;
        open.add(goal, 0, 0);
        while (!open.isEmpty()) {
            long key = open.firstKey();
            int q = open.removeFirst();
            if (key != ticks[q]) {
                continue;
            }
            int count = region.neighbours(q, targets, directions);
            for (int k = 0; k < count; k++) {
                int cost = ticks[q] + (directions[k] < 4 ? STRAIGHT : DIAGONAL);
                if (cost < ticks[targets[k]]) {
                    ticks[targets[k]] = cost;
                    open.add(targets[k], cost, 0);
                }
            }
        }
        return ticks;
    }

    /** Returns the region. */
    public Region region() {
        return region;
    }

    /** Returns the walking speed in m/s. */
    public double speed() {
        return speed;
    }

    /** Returns the seconds of a tick. */
    public double tick() {
        return frame.cell() / (STRAIGHT * speed);
    }

    /** Returns the configuration of the goal, -1 if there is no floor. */
    public int goal() {
        return goal;
    }

    /** Returns the place of the goal. */
    public Place goalPlace() {
        return goalPlace;
    }

    /** Tells whether one can stand at the goal, and come there from a configuration. */
    public boolean leads(int from) {
        return potential.length > 0 && from >= 0 && potential[from] < Nf1.UNREACHABLE;
    }

    /** Returns the NF1 potential of a configuration in metres. */
    public float potential(int q) {
        return potential[q];
    }

    /** Returns the ticks of the shortest way from a configuration to the goal. */
    public int ticksToGo(int q) {
        return ticksToGo[q];
    }

    /**
     * Follows the straight line from a place over open cells and legal steps.
     *
     * @param q the configuration of the first place
     * @return the configuration of the second place, -1 if the line leads through something
     */
    public int follow(double x0, double y0, int q, double x1, double y1) {
        double dx = x1 - x0;
        double dy = y1 - y0;
        int pieces = (int) Math.max(1, Math.ceil(Math.sqrt(dx * dx + dy * dy) / (0.4 * frame.cell())));
        int at = q;
        for (int k = 1; k <= pieces && at >= 0; k++) {
            double share = (double) k / pieces;
            at = stepTo(at, frame.cellAt(x0 + share * dx, y0 + share * dy));
        }
        return at;
    }

    private int stepTo(int q, int cell) {
        int from = region.cell(q);
        if (cell == from) {
            return q;
        }
        int dx = frame.col(cell) - frame.col(from);
        int dy = frame.row(cell) - frame.row(from);
        int direction = -1;
        for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
            direction = GridFrame.dx(d) == dx && GridFrame.dy(d) == dy ? d : direction;
        }
        if (cell < 0 || direction < 0) {
            return -1;
        }
        int count = region.neighbours(q, targets, directions);
        for (int k = 0; k < count; k++) {
            if (directions[k] == direction) {
                return targets[k];
            }
        }
        return -1;
    }

    /** Finds the configuration of a place near one: its cell on the same floors, or else the one given. */
    public int near(double x, double y, int q) {
        int found = stepTo(q, frame.cellAt(x, y));
        return found < 0 ? q : found;
    }
}
