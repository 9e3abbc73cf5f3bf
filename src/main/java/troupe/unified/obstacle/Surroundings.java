package troupe.unified.obstacle;

import java.util.ArrayList;
import java.util.List;
import troupe.geometry.Overlap;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Knows where every obstacle of one search space stands, what bars the motion of one of them, and whether
 * it can be moved at all. The obstacles stay as they are; what is worked out for an obstacle is kept. Used
 * by one thread at a time.
 */
public final class Surroundings {
    private static final double SLACK = 1e-9;

    private final Scene scene;
    private final Polygon[] outlines;
    private final boolean[] moved;
    private final Support[] supports;
    private final Sweeps[] sweeps;
    private final BodyRoom[] rooms;

    /** Makes the surroundings of the scene as it is: nothing has been moved. */
    public Surroundings(Scene scene) {
        this(
                scene,
                scene.obstacles().stream().map(Obstacle::outline).toArray(Polygon[]::new),
                new boolean[scene.obstacles().size()],
                new Support[scene.obstacles().size()]);
    }

    private Surroundings(Scene scene, Polygon[] outlines, boolean[] moved, Support[] supports) {
        this.scene = scene;
        this.outlines = outlines;
        this.moved = moved;
        this.supports = supports;
        this.sweeps = new Sweeps[outlines.length];
        this.rooms = new BodyRoom[outlines.length];
    }

    /** Returns these surroundings with an obstacle, by its number, moved for good. Cost O(obstacles). */
    public Surroundings with(int obstacle, Polygon outline) {
        Polygon[] shifted = outlines.clone();
        shifted[obstacle] = outline;
        boolean[] fixed = moved.clone();
        fixed[obstacle] = true;
        return new Surroundings(scene, shifted, fixed, supports);
    }

    /** Returns the scene as it was given. */
    public Scene scene() {
        return scene;
    }

    /** Returns the number of obstacles. */
    public int size() {
        return outlines.length;
    }

    /** Returns where an obstacle stands. */
    public Polygon outline(int obstacle) {
        return outlines[obstacle];
    }

    /**
     * Tells whether an obstacle can be moved here: it has not been moved, rests where it stands (its centroid
     * and three fifths of its footprint), and carries no other. Cost O(obstacles).
     */
    public boolean canMove(Movable movable) {
        return !moved[movable.number()]
                && rests(movable)
                && !carries(movable.number(), movable.obstacle().top());
    }

    /** Tells whether an obstacle rests where the scene has it, on the ground or on what cannot be moved. */
    public boolean rests(Movable movable) {
        return support(movable).rests(0, 0, 0);
    }

    private boolean carries(int obstacle, double top) {
        for (int other = 0; other < outlines.length; other++) {
            if (other != obstacle
                    && Math.abs(scene.obstacles().get(other).offset() - top) <= SLACK
                    && Overlap.of(outlines[obstacle], outlines[other])) {
                return true;
            }
        }
        return false;
    }

    /** Returns what carries an obstacle. */
    public Support support(Movable movable) {
        int n = movable.number();
        if (supports[n] == null) {
            supports[n] = new Support(scene, movable);
        }
        return supports[n];
    }

    /** Returns the outlines of the others that are as high as the obstacle somewhere: that it must not run into. */
    List<Polygon> barriers(Movable movable) {
        List<Polygon> found = new ArrayList<>();
        Obstacle mover = movable.obstacle();
        for (int other = 0; other < outlines.length; other++) {
            Obstacle o = scene.obstacles().get(other);
            if (other != movable.number() && o.offset() < mover.top() - SLACK && o.top() > mover.offset() + SLACK) {
                found.add(outlines[other]);
            }
        }
        return found;
    }

    /** Returns the motions that an obstacle has room for. */
    public Sweeps sweeps(Movable movable) {
        int n = movable.number();
        if (sweeps[n] == null) {
            sweeps[n] = new Sweeps(movable, scene.world(), barriers(movable));
        }
        return sweeps[n];
    }

    /** Returns the room for the body of an actor who holds an obstacle, for lines of at most {@code length} metres. */
    BodyRoom room(Movable movable, Actor actor, double length) {
        int n = movable.number();
        if (rooms[n] == null || !rooms[n].serves(actor, length)) {
            rooms[n] = new BodyRoom(this, n, actor, 1.25 * length);
        }
        return rooms[n];
    }
}
