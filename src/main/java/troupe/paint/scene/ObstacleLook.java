package troupe.paint.scene;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import troupe.geometry.Box;
import troupe.geometry.Point;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.scene.Obstacle;

/**
 * Says how one obstacle is drawn.
 *
 * @param hanging nothing carries its centre, so that there is room below: drawn see-through
 * @param stair it touches another that is up to a step higher or lower: drawn as part of a stair
 * @param trace whether it stands there, or only has stood or is going to
 */
public record ObstacleLook(Obstacle obstacle, boolean hanging, boolean stair, Trace trace) {
    private static final double TOUCH = 0.02;
    private static final double STEP = 0.3;
    private static final double LOW_FROM = 0.3;
    private static final double LOW_TO = 1.3;
    private static final double FULL = 1.9;
    private static final double STAIR = 2.6;

    /** Whether an obstacle stands where it is drawn: it does, a run has moved it away, or a run moves it there. */
    public enum Trace {
        NONE,
        LEFT,
        AHEAD
    }

    /** Returns the looks of all obstacles, lowest top first, equal tops in document order. Cost O(n log n) on usual scenes. */
    public static List<ObstacleLook> of(List<Obstacle> obstacles) {
        int n = obstacles.size();
        boolean[] stair = new boolean[n];
        boolean[] carried = new boolean[n];
        int[] byX = IntStream.range(0, n)
                .boxed()
                .sorted(Comparator.comparingDouble(
                        i -> obstacles.get(i).outline().bounds().minX()))
                .mapToInt(Integer::intValue)
                .toArray();
        for (int a = 0; a < n; a++) {
            Obstacle one = obstacles.get(byX[a]);
            Box box = one.outline().bounds().grown(TOUCH);
            for (int b = a + 1; b < n; b++) {
                Obstacle other = obstacles.get(byX[b]);
                Box otherBox = other.outline().bounds();
                if (otherBox.minX() > box.maxX()) {
                    break;
                }
                if (box.meets(otherBox)) {
                    carried[byX[a]] |= carries(other, one);
                    carried[byX[b]] |= carries(one, other);
                    boolean step = steps(one, other);
                    stair[byX[a]] |= step;
                    stair[byX[b]] |= step;
                }
            }
        }
        List<ObstacleLook> looks = new ArrayList<>(n);
        for (int i = 0; i < n; i++) {
            Obstacle obstacle = obstacles.get(i);
            boolean hanging = obstacle.offset() > 0 && !carried[i];
            looks.add(new ObstacleLook(obstacle, hanging, stair[i] && !hanging, Trace.NONE));
        }
        looks.sort(Comparator.comparingDouble(l -> l.obstacle.top()));
        return looks;
    }

    private static boolean carries(Obstacle below, Obstacle above) {
        Point centre = above.outline().centroid();
        return Math.abs(below.top() - above.offset()) < 1e-3 && below.outline().contains(centre.x(), centre.y());
    }

    private static boolean steps(Obstacle a, Obstacle b) {
        double difference = Math.abs(a.top() - b.top());
        return difference > 1e-6 && difference <= STEP && !a.movable() && !b.movable();
    }

    /** Tells whether it stands there. */
    public boolean solid() {
        return trace == Trace.NONE;
    }

    /** Tells whether its height is worth a number: low, or hanging. */
    public boolean low() {
        return hanging || !stair && obstacle.top() >= LOW_FROM - 1e-9 && obstacle.top() <= LOW_TO;
    }

    /** Returns the colour of its top: its own, or one that tells its height; steps pale towards the floor. */
    public Color fill(Theme theme) {
        double top = obstacle.top();
        if (obstacle.movable()) {
            return own(theme, theme.color(Tone.WOOD));
        }
        if (hanging) {
            return own(theme, theme.color(Tone.DECK));
        }
        if (stair || top < LOW_FROM - 1e-9) {
            double share = 0.35 + 0.6 * Math.min(1, top / STAIR);
            return Shapes.blend(theme.color(Tone.FLOOR), own(theme, theme.color(Tone.STEP)), share);
        }
        Color byHeight = Shapes.blend(theme.color(Tone.LOW), theme.color(Tone.WALL), (top - LOW_TO) / (FULL - LOW_TO));
        return own(theme, byHeight);
    }

    /** Returns the obstacle's own colour, lightened in the dark theme where it would be lost on the floor. */
    private Color own(Theme theme, Color other) {
        Color own = Shapes.colour(obstacle.colour(), other);
        boolean lost = theme == Theme.DARK && !own.equals(other) && Shapes.lightness(own) < 95;
        return lost ? Shapes.blend(own, Color.WHITE, 0.28) : own;
    }
}
