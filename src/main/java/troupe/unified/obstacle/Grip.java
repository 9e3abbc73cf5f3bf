package troupe.unified.obstacle;

import troupe.geometry.Line;
import troupe.geometry.Polygon;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.scene.Actor;

/**
 * Holds an obstacle: the actor stands at its trigger and moves rigidly with the obstacle. It passes only
 * configurations of the region without the obstacle that are joined by legal steps, stable and open to
 * walking, and its body keeps its radius from everything else, checked on the polygons. It can let go where
 * it can walk on to the centre of its cell with the obstacle in its new place. Used by one thread at a time.
 *
 * <p>Between two floors a motion is checked on both. Turns are checked along chords that leave the arc by
 * no more than 0.1 mm, and as much is taken off the radius.
 */
public final class Grip {
    private static final double SAGITTA = 1e-4;
    private static final double SLACK = 1e-9;

    private final Movable movable;
    private final Region without;
    private final Actor actor;
    private final Spaces spaces;
    private final GridFrame frame;
    private final Turns turns;
    private final BodyRoom room;
    private final int chords;
    private final double sweep;
    private final int cells;
    private final int[] targets = new int[Region.MAX_NEIGHBOURS];
    private final int[] directions = new int[Region.MAX_NEIGHBOURS];
    private final int[] passed;

    private int stand;
    private int i;
    private int j;
    private int k;
    private double x;
    private double y;
    private double distance;

    /** Knows what the search space is like in which the obstacle has been put somewhere else. */
    public interface Spaces {
        /**
         * Tells whether the actor can stand and walk at a configuration with the obstacle at a pose, and get from
         * there to a place of the expected path.
         */
        boolean goesOn(LatticePose pose, int configuration);
    }

    /**
     * Takes hold of an obstacle.
     *
     * @param surroundings where everything stands
     * @param without the region of that space without the obstacle
     * @param trigger the span on which the actor stands, at the centre of its cell
     * @param spaces tells what comes after the move; asked only where the obstacle bars nothing any more
     */
    public Grip(Movable movable, Surroundings surroundings, Region without, int trigger, Spaces spaces) {
        this.movable = movable;
        this.without = without;
        this.actor = without.actor();
        this.spaces = spaces;
        this.frame = without.frame();
        this.cells = frame.size();
        this.turns = new Turns(frame, movable, without.x(trigger), without.y(trigger));
        double part = movable.turn() / turns.parts();
        double flat = 2 * StrictMath.acos(Math.max(-1, 1 - SAGITTA / Math.max(turns.lever(), SAGITTA)));
        this.chords = (int) Math.max(1, Math.ceil(part / flat));
        this.sweep = 2 * turns.lever() * StrictMath.sin(Math.min(movable.turn(), Math.PI) / 2);
        this.room = surroundings.room(movable, actor, Math.max(frame.stepLength(4), sweep));
        this.passed = new int[turns.parts() + 1];
    }

    /** Returns how many spans can lie above each other. */
    public int sheets() {
        return without.spans().sheets();
    }

    /** Returns which of the spans above each other a configuration is. */
    public int sheet(int configuration) {
        return configuration / cells;
    }

    /** Returns the straight steps that the actor takes in the turn from heading {@code lower} to the next. */
    public int straightSteps(int lower) {
        return turns.straight(lower);
    }

    /** Returns the diagonal steps that the actor takes in the turn from heading {@code lower} to the next. */
    public int diagonalSteps(int lower) {
        return turns.diagonal(lower);
    }

    /** Chooses the configuration of the actor and the pose of the obstacle from which moves are asked for. */
    public void choose(int configuration, int toI, int toJ, int toK) {
        stand = configuration;
        i = toI;
        j = toJ;
        k = toK;
        x = turns.x(k) + i * movable.cell();
        y = turns.y(k) + j * movable.cell();
        distance = Double.NaN;
    }

    /** Returns the configuration after a step in a direction, -1 if it cannot be taken. */
    public int shifted(int direction) {
        return step(stand, direction);
    }

    private int step(int from, int direction) {
        if (without.plain(from)) {
            int to = from + GridFrame.dy(direction) * frame.cols() + GridFrame.dx(direction);
            return (without.moves(from) >> direction & 1) != 0 && without.takesOff(to) ? to : -1;
        }
        int count = without.neighbours(from, targets, directions);
        for (int n = 0; n < count; n++) {
            if (directions[n] == direction && without.takesOff(targets[n])) {
                return targets[n];
            }
        }
        return -1;
    }

    /** Returns the configuration after a turn by one heading, -1 if a step on its way cannot be taken. */
    public int turned(boolean counterClockwise) {
        int headings = movable.headings();
        int lower = counterClockwise ? k : (k == 0 ? headings : k) - 1;
        byte[] steps = turns.steps(lower);
        int at = stand;
        passed[0] = at;
        for (int part = 0; part < steps.length; part++) {
            byte direction = counterClockwise ? steps[part] : opposite(steps[steps.length - 1 - part]);
            if (direction != -1) {
                at = direction < 0 ? -1 : step(at, direction);
            }
            if (at < 0) {
                return -1;
            }
            passed[part + 1] = at;
        }
        return at;
    }

    private static byte opposite(byte direction) {
        return direction < 0 ? direction : (byte) (direction & 4 | direction + 2 & 3);
    }

    /** Tells whether the body has room for a step in a direction that leads to a configuration. */
    public boolean canShift(int direction, int to) {
        double radius = actor.walk().radius();
        double from = without.elevation(stand);
        double floor = without.elevation(to);
        if (floor == from && distance() - frame.stepLength(direction) >= radius) {
            return true;
        }
        double bx = x + GridFrame.dx(direction) * movable.cell();
        double by = y + GridFrame.dy(direction) * movable.cell();
        return isFree(x, y, bx, by, from, floor, radius - SLACK);
    }

    private boolean isFree(double ax, double ay, double bx, double by, double from, double to, double least) {
        return room.isFree(ax, ay, bx, by, from, least)
                && (from == to || room.isFree(ax, ay, bx, by, to, least) && !room.isInside(bx, by, to));
    }

    /** Tells whether the body has room for the turn that {@link #turned} was asked for last. */
    public boolean canTurn(boolean counterClockwise) {
        double radius = actor.walk().radius();
        if (distance() - sweep >= radius && isLevel()) {
            return true;
        }
        double least = radius - SAGITTA - SLACK;
        int parts = turns.parts();
        double step = (counterClockwise ? 1 : -1) * movable.turn() / (parts * chords);
        double centreX = movable.centroid().x() + i * movable.cell();
        double centreY = movable.centroid().y() + j * movable.cell();
        double armX = x - centreX;
        double armY = y - centreY;
        double ax = x;
        double ay = y;
        for (int n = 1; n <= parts * chords; n++) {
            double cos = StrictMath.cos(n * step);
            double sin = StrictMath.sin(n * step);
            double bx = centreX + cos * armX - sin * armY;
            double by = centreY + sin * armX + cos * armY;
            int part = (n - 1) / chords;
            double from = without.elevation(passed[part]);
            double to = without.elevation(passed[part + 1]);
            if (!isFree(ax, ay, bx, by, from, to, least)) {
                return false;
            }
            ax = bx;
            ay = by;
        }
        return true;
    }

    private boolean isLevel() {
        double floor = without.elevation(stand);
        for (int q : passed) {
            if (without.elevation(q) != floor) {
                return false;
            }
        }
        return true;
    }

    /** Returns how far anything in the way is from the body's middle at least; measured once for each pose. */
    private double distance() {
        if (Double.isNaN(distance)) {
            double most = actor.walk().radius() + Math.max(frame.stepLength(4), sweep);
            distance = room.distance(x, y, without.elevation(stand), most + SLACK);
        }
        return distance;
    }

    /**
     * Tells whether the actor can let go: in the space with the obstacle at the pose it can stand and walk
     * where it is, its body has room on the way to the centre of its cell, and it can go on from there: else it
     * might pull the obstacle after itself into a dead end.
     */
    public boolean settles(int configuration, int toI, int toJ, int toK) {
        choose(configuration, toI, toJ, toK);
        double radius = actor.walk().radius();
        double floor = without.elevation(configuration);
        double toX = without.x(configuration);
        double toY = without.y(configuration);
        if (!room.isFree(x, y, toX, toY, floor, radius - SLACK)) {
            return false;
        }
        LatticePose pose = new LatticePose(i, j, k);
        if (movable.meets(floor, actor.bodyHeight())) {
            Polygon outline = movable.outline(pose);
            if (outline.contains(toX, toY) || new Line(x, y, toX, toY).distance(outline) < radius - SLACK) {
                return false;
            }
        }
        return spaces.goesOn(pose, configuration);
    }
}
