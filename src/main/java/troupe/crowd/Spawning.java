package troupe.crowd;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import troupe.crowd.flock.Agents;
import troupe.crowd.flock.Chance;
import troupe.crowd.flock.Kin;
import troupe.crowd.ground.Terrain;
import troupe.crowd.ground.Way;
import troupe.geometry.Box;
import troupe.geometry.Polygon;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;

/**
 * Places the members of each group in its spawn outline, at random from the seed, so that none overlaps another or
 * stands in an obstacle, and each can reach its goal. Where chance leaves no room, the places of a dense lattice are
 * tried in order.
 */
final class Spawning {
    private static final int TRIES = 60;

    private final Agents agents;
    private final long seed;
    private final double bodyHeight;
    private final double edge;
    private final int cols;
    private final int rows;
    private final int[] firstIn;
    private final int[] nextIn;
    private final double widest;

    /** Prepares for a world of so many metres. */
    Spawning(Agents agents, Kin kin, long seed, double bodyHeight, double[] world) {
        this.agents = agents;
        this.seed = seed;
        this.bodyHeight = bodyHeight;
        this.widest = kin.leaves().stream()
                .mapToDouble(l -> l.members().radius())
                .max()
                .orElse(1);
        this.edge = Math.max(2 * widest, Math.sqrt(world[0] * world[1] / 1e6));
        this.cols = (int) (world[0] / edge) + 1;
        this.rows = (int) (world[1] / edge) + 1;
        this.firstIn = new int[cols * rows];
        this.nextIn = new int[agents.count];
        Arrays.fill(firstIn, -1);
    }

    /** Places the members of a group; returns why that is not possible, nothing if it is. */
    Optional<String> place(Kin.Leaf leaf, Way way) {
        CrowdGroup.Members members = leaf.members();
        Box box = members.spawn().bounds();
        Lattice lattice = new Lattice(box, members.radius());
        for (int m = 0; m < members.count(); m++) {
            int agent = leaf.first() + m;
            boolean done = false;
            for (int t = 0; t < TRIES && !done; t++) {
                long bits = Chance.bits(seed, 4, agent, t);
                double x = box.minX() + Chance.unit(bits) * (box.maxX() - box.minX());
                double y = box.minY() + Chance.unit(Chance.mixed(bits + 1)) * (box.maxY() - box.minY());
                done = put(agent, x, y, members, way);
            }
            while (!done && lattice.next()) {
                done = put(agent, lattice.x, lattice.y, members, way);
            }
            if (!done) {
                return Optional.of(String.format(
                        Locale.ROOT,
                        "the spawn outline of '%s' has room for %d of %d members from where the goal can be reached;"
                                + " enlarge it or lower the count",
                        leaf.group().id(),
                        m,
                        members.count()));
            }
        }
        return Optional.empty();
    }

    private boolean put(int agent, double x, double y, CrowdGroup.Members members, Way way) {
        Polygon spawn = members.spawn();
        if (!spawn.contains(x, y)) {
            return false;
        }
        Terrain terrain = way.terrain();
        int q = terrain.stand(new Place(x, y, members.floor()));
        if (q < 0 || !way.reaches(q) || meets(x, y, terrain.elevation(q), members.radius())) {
            return false;
        }
        agents.x[agent] = x;
        agents.y[agent] = y;
        agents.z[agent] = terrain.elevation(q);
        agents.span[agent] = q;
        agents.radius[agent] = members.radius();
        agents.topSpeed[agent] = members.speed();
        agents.way[agent] = way;
        int towards = way.towards(q);
        double dx = terrain.region().x(towards) - terrain.region().x(q);
        double dy = terrain.region().y(towards) - terrain.region().y(q);
        double length = Math.sqrt(dx * dx + dy * dy);
        agents.headingX[agent] = length == 0 ? 1 : dx / length;
        agents.headingY[agent] = length == 0 ? 0 : dy / length;
        int cell = row(y) * cols + col(x);
        nextIn[agent] = firstIn[cell];
        firstIn[cell] = agent;
        return true;
    }

    private boolean meets(double x, double y, double z, double radius) {
        double reach = radius + widest;
        for (int row = row(y - reach); row <= row(y + reach); row++) {
            for (int col = col(x - reach); col <= col(x + reach); col++) {
                for (int j = firstIn[row * cols + col]; j >= 0; j = nextIn[j]) {
                    double dx = agents.x[j] - x;
                    double dy = agents.y[j] - y;
                    // a hair more than touching, so that everybody can move at first
                    double apart = (radius + agents.radius[j]) * 1.02;
                    if (dx * dx + dy * dy < apart * apart && Math.abs(agents.z[j] - z) < bodyHeight) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private int col(double x) {
        return Math.max(0, Math.min(cols - 1, (int) (x / edge)));
    }

    private int row(double y) {
        return Math.max(0, Math.min(rows - 1, (int) (y / edge)));
    }

    /** Steps through the places of a triangular lattice in a box. */
    private static final class Lattice {
        private final Box box;
        private final double pitch;
        private int row;
        private int col = -1;
        double x;
        double y;

        Lattice(Box box, double radius) {
            this.box = box;
            this.pitch = 2.05 * radius;
        }

        boolean next() {
            col++;
            while (true) {
                x = box.minX() + (col + (row & 1) * 0.5) * pitch;
                y = box.minY() + row * pitch * Math.sqrt(0.75);
                if (y > box.maxY()) {
                    return false;
                }
                if (x <= box.maxX()) {
                    return true;
                }
                row++;
                col = 0;
            }
        }
    }
}
