package troupe.unified.cost;

import java.util.Arrays;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Preferences;
import troupe.unified.manipulation.Prices;

/**
 * Holds what every step of an actor costs, and how far it may travel on unstable places.
 *
 * <p>A step costs its horizontal length along the grid times the energy per metre of its ability times
 * the preference for it; a take-off costs its energy times the preference. The search adds costs as whole
 * numbers of a small <em>unit</em> (at best 2^-32 of the cheapest straight step), so that a sum does not
 * depend on the order of its terms and routes of equal cost tie exactly. Immutable.
 */
public final class JourneyCosts {
    /** The cost in units of a step that no ability can take. */
    static final long BLOCKED = Long.MAX_VALUE / 4;

    private static final int COST_BITS = 62;
    private static final int STEP_BITS = 24;
    private static final int MOST_UNIT_BITS = 32;
    private static final int LEAST_UNIT_BITS = 8;
    private static final int KINDS = Kind.FORBIDDEN + 1;
    private static final double SLACK = 1e-9;
    private static final double ROOT = Math.sqrt(2);
    private static final int STANDING = Ability.WALK.bit() | Ability.SIDESTEP.bit();

    private final double cell;
    private final double[] energies = new double[Ability.values().length];
    private final double[] takeOffs = new double[Ability.values().length];
    private final double turnEnergy;
    private final double[] preferences = new double[Ability.values().length];
    private final double[] limits = new double[KINDS];
    private final int unitBits;
    private final double unitsPerJoule;
    private final long[] standing = new long[2 * (STANDING + 1)];
    private final long[] crossing = new long[2 * KINDS];
    private final long[] takeOffUnits = new long[KINDS];
    private final long cheapestStraight;
    private final long cheapestDiagonal;

    /**
     * Works out the costs of an actor.
     *
     * @param actor what it can do; abilities that the preferences switch off are taken away
     * @param preferences the factor on the energy of each ability
     * @param cell the size of a cell in metres, above 0
     * @throws IllegalArgumentException if walking is switched off, or if the dearest step costs more than
     *     10^12 times the cheapest
     */
    public JourneyCosts(Actor actor, Preferences preferences, double cell) {
        this.cell = cell;
        for (Ability ability : Ability.values()) {
            this.preferences[ability.ordinal()] = preferences.of(ability);
        }
        Arrays.fill(energies, Double.NaN);
        if (!preferences.allows(Ability.WALK)) {
            throw new IllegalArgumentException("preference.walk=off; an actor needs the ability to walk");
        }
        put(Ability.WALK, actor.walk().energy(), 0);
        actor.sidestep().ifPresent(a -> put(Ability.SIDESTEP, a.energy(), 0));
        actor.stride().ifPresent(a -> put(Ability.STRIDE, a.energy(), a.takeOff()));
        actor.vault().ifPresent(a -> put(Ability.VAULT, a.energy(), a.takeOff()));
        actor.move().ifPresent(a -> put(Ability.MOVE, a.energy(), 0));
        turnEnergy = actor.move().map(Actor.Move::turnEnergy).orElse(0.0);
        Arrays.fill(limits, Double.POSITIVE_INFINITY);
        limits[Kind.BORDER] = actor.maxBorder() + SLACK;
        actor.stride().ifPresent(a -> limits[Kind.GAP] = a.maxGap() + SLACK);
        actor.vault().ifPresent(a -> limits[Kind.JUMPABLE] = a.maxJump() + SLACK);
        double cheapest = cheapestPositive();
        unitBits = unitBits(preferences.spread(actor, cell));
        unitsPerJoule = Math.scalb(1.0, unitBits) / (cheapest * cell);
        fillTables();
        long straight = BLOCKED;
        long diagonal = BLOCKED;
        for (int mask = 1; mask <= STANDING; mask++) {
            straight = Math.min(straight, standing[2 * mask]);
            diagonal = Math.min(diagonal, standing[2 * mask + 1]);
        }
        for (byte kind : new byte[] {Kind.GAP, Kind.JUMPABLE}) {
            straight = Math.min(straight, crossing[2 * kind]);
            diagonal = Math.min(diagonal, crossing[2 * kind + 1]);
        }
        cheapestStraight = straight;
        cheapestDiagonal = diagonal;
    }

    private void put(Ability ability, double energy, double takeOff) {
        if (preferences[ability.ordinal()] != Preferences.OFF) {
            energies[ability.ordinal()] = energy;
            takeOffs[ability.ordinal()] = takeOff;
        }
    }

    private double cheapestPositive() {
        double cheapest = Double.POSITIVE_INFINITY;
        for (Ability ability : Ability.values()) {
            double price = price(ability);
            if (price > 0 && ability != Ability.MOVE) {
                cheapest = Math.min(cheapest, price);
            }
        }
        return cheapest == Double.POSITIVE_INFINITY ? 1 : cheapest;
    }

    /** Chooses the unit so that 2^24 of the dearest steps can be added up, as far as that is possible. */
    private static int unitBits(double ratio) {
        if (!(ratio <= Preferences.WIDEST)) {
            throw new IllegalArgumentException("the dearest step costs " + ratio
                    + " times the cheapest; preferences and energies may differ by a factor of 1e12");
        }
        int bits = COST_BITS - STEP_BITS - Math.getExponent(ratio) - 1;
        return Math.max(LEAST_UNIT_BITS, Math.min(MOST_UNIT_BITS, bits));
    }

    private void fillTables() {
        Arrays.fill(standing, BLOCKED);
        Arrays.fill(crossing, BLOCKED);
        for (int mask = 1; mask <= STANDING; mask++) {
            Ability ability = standingAbility(mask);
            if (ability != null) {
                putSteps(standing, mask, ability);
            }
        }
        for (byte kind : new byte[] {Kind.GAP, Kind.JUMPABLE}) {
            Ability ability = crossingAbility(kind);
            if (has(ability)) {
                putSteps(crossing, kind, ability);
                takeOffUnits[kind] = units(takeOffCost(ability));
            }
        }
    }

    private void putSteps(long[] table, int row, Ability ability) {
        table[2 * row] = units(price(ability) * cell);
        table[2 * row + 1] = units(price(ability) * cell * ROOT);
    }

    /** Returns the cheapest ability of a mask that one can stand with, null if none; ties go to walking. */
    private Ability standingAbility(int mask) {
        boolean walks = (mask & Ability.WALK.bit()) != 0 && has(Ability.WALK);
        boolean sidesteps = (mask & Ability.SIDESTEP.bit()) != 0 && has(Ability.SIDESTEP);
        if (walks && sidesteps) {
            return price(Ability.WALK) <= price(Ability.SIDESTEP) ? Ability.WALK : Ability.SIDESTEP;
        }
        return walks ? Ability.WALK : sidesteps ? Ability.SIDESTEP : null;
    }

    private static Ability crossingAbility(byte kind) {
        return kind == Kind.GAP ? Ability.STRIDE : Ability.VAULT;
    }

    /** Tells whether the ability can be used. */
    public boolean has(Ability ability) {
        return !Double.isNaN(energies[ability.ordinal()]);
    }

    /** Returns the energy of an ability in J per metre, without the preference; NaN if it cannot be used. */
    public double energy(Ability ability) {
        return energies[ability.ordinal()];
    }

    /** Returns the cost of an ability per metre: its energy times the preference; NaN if it cannot be used. */
    public double price(Ability ability) {
        return energies[ability.ordinal()] * preferences[ability.ordinal()];
    }

    /** Returns the factor on the energy of an ability. */
    public double preference(Ability ability) {
        return preferences[ability.ordinal()];
    }

    /**
     * Returns the energy in J of moving an obstacle, without the preference; NaN if moving cannot be used.
     *
     * @param mass kg
     * @param metres how far its centroid travels
     * @param radians how far it turns
     */
    public double moveEnergy(double mass, double metres, double radians) {
        return mass * (metres * energy(Ability.MOVE) + radians * turnEnergy);
    }

    /** Returns the energy in J of one take-off of an ability, 0 for those without, without the preference. */
    public double takeOff(Ability ability) {
        return takeOffs[ability.ordinal()];
    }

    /** Returns the cost of one take-off of an ability: its energy times the preference. */
    public double takeOffCost(Ability ability) {
        return has(ability) ? takeOffs[ability.ordinal()] * preferences[ability.ordinal()] : 0;
    }

    /** Returns the limit of {@link Kind#BORDER}, {@link Kind#GAP} or {@link Kind#JUMPABLE} in metres, slack included. */
    public double limit(byte kind) {
        return limits[kind];
    }

    /**
     * Returns the ability of a step between two neighbours: that of the crossing if one of them is one,
     * else the cheapest that both allow.
     *
     * @param kind the kind of the crossing, or of either standing configuration
     * @param common the abilities that both standing configurations allow; not used for a crossing
     * @throws IllegalArgumentException if there is none
     */
    public Ability ability(byte kind, int common) {
        Ability ability =
                kind == Kind.GAP || kind == Kind.JUMPABLE ? crossingAbility(kind) : standingAbility(common & STANDING);
        if (ability == null) {
            throw new IllegalArgumentException("abilities=" + common + "; needs one that both places allow");
        }
        return ability;
    }

    /** Returns the units of a cost in J, rounded to the nearest. */
    long units(double cost) {
        return (long) Math.rint(cost * unitsPerJoule);
    }

    /** Returns the cost in J of a number of units. */
    public double joules(long units) {
        return units / unitsPerJoule;
    }

    /** Returns the number of bits of the cheapest straight step in units. */
    int unitBits() {
        return unitBits;
    }

    /** Returns the bits of the width of a bucket of a queue of costs: a 64th of the cheapest straight step. */
    public int bucketBits() {
        return Math.max(0, unitBits - 6);
    }

    /** Returns the cost in units of a step between standing configurations, {@link #BLOCKED} if none can. */
    long standing(int common, int direction) {
        return standing[(common & STANDING) << 1 | direction >> 2];
    }

    /**
     * Returns the table of {@link #standing}, entry {@code 2 * mask + (1 if diagonal)}; if {@code relaxed}, with
     * no entry dearer than a vault. Not to be changed.
     */
    long[] cheapestTable(boolean relaxed) {
        if (!relaxed) {
            return standing;
        }
        long[] cheapest = standing.clone();
        for (int i = 2; i < cheapest.length; i++) {
            if (cheapest[i] < BLOCKED) {
                cheapest[i] = Math.min(cheapest[i], crossing[2 * Kind.JUMPABLE + (i & 1)]);
            }
        }
        return cheapest;
    }

    /**
     * Returns what moving an obstacle costs in units, and the steps of an actor that holds it.
     *
     * @param mass kg
     * @param turn radians between two headings
     */
    public Prices prices(double mass, double turn) {
        int walk = Ability.WALK.bit() << 1;
        return new Prices(
                moving(mass, cell, 0),
                moving(mass, cell * ROOT, 0),
                moving(mass, 0, turn),
                standing[walk],
                standing[walk + 1]);
    }

    private long moving(double mass, double metres, double radians) {
        double cost = moveEnergy(mass, metres, radians) * preference(Ability.MOVE);
        return (long) Math.min(Prices.BLOCKED, Math.rint(cost * unitsPerJoule));
    }

    /** Returns the cost in units of a step into, inside or out of a crossing, without the take-off. */
    long crossing(byte kind, int direction) {
        return crossing[kind << 1 | direction >> 2];
    }

    /** Returns the cost in units of a take-off into a crossing of a kind. */
    long takeOffUnits(byte kind) {
        return takeOffUnits[kind];
    }

    /** Returns the cost in units of the cheapest straight step. */
    public long cheapestStraight() {
        return cheapestStraight;
    }

    /** Returns the cost in units of the cheapest diagonal step. */
    long cheapestDiagonal() {
        return cheapestDiagonal;
    }
}
