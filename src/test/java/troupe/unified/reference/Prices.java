package troupe.unified.reference;

import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Preferences;

/**
 * Says what steps cost, in whole units of 10^-11 J so that sums do not depend on the order of their terms. A step
 * that is not legal costs {@link #NONE}.
 */
final class Prices {
    static final long NONE = Long.MAX_VALUE / 4;
    private static final double PER_JOULE = 1e11;

    private final Actor actor;
    private final Preferences preferences;
    private final double cell;

    Prices(Actor actor, Preferences preferences, double cell) {
        this.actor = actor;
        this.preferences = preferences;
        this.cell = cell;
    }

    static double joules(long units) {
        return units / PER_JOULE;
    }

    private static long units(double joules) {
        return Math.round(joules * PER_JOULE);
    }

    double metres(int direction) {
        return direction < 4 ? cell : cell * Math.sqrt(2);
    }

    private double walk() {
        return actor.walk().energy() * preferences.of(Ability.WALK);
    }

    private double sidestep() {
        return actor.sidestep()
                .map(a -> a.energy() * preferences.of(Ability.SIDESTEP))
                .orElse(Double.POSITIVE_INFINITY);
    }

    /** Tells whether a step between two spans is walked, which it is unless sidestepping is cheaper or needed. */
    boolean walks(Space space, int from, int to) {
        int common = space.abilities[from] & space.abilities[to];
        boolean canWalk = (common & Ground.WALK) != 0;
        boolean canSidestep = (common & Ground.SIDESTEP) != 0;
        return canWalk && !(canSidestep && sidestep() < walk());
    }

    /** Returns the cost of a metre walked. */
    long walked(double metres) {
        return units(walk() * metres);
    }

    /** Returns the cost of a step that {@link Space#steps} gives, limits and straightness left out. */
    long step(Space space, int from, int to, int direction, double most) {
        Ground ground = space.ground;
        if (space.isSpan(from) && space.isSpan(to)) {
            int common = space.abilities[from] & space.abilities[to];
            if ((common & (Ground.WALK | Ground.SIDESTEP)) == 0) {
                return NONE;
            }
            double price = walks(space, from, to) ? walk() : sidestep();
            return units(Math.min(price, most) * metres(direction));
        }
        int crossing = space.isSpan(to) ? from : to;
        boolean vault = ground.isVault(crossing);
        double energy = vault
                ? actor.vault().orElseThrow().energy()
                : actor.stride().orElseThrow().energy();
        double takeOff = vault
                ? actor.vault().orElseThrow().takeOff()
                : actor.stride().orElseThrow().takeOff();
        double factor = preferences.of(vault ? Ability.VAULT : Ability.STRIDE);
        long length = units(energy * factor * metres(direction));
        if (space.isSpan(to)) {
            return space.firm(to) ? length : NONE;
        }
        if (!space.isSpan(from)) {
            return length;
        }
        boolean begins = space.firm(from) && ground.levels[ground.levelOf[from]] == ground.elevation(to);
        return begins ? length + units(takeOff * factor) : NONE;
    }

    /** Returns the cost of a metre of vaulting. */
    double vaultedMetre() {
        return actor.vault().orElseThrow().energy() * preferences.of(Ability.VAULT);
    }

    /** Returns the cost of a move of an obstacle of a mass by metres or radians. */
    long moved(double mass, double metres, double radians) {
        Actor.Move move = actor.move().orElseThrow();
        double energy = mass * (metres * move.energy() + radians * move.turnEnergy());
        return units(energy * preferences.of(Ability.MOVE));
    }
}
