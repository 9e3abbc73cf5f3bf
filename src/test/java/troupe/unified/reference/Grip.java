package troupe.unified.reference;

import java.util.ArrayDeque;
import java.util.List;
import troupe.geometry.Polygon;
import troupe.scene.Obstacle;

/**
 * Carries an actor along that holds an obstacle: from cell to cell by legal steps of the space without the
 * obstacle, and as a disc among the polygons.
 */
final class Grip {
    private static final double SLACK = 1e-9;
    private static final double SAGITTA = 1e-4;

    private final Ground ground;
    private final Space without;
    private final Mover mover;
    private final int obstacle;
    private final double[] held;
    private final double lever;

    /** What a move does to the actor: where it stands afterwards, and the steps that it takes. */
    record Carried(int stand, int straight, int diagonal) {}

    /**
     * Takes hold of an obstacle.
     *
     * @param without the space without the obstacle
     * @param trigger where the actor stands
     */
    Grip(Space without, Mover mover, int obstacle, int trigger) {
        this.ground = without.ground;
        this.without = without;
        this.mover = mover;
        this.obstacle = obstacle;
        int at = ground.cellOf(trigger);
        held = new double[] {ground.x(at), ground.y(at)};
        lever = Math.hypot(held[0] - mover.centroid[0], held[1] - mover.centroid[1]);
    }

    /** Returns the cell in which the actor is after a shift of whole cells and a turn. */
    private int cell(Mover.Pose pose, double angle) {
        double[] home = mover.turned(0, 0, angle, held[0], held[1]);
        int at = ground.cellAt(home[0], home[1]);
        int col = (int) Math.floor(home[0] / ground.cell) + 1 + pose.i();
        int row = (int) Math.floor(home[1] / ground.cell) + 1 + pose.j();
        boolean inside = col >= 0 && row >= 0 && col < ground.cols && row < ground.cells / ground.cols;
        return inside ? at + pose.j() * ground.cols + pose.i() : -1;
    }

    /** Returns the squared distance in cells from where the actor stands to a cell. */
    long far(int stand, int at) {
        long dx = ground.cellOf(stand) % ground.cols - at % ground.cols;
        long dy = ground.cellOf(stand) / ground.cols - at / ground.cols;
        return dx * dx + dy * dy;
    }

    /** Returns where a move of the obstacle carries the actor, null if it cannot go along. */
    Carried carried(Mover.Pose pose, int stand, int move) {
        if (!without.firm(stand)) {
            return null;
        }
        return move < 8 ? shifted(pose, stand, move) : turned(pose, stand, move == 8);
    }

    private Carried shifted(Mover.Pose pose, int stand, int direction) {
        int at = stand % ground.cells + Space.DY[direction] * ground.cols + Space.DX[direction];
        int to = without.stepToSpan(stand, at);
        if (to < 0 || !without.firm(to)) {
            return null;
        }
        double[] from = mover.carried(pose, held[0], held[1]);
        double[] line = {
            from[0], from[1], from[0] + Space.DX[direction] * ground.cell, from[1] + Space.DY[direction] * ground.cell
        };
        return clear(without.outlines, line, ground.floor[stand], SLACK)
                        && clear(without.outlines, line, ground.floor[to], SLACK)
                ? new Carried(to, direction < 4 ? 1 : 0, direction < 4 ? 0 : 1)
                : null;
    }

    private Carried turned(Mover.Pose pose, int stand, boolean counterClockwise) {
        double by = counterClockwise ? mover.angle(1) : -mover.angle(1);
        double from = mover.angle(pose.k());
        int parts = Math.max(1, (int) Math.ceil(lever * Math.abs(by) / (ground.cell / 2)));
        int q = stand;
        int straight = 0;
        int diagonal = 0;
        for (int part = 1; part <= parts; part++) {
            double last =
                    mover.angle(mover.after(pose, counterClockwise ? 8 : 9).k());
            int at = cell(pose, part == parts ? last : from + by * part / parts);
            int before = q;
            if (at < 0) {
                return null;
            }
            if (at != q % ground.cells) {
                q = without.stepToSpan(q, at);
                if (q < 0) {
                    return null;
                }
                boolean slanted = at % ground.cols != before % ground.cells % ground.cols
                        && at / ground.cols != before % ground.cells / ground.cols;
                straight += slanted ? 0 : 1;
                diagonal += slanted ? 1 : 0;
            }
            double begin = from + by * (part - 1) / parts;
            double end = from + by * part / parts;
            if (!without.firm(q)
                    || !clearArc(pose, begin, end, ground.floor[before])
                    || !clearArc(pose, begin, end, ground.floor[q])) {
                return null;
            }
        }
        return new Carried(q, straight, diagonal);
    }

    /** Carries the disc along an arc, in chords as short as needed. */
    private boolean clearArc(Mover.Pose pose, double from, double to, double floor) {
        int chords = 1;
        while (lever * (1 - Math.cos(Math.abs(to - from) / chords / 2)) > SAGITTA) {
            chords++;
        }
        for (int n = 0; n < chords; n++) {
            double[] a = mover.turned(pose.i(), pose.j(), from + (to - from) * n / chords, held[0], held[1]);
            double[] b = mover.turned(pose.i(), pose.j(), from + (to - from) * (n + 1) / chords, held[0], held[1]);
            if (!clear(without.outlines, new double[] {a[0], a[1], b[0], b[1]}, floor, SAGITTA + SLACK)) {
                return false;
            }
        }
        return true;
    }

    /** Tells whether the body keeps its walk radius, less a slack, from everything along a segment. */
    private boolean clear(Polygon[] outlines, double[] line, double floor, double slack) {
        double least = ground.actor.walk().radius() - slack;
        if (ground.edge(line[0], line[1]) < least || ground.edge(line[2], line[3]) < least) {
            return false;
        }
        for (int n = 0; n < outlines.length; n++) {
            Obstacle o = ground.scene.obstacles().get(n);
            Polygon outline = o.movable() ? outlines[n] : o.outline();
            if (outline != null && ground.inWay(o, floor) && Shapes.distance(outline, line) < least) {
                return false;
            }
        }
        return ground.distanceToGround(line, floor + ground.actor.stepHeight() + SLACK) >= least;
    }

    /**
     * Tells whether the actor can let go: it stands firmly in the new space, can be carried to its cell's centre,
     * and some place of the way can be reached from there.
     */
    boolean settles(Mover.Pose pose, int stand, List<Toward.Spot> way) {
        Polygon[] there = Space.with(without.outlines, obstacle, mover.outline(pose));
        if (ground.kind[stand] != Ground.STABLE || (Space.standing(ground, there, stand) & Ground.WALK) == 0) {
            return false;
        }
        double[] at = mover.carried(pose, held[0], held[1]);
        int cell = stand % ground.cells;
        double[] line = {at[0], at[1], ground.x(cell), ground.y(cell)};
        return clear(there, line, ground.floor[stand], SLACK) && reaches(new Space(ground, there), stand, way);
    }

    private boolean reaches(Space after, int stand, List<Toward.Spot> way) {
        boolean[] reached = new boolean[ground.size];
        ArrayDeque<Integer> queue = new ArrayDeque<>(List.of(stand));
        reached[stand] = true;
        while (!queue.isEmpty()) {
            for (Space.Step step : after.steps(queue.remove())) {
                if (!reached[step.to()]) {
                    reached[step.to()] = true;
                    queue.add(step.to());
                }
            }
        }
        boolean any = false;
        for (Toward.Spot spot : way) {
            any |= after.isSpan(spot.configuration()) && reached[spot.configuration()];
        }
        return any;
    }
}
