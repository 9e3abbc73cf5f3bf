package troupe.exchange.track;

import java.awt.geom.Area;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import troupe.geometry.Polygon;
import troupe.scene.World;

/**
 * Holds the part of the ground that some people are on: what the world leaves when all that blocks is taken away,
 * without the parts that are cut off from them.
 *
 * @param outline counter-clockwise
 * @param holes clockwise; they touch the outline and each other in single points at most
 * @param leftOut square metres of the other parts
 * @param outside how many of the people are not on this part
 */
public record WalkableArea(Polygon outline, List<Polygon> holes, double leftOut, int outside) {

    /** A connected stretch of ground. */
    private record Part(Ring outer, List<Ring> holes) {
        double area() {
            return Math.abs(outer.signedArea())
                    - holes.stream().mapToDouble(h -> Math.abs(h.signedArea())).sum();
        }

        boolean contains(double[] at) {
            return outer.contains(at[0], at[1]) && holes.stream().noneMatch(h -> h.contains(at[0], at[1]));
        }
    }

    /** Copies the list. */
    public WalkableArea {
        holes = List.copyOf(holes);
    }

    /**
     * Finds the part that holds most of the people, of several the largest. The blocks are united first, so that
     * they may overlap and touch. Cost O((corners + crossings)²) at worst.
     *
     * @param people x and y of each in metres
     * @throws IllegalArgumentException if nothing is left to walk on
     */
    public static WalkableArea of(World world, List<Polygon> blocks, List<double[]> people) {
        Area blocked = new Area();
        blocks.forEach(block -> blocked.add(Ring.area(block)));
        Area free = new Area(new Rectangle2D.Double(0, 0, world.width(), world.depth()));
        free.subtract(blocked);
        List<Part> parts = parts(Ring.of(free));
        Part best = parts.stream()
                .max(Comparator.comparingLong(
                                (Part p) -> people.stream().filter(p::contains).count())
                        .thenComparingDouble(Part::area))
                .orElseThrow(() -> new IllegalArgumentException("nothing is left to walk on"));
        double all = parts.stream().mapToDouble(Part::area).sum();
        return new WalkableArea(
                best.outer().turned(true),
                best.holes().stream().map(h -> h.turned(false)).toList(),
                parts.size() == 1 ? 0 : all - best.area(),
                (int) people.stream().filter(p -> !best.contains(p)).count());
    }

    private static List<Part> parts(List<Ring> rings) {
        // a ring inside an even number of others bounds ground from without
        List<Part> parts = new ArrayList<>();
        List<Ring> holes = new ArrayList<>();
        for (Ring ring : rings) {
            long around = rings.stream().filter(r -> r != ring && r.holds(ring)).count();
            if (around % 2 == 0) {
                parts.add(new Part(ring, new ArrayList<>()));
            } else {
                holes.add(ring);
            }
        }
        for (Ring hole : holes) {
            parts.stream()
                    .filter(p -> p.outer().holds(hole))
                    .min(Comparator.comparingDouble(p -> Math.abs(p.outer().signedArea())))
                    .ifPresent(p -> p.holes().add(hole));
        }
        return parts;
    }
}
