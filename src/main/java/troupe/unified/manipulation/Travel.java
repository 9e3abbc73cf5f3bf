package troupe.unified.manipulation;

import java.util.List;
import troupe.unified.obstacle.Grip;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;

/** Counts the moves of an obstacle, and the steps of the actor that holds it, so that sums of their lengths do not drift. Used once. */
final class Travel {
    private final Movable movable;
    private final Grip grip;
    private int straight;
    private int diagonal;
    private int turned;
    private int walkedStraight;
    private int walkedDiagonal;

    /** Counts nothing yet; {@code grip} is null where the actor only stands by. */
    Travel(Movable movable, Grip grip) {
        this.movable = movable;
        this.grip = grip;
    }

    /** Returns how the obstacle is moved along poses, of which each is one move from the one before. */
    Transfer along(List<LatticePose> poses, int from, int to) {
        for (int n = 1; n < poses.size(); n++) {
            add(poses.get(n - 1), poses.get(n));
        }
        return new Transfer(
                movable.number(),
                grip != null,
                from,
                to,
                poses,
                length(straight, diagonal),
                turned * movable.turn(),
                grip == null ? 0 : length(walkedStraight, walkedDiagonal));
    }

    private void add(LatticePose a, LatticePose b) {
        if (a.k() != b.k()) {
            int lower = (a.k() + 1) % movable.headings() == b.k() ? a.k() : b.k();
            turned++;
            walkedStraight += grip == null ? 0 : grip.straightSteps(lower);
            walkedDiagonal += grip == null ? 0 : grip.diagonalSteps(lower);
        } else if (a.i() != b.i() && a.j() != b.j()) {
            diagonal++;
            walkedDiagonal++;
        } else {
            straight++;
            walkedStraight++;
        }
    }

    private double length(int straightSteps, int diagonalSteps) {
        return (straightSteps + diagonalSteps * Math.sqrt(2)) * movable.cell();
    }
}
