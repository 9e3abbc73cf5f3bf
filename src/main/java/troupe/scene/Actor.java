package troupe.scene;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;

/**
 * Holds an actor profile: the body, and the abilities it has. Every actor walks; an ability that is
 * absent cannot be used by any task. Lengths are in metres, speeds in m/s, energies in joules
 * (Unified section 3; defaults of the {@code DEFAULT} constants).
 *
 * @param bodyHeight height of the bounding volume while walking and sidestepping
 * @param footRadius radius of the disc that must be supported
 * @param stepHeight highest step taken without a jump
 * @param maxBorder the limit M: how far a border may be travelled, in metres along the grid
 */
public record Actor(
        String id,
        String label,
        String colour,
        double bodyHeight,
        double footRadius,
        double stepHeight,
        double maxBorder,
        Walk walk,
        Optional<Sidestep> sidestep,
        Optional<Stride> stride,
        Optional<Vault> vault,
        Optional<Move> move)
        implements Element {

    /** Walking straight ahead: a cylinder of {@code radius}; {@code energy} in J per metre. */
    public record Walk(double radius, double energy, double speed) {
        public static final Walk DEFAULT = new Walk(0.25, 1, 1.3);
    }

    /** Walking sideways: {@code radius} is half the thickness of the turned body; {@code energy} in J per metre. */
    public record Sidestep(double radius, double energy, double speed) {
        public static final Sidestep DEFAULT = new Sidestep(0.15, 2, 0.6);
    }

    /**
     * Striding a gap of at most {@code gait} metres; {@code maxGap} is the limit N in metres along the
     * grid; {@code energy} in J per metre and {@code takeOff} in J for each stride.
     */
    public record Stride(double gait, double maxGap, double energy, double takeOff, double speed) {
        public static final Stride DEFAULT = new Stride(0.9, 1.1 * 0.9, 1.5, 1, 1.5);
    }

    /**
     * Vaulting obstacles whose top lies {@code minHeight} to {@code maxHeight} above the take-off floor,
     * over at most {@code reach} metres between the two standing configurations, with a body of
     * {@code bodyHeight} above the obstacle; {@code maxJump} is the limit J in metres along the grid;
     * {@code energy} in J per metre and {@code takeOff} in J for each vault.
     */
    public record Vault(
            double minHeight,
            double maxHeight,
            double reach,
            double bodyHeight,
            double maxJump,
            double energy,
            double takeOff,
            double speed) {
        public static final Vault DEFAULT = new Vault(0.4, 1.1, 1.4, 1.2, 1.1 * 1.4, 3, 4, 1.0);
    }

    /** Moving obstacles: {@code energy} in J per metre and kg, {@code turnEnergy} in J per radian and kg. */
    public record Move(double energy, double turnEnergy, double speed) {
        public static final Move DEFAULT = new Move(0.3, 0.1, 0.5);
    }

    /** Makes an actor of the default body that has all five abilities. */
    public static Actor standard(String id) {
        return new Actor(
                id,
                "",
                "",
                1.7,
                0.10,
                0.25,
                0.6,
                Walk.DEFAULT,
                Optional.of(Sidestep.DEFAULT),
                Optional.of(Stride.DEFAULT),
                Optional.of(Vault.DEFAULT),
                Optional.of(Move.DEFAULT));
    }

    /** Makes an actor that only walks, a disc of the given radius whose foot radius is {@code footRadius}. */
    public static Actor walker(String id, double radius, double footRadius) {
        return new Actor(
                id,
                "",
                "",
                1.7,
                footRadius,
                0.25,
                0.6,
                new Walk(radius, 1, 1.3),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }

    /** Returns the abilities this actor has, in the order of {@link Ability}. */
    public Set<Ability> abilities() {
        Set<Ability> all = EnumSet.of(Ability.WALK);
        sidestep.ifPresent(a -> all.add(Ability.SIDESTEP));
        stride.ifPresent(a -> all.add(Ability.STRIDE));
        vault.ifPresent(a -> all.add(Ability.VAULT));
        move.ifPresent(a -> all.add(Ability.MOVE));
        return all;
    }

    /**
     * Returns this actor without the abilities that preferences switch off.
     *
     * @throws IllegalArgumentException if they switch off walking
     */
    public Actor under(Preferences preferences) {
        Set<Ability> off = EnumSet.noneOf(Ability.class);
        for (Ability ability : Ability.values()) {
            if (!preferences.allows(ability)) {
                off.add(ability);
            }
        }
        return without(off);
    }

    /**
     * Returns this actor without the given abilities.
     *
     * @throws IllegalArgumentException if walking is among them
     */
    public Actor without(Set<Ability> lost) {
        if (lost.contains(Ability.WALK)) {
            throw new IllegalArgumentException("an actor without the ability to walk");
        }
        return new Actor(
                id,
                label,
                colour,
                bodyHeight,
                footRadius,
                stepHeight,
                maxBorder,
                walk,
                sidestep.filter(a -> !lost.contains(Ability.SIDESTEP)),
                stride.filter(a -> !lost.contains(Ability.STRIDE)),
                vault.filter(a -> !lost.contains(Ability.VAULT)),
                move.filter(a -> !lost.contains(Ability.MOVE)));
    }

    @Override
    public Actor named(String otherId, String otherLabel) {
        return new Actor(
                otherId,
                otherLabel,
                colour,
                bodyHeight,
                footRadius,
                stepHeight,
                maxBorder,
                walk,
                sidestep,
                stride,
                vault,
                move);
    }
}
