package troupe.work.inspect;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import troupe.geometry.Point;
import troupe.grid.GridFrame;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.search.MinHeap;

/**
 * Finds what stands between the start and the goal of a journey that has no way: what the least obstructed way
 * crosses, and gaps on it that are too narrow to walk or sidestep through. That way is found on the floor of the
 * start; crossing a thing counts as {@value #ENTRY} times its diagonal of walking, so that the smallest thing is
 * blamed. Whether taking something away opens the way is for the planner to say.
 */
public final class BlockageSearch {
    private static final double ENTRY = 40;
    private static final double THROUGH = 3;
    private static final double NARROW = 60;
    private static final double UNIT = 1e6;

    private BlockageSearch() {}

    /** Finds what blocks a journey; empty where nothing seems to, or the grid would be too large. O(cells log cells). */
    public static Optional<Blockage> of(Scene scene, Journey journey) {
        return scene.actor(journey.actor()).flatMap(actor -> Obstruction.of(scene, actor, floor(journey.start()))
                .flatMap(grid -> new Walk(grid, radius(actor)).find(journey)));
    }

    /** Finds the free place nearest to a place where an actor can stand; empty where there is none. O(cells). */
    public static Optional<Place> nearestFree(Scene scene, Actor actor, Place place) {
        return Obstruction.of(scene, actor, floor(place))
                .flatMap(grid -> grid.free(place, actor.walk().radius()));
    }

    private static double floor(Place place) {
        return place.z().orElse(0);
    }

    private static double radius(Actor actor) {
        return Math.min(
                actor.walk().radius(),
                actor.sidestep().map(Actor.Sidestep::radius).orElse(Double.POSITIVE_INFINITY));
    }

    /** Finds the least obstructed way. */
    private static final class Walk {
        private final Obstruction grid;
        private final GridFrame frame;
        private final double radius;
        private final double[] cost;
        private final int[] before;

        private Walk(Obstruction grid, double radius) {
            this.grid = grid;
            this.frame = grid.frame();
            this.radius = radius;
            this.cost = new double[frame.size()];
            this.before = new int[frame.size()];
        }

        private Optional<Blockage> find(Journey journey) {
            int start = frame.cellAt(journey.start().x(), journey.start().y());
            int goal = frame.cellAt(journey.goal().x(), journey.goal().y());
            if (start < 0 || goal < 0) {
                return Optional.empty();
            }
            search(start, goal);
            List<Integer> cells = new ArrayList<>();
            for (int cell = goal; cell >= 0; cell = before[cell]) {
                cells.add(0, cell);
            }
            List<String> crossed = cells.stream()
                    .filter(cell -> grid.at(cell) >= 0)
                    .map(cell -> grid.id(grid.at(cell)))
                    .distinct()
                    .toList();
            List<Blockage.Gap> gaps = gaps(cells);
            return crossed.isEmpty() && gaps.isEmpty()
                    ? Optional.empty()
                    : Optional.of(new Blockage(
                            crossed, gaps, cells.stream().map(grid::middle).toList()));
        }

        private void search(int start, int goal) {
            Arrays.fill(cost, Double.POSITIVE_INFINITY);
            Arrays.fill(before, -1);
            MinHeap open = new MinHeap();
            cost[start] = 0;
            open.add(start, 0, 0);
            while (!open.isEmpty()) {
                long key = open.firstKey();
                int cell = open.removeFirst();
                if (cell == goal) {
                    return;
                }
                if (key > Math.round(cost[cell] * UNIT)) {
                    continue;
                }
                for (int d = 0; d < GridFrame.DIRECTIONS; d++) {
                    relax(cell, d, open);
                }
            }
        }

        private void relax(int cell, int direction, MinHeap open) {
            int col = frame.col(cell) + GridFrame.dx(direction);
            int row = frame.row(cell) + GridFrame.dy(direction);
            if (col < 1 || row < 1 || col >= frame.cols() - 1 || row >= frame.rows() - 1) {
                return;
            }
            int next = frame.index(col, row);
            boolean enters = grid.at(next) >= 0 && grid.at(next) != grid.at(cell);
            double sum = cost[cell]
                    + frame.stepLength(direction) * weight(next)
                    + (enters ? ENTRY * grid.diagonal(grid.at(next)) : 0);
            if (sum < cost[next]) {
                cost[next] = sum;
                before[next] = cell;
                open.add(next, Math.round(sum * UNIT), 0);
            }
        }

        private double weight(int cell) {
            if (grid.at(cell) >= 0) {
                return THROUGH;
            }
            double clearance = grid.clearance(cell);
            return clearance >= radius ? 1 : 1 + NARROW * (1 - clearance / radius);
        }

        /** Finds the narrow stretches of a way that do not lead into an obstacle; of each, the narrowest place. */
        private List<Blockage.Gap> gaps(List<Integer> cells) {
            List<Blockage.Gap> found = new ArrayList<>();
            int i = 0;
            while (i < cells.size()) {
                int from = i;
                while (i < cells.size() && isNarrow(cells.get(i))) {
                    i++;
                }
                boolean apart = (from == 0 || grid.at(cells.get(from - 1)) < 0)
                        && (i >= cells.size() || grid.at(cells.get(i)) < 0);
                if (i > from && apart) {
                    cells.subList(from, i).stream()
                            .min(Comparator.comparingDouble(grid::clearance))
                            .ifPresent(cell -> found.add(gap(grid.middle(cell))));
                }
                i = Math.max(i, from + 1);
            }
            return found;
        }

        private boolean isNarrow(int cell) {
            return grid.at(cell) < 0 && grid.clearance(cell) < radius;
        }

        private Blockage.Gap gap(Point at) {
            List<Integer> sides = grid.nearest(at);
            double width = sides.stream().mapToDouble(n -> grid.distance(n, at)).sum();
            String first = sides.isEmpty() ? "" : grid.id(sides.get(0));
            String second = sides.size() < 2 ? "" : grid.id(sides.get(1));
            return new Blockage.Gap(first, second, width, 2 * radius, at);
        }
    }
}
