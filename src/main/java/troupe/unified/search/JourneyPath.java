package troupe.unified.search;

import java.util.List;
import troupe.grid.GridFrame;
import troupe.grid.region.Kind;
import troupe.grid.region.Region;
import troupe.scene.Ability;

/**
 * Holds a way over a region, step by step. Immutable by contract: the arrays must not be changed.
 *
 * @param configurations from start to goal; neighbours follow each other
 * @param abilities the ability of each step, one fewer than the configurations; the steps into, inside
 *     and out of a crossing have the ability of the crossing
 * @param length metres along the grid
 * @param takeOffs the number of strides and vaults
 * @param energyByAbility energy in J without preferences, by {@link Ability#ordinal()}, take-offs included
 * @param costByAbility the same with preferences
 */
public record JourneyPath(
        int[] configurations,
        List<Ability> abilities,
        double length,
        int takeOffs,
        double[] energyByAbility,
        double[] costByAbility) {

    /** Returns the number of steps. */
    public int steps() {
        return configurations.length - 1;
    }

    /** Returns the energy of the whole way in J, without preferences. */
    public double energy() {
        return sum(energyByAbility);
    }

    /** Returns the cost of the whole way: the energy with preferences. */
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

    /**
     * Adds up the steps of a way over a region. Straight and diagonal steps are counted and multiplied
     * once, so that the sums do not drift.
     *
     * @param configurations from start to goal; neighbours follow each other
     */
    static JourneyPath of(Region region, JourneyCosts costs, int[] configurations) {
        Ability[] abilities = new Ability[configurations.length - 1];
        int kinds = Ability.values().length;
        long[] straight = new long[kinds];
        long[] diagonal = new long[kinds];
        int[] takeOffs = new int[kinds];
        for (int i = 0; i < abilities.length; i++) {
            int from = configurations[i];
            int to = configurations[i + 1];
            boolean enters = isCrossing(region, to);
            byte kind = region.kind(enters ? to : from);
            abilities[i] = costs.ability(kind, region.abilities(from) & region.abilities(to));
            int ability = abilities[i].ordinal();
            if (isDiagonal(region, from, to)) {
                diagonal[ability]++;
            } else {
                straight[ability]++;
            }
            if (enters && !isCrossing(region, from)) {
                takeOffs[ability]++;
            }
        }
        return summed(region.frame().cell(), costs, configurations, List.of(abilities), straight, diagonal, takeOffs);
    }

    private static JourneyPath summed(
            double cell,
            JourneyCosts costs,
            int[] configurations,
            List<Ability> abilities,
            long[] straight,
            long[] diagonal,
            int[] takeOffs) {
        int kinds = Ability.values().length;
        double[] energy = new double[kinds];
        double[] cost = new double[kinds];
        double length = 0;
        int jumps = 0;
        for (Ability ability : Ability.values()) {
            int i = ability.ordinal();
            double metres = (straight[i] + diagonal[i] * Math.sqrt(2)) * cell;
            if (metres > 0) {
                energy[i] = metres * costs.energy(ability) + takeOffs[i] * costs.takeOff(ability);
                cost[i] = metres * costs.price(ability) + takeOffs[i] * costs.takeOffCost(ability);
            }
            length += metres;
            jumps += takeOffs[i];
        }
        return new JourneyPath(configurations, abilities, length, jumps, energy, cost);
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
