package troupe.unified.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.unified.cost.JourneyCosts;
import troupe.unified.manipulation.Transfer;
import troupe.unified.obstacle.Movable;

/**
 * Holds what an actor does on its way from start to goal. Immutable by contract: the arrays must not be
 * changed.
 *
 * @param parts ways over a region and, between them, what is moved; it begins and ends with a way
 * @param length metres that the actor travels along the grid, transfers included
 * @param takeOffs the number of strides and vaults
 * @param energyByAbility energy in J without preferences, by {@link Ability#ordinal()}, take-offs included
 * @param costByAbility the same with preferences
 */
public record JourneyPath(
        List<Part> parts, double length, int takeOffs, double[] energyByAbility, double[] costByAbility) {

    /** A part of a path. */
    public sealed interface Part permits Way, Push {}

    /**
     * A way over one search space, step by step.
     *
     * @param region the region of that space
     * @param configurations one or more; neighbours follow each other
     * @param abilities the ability of each step, one fewer than the configurations; the steps into, inside
     *     and out of a crossing have the ability of the crossing
     */
    public record Way(Region region, int[] configurations, List<Ability> abilities) implements Part {}

    /** Moving an obstacle: where it goes, and the actor with it. */
    public record Push(Movable movable, Transfer transfer) implements Part {}

    /** Copies the parts. */
    public JourneyPath {
        parts = List.copyOf(parts);
    }

    /** Returns the abilities of the steps of all ways in turn. */
    public List<Ability> abilities() {
        return ways().stream().flatMap(way -> way.abilities().stream()).toList();
    }

    private List<Way> ways() {
        return parts.stream().filter(Way.class::isInstance).map(Way.class::cast).toList();
    }

    /** Returns what is moved, in order. */
    public List<Push> pushes() {
        return parts.stream()
                .filter(Push.class::isInstance)
                .map(Push.class::cast)
                .toList();
    }

    /** Returns the metres that the actor travels while it holds an obstacle. */
    public double transferLength() {
        return pushes().stream().mapToDouble(push -> push.transfer().walked()).sum();
    }

    /** Returns the energy of the whole path in J, without preferences. */
    public double energy() {
        return sum(energyByAbility);
    }

    /** Returns the cost of the whole path: the energy with preferences. */
    public double cost() {
        return sum(costByAbility);
    }

    private static double sum(double[] values) {
        double sum = 0;
        for (double value : values) {
            sum += value;
        }
        return sum;
    }

    /** Makes the way over a region through configurations that follow each other. */
    static Way way(Region region, JourneyCosts costs, int[] configurations) {
        Ability[] abilities = new Ability[configurations.length - 1];
        for (int i = 0; i < abilities.length; i++) {
            int from = configurations[i];
            int to = configurations[i + 1];
            byte kind = region.kind(isCrossing(region, to) ? to : from);
            abilities[i] = costs.ability(kind, region.abilities(from) & region.abilities(to));
        }
        return new Way(region, configurations, List.of(abilities));
    }

    /** Adds up what the parts take. */
    static JourneyPath of(JourneyCosts costs, List<Part> parts) {
        Sums sums = new Sums();
        for (Part part : parts) {
            if (part instanceof Way way) {
                sums.add(way);
            } else if (part instanceof Push push) {
                sums.add(push, costs);
            }
        }
        return sums.path(costs, parts);
    }

    /**
     * Adds up parts. Straight and diagonal steps are counted and multiplied once, so that the sums do not
     * drift.
     */
    private static final class Sums {
        private final int kinds = Ability.values().length;
        private final long[] straight = new long[kinds];
        private final long[] diagonal = new long[kinds];
        private final int[] takeOffs = new int[kinds];
        private double cell;
        private double walked;
        private double moved;

        void add(Way way) {
            Region region = way.region();
            cell = region.frame().cell();
            for (int i = 0; i + 1 < way.configurations().length; i++) {
                int from = way.configurations()[i];
                int to = way.configurations()[i + 1];
                int ability = way.abilities().get(i).ordinal();
                if (isDiagonal(region, from, to)) {
                    diagonal[ability]++;
                } else {
                    straight[ability]++;
                }
                if (isCrossing(region, to) && !isCrossing(region, from)) {
                    takeOffs[ability]++;
                }
            }
        }

        void add(Push push, JourneyCosts costs) {
            Transfer transfer = push.transfer();
            walked += transfer.walked();
            moved += costs.moveEnergy(push.movable().obstacle().mass(), transfer.length(), transfer.turn());
        }

        JourneyPath path(JourneyCosts costs, List<Part> parts) {
            double[] energy = new double[kinds];
            double[] cost = new double[kinds];
            double length = 0;
            for (Ability ability : Ability.values()) {
                int i = ability.ordinal();
                double metres = (straight[i] + diagonal[i] * Math.sqrt(2)) * cell;
                metres += ability == Ability.WALK ? walked : 0;
                if (metres > 0) {
                    energy[i] = metres * costs.energy(ability) + takeOffs[i] * costs.takeOff(ability);
                    cost[i] = metres * costs.price(ability) + takeOffs[i] * costs.takeOffCost(ability);
                }
                length += metres;
            }
            if (moved > 0) {
                energy[Ability.MOVE.ordinal()] = moved;
                cost[Ability.MOVE.ordinal()] = moved * costs.preference(Ability.MOVE);
            }
            return new JourneyPath(
                    new ArrayList<>(parts), length, Arrays.stream(takeOffs).sum(), energy, cost);
        }
    }

    private static boolean isCrossing(Region region, int configuration) {
        byte kind = region.kind(configuration);
        return kind == Kind.GAP || kind == Kind.JUMPABLE;
    }

    private static boolean isDiagonal(Region region, int from, int to) {
        GridFrame frame = region.frame();
        int a = region.cell(from);
        int b = region.cell(to);
        return frame.col(a) != frame.col(b) && frame.row(a) != frame.row(b);
    }
}
