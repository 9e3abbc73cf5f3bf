package troupe.risk.forecast;

/**
 * Tells where one avatar cannot be in a given time, as walls are between: places inside a wall, and those to which
 * the way round the walls is longer than its top speed allows and clearly longer than the straight line. It holds
 * for one place of the avatar at a time; in the open it costs nothing. Used by one thread at a time.
 */
final class Reach {
    /** The coarse grid lengthens ways by up to this factor. */
    private static final double CROOKED = 1.15;

    private final Ways ways;
    private final int[] distance;
    private final double speed;
    private final double slack;
    private int from = -1;
    private double flooded = -1;
    private double x;
    private double y;
    private boolean open;

    /**
     * Makes the reach of an avatar.
     *
     * @param speed its highest speed in m/s
     * @param slack metres by which its place may be mistaken
     */
    Reach(Ways ways, double speed, double slack) {
        this.ways = ways;
        this.distance = new int[ways.size()];
        this.speed = speed;
        this.slack = slack + 2 * ways.edge();
    }

    /** Puts the avatar at a place and looks {@code seconds} ahead, over a spread of at most {@code radius} metres. */
    void at(double atX, double atY, double seconds, double radius) {
        x = atX;
        y = atY;
        double most = Math.max(radius, speed * seconds) + slack;
        open = ways.clear(x, y, most);
        int block = ways.block(x, y);
        double wanted = most * CROOKED;
        if (!open && (block != from || flooded < wanted)) {
            ways.flood(block, wanted, distance);
            from = block;
            flooded = wanted;
        }
    }

    /** Tells whether the avatar can be at a place {@code seconds} from now. */
    boolean reaches(double toX, double toY, double seconds) {
        if (open) {
            return true;
        }
        if (!ways.free(toX, toY)) {
            return false;
        }
        double way = ways.metres(distance[ways.block(toX, toY)]);
        double dx = toX - x;
        double dy = toY - y;
        return way <= speed * seconds + slack || way <= CROOKED * Math.sqrt(dx * dx + dy * dy) + slack;
    }

    /** Returns the reachable block nearest to a place, the first of equally near ones; -1 if there is none. */
    int nearest(double toX, double toY, double seconds) {
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int block = 0; block < ways.size(); block++) {
            double dx = ways.standX(block) - toX;
            double dy = ways.standY(block) - toY;
            double away = dx * dx + dy * dy;
            if (away < least && reaches(ways.standX(block), ways.standY(block), seconds)) {
                least = away;
                best = block;
            }
        }
        return best;
    }

    Ways ways() {
        return ways;
    }
}
