package troupe.unified.cost;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Preferences;

class JourneyCostsTest {
    private static final int WALK = Ability.WALK.bit();
    private static final int SIDESTEP = Ability.SIDESTEP.bit();

    private static JourneyCosts standard(Preferences preferences) {
        return new JourneyCosts(Actor.standard("a"), preferences, 0.1);
    }

    @Test
    void stepsCostLengthTimesEnergyTimesPreference() {
        JourneyCosts costs = standard(Preferences.NEUTRAL.with(Ability.STRIDE, 2));
        assertEquals(0.1, costs.joules(costs.standing(WALK, 0)), 1e-10);
        assertEquals(0.1 * Math.sqrt(2), costs.joules(costs.standing(WALK | SIDESTEP, 4)), 1e-10);
        assertEquals(0.2, costs.joules(costs.standing(SIDESTEP, 3)), 1e-10);
        assertEquals(0.3, costs.joules(costs.crossing(Kind.GAP, 1)), 1e-10);
        assertEquals(2.0, costs.joules(costs.takeOffUnits(Kind.GAP)), 1e-10);
        assertEquals(0.3, costs.joules(costs.crossing(Kind.JUMPABLE, 2)), 1e-10);
        assertEquals(4.0, costs.joules(costs.takeOffUnits(Kind.JUMPABLE)), 1e-10);
        assertEquals(JourneyCosts.BLOCKED, costs.standing(0, 0));
        assertEquals(costs.standing(WALK, 0), costs.cheapestStraight());
    }

    @Test
    void theCheapestStraightStepIsTwoToTheThirtyTwoUnits() {
        JourneyCosts costs = standard(Preferences.NEUTRAL);
        assertEquals(1L << 32, costs.cheapestStraight());
        assertEquals(32, costs.unitBits());
    }

    @Test
    void unitsGetCoarserWherePricesLieFarApartAndSumsStillFit() {
        JourneyCosts costs = standard(Preferences.NEUTRAL.with(Ability.VAULT, 1e6));
        long vault = costs.crossing(Kind.JUMPABLE, 4) + costs.takeOffUnits(Kind.JUMPABLE);
        assertTrue(costs.unitBits() < 32);
        assertTrue(vault < (1L << 62) >> 24, "2^24 of the dearest steps fit");
        String message = assertThrows(
                        IllegalArgumentException.class, () -> standard(Preferences.NEUTRAL.with(Ability.VAULT, 1e14)))
                .getMessage();
        assertTrue(message.contains("1e12"), message);
    }

    @Test
    void theCheaperStandingAbilityIsUsedAndTiesGoToWalking() {
        assertSame(Ability.WALK, standard(Preferences.NEUTRAL).ability(Kind.STABLE, WALK | SIDESTEP));
        JourneyCosts even = standard(Preferences.NEUTRAL.with(Ability.WALK, 2));
        assertSame(Ability.WALK, even.ability(Kind.BORDER, WALK | SIDESTEP));
        JourneyCosts dear = standard(Preferences.NEUTRAL.with(Ability.WALK, 2.5));
        assertSame(Ability.SIDESTEP, dear.ability(Kind.STABLE, WALK | SIDESTEP));
        assertSame(Ability.STRIDE, dear.ability(Kind.GAP, 0));
        assertSame(Ability.VAULT, dear.ability(Kind.JUMPABLE, 0));
        assertThrows(IllegalArgumentException.class, () -> dear.ability(Kind.STABLE, Ability.VAULT.bit()));
    }

    @Test
    void anAbilitySwitchedOffCannotBeUsed() {
        JourneyCosts costs = standard(
                Preferences.NEUTRAL.with(Ability.SIDESTEP, Preferences.OFF).with(Ability.VAULT, Preferences.OFF));
        assertFalse(costs.has(Ability.SIDESTEP));
        assertEquals(JourneyCosts.BLOCKED, costs.standing(SIDESTEP, 0));
        assertEquals(JourneyCosts.BLOCKED, costs.crossing(Kind.JUMPABLE, 0));
        assertThrows(
                IllegalArgumentException.class,
                () -> standard(Preferences.NEUTRAL.with(Ability.WALK, Preferences.OFF)));
    }

    @Test
    void limitsAreInclusive() {
        JourneyCosts costs = standard(Preferences.NEUTRAL);
        assertTrue(0.6 <= costs.limit(Kind.BORDER));
        assertTrue(0.6 + 1e-8 > costs.limit(Kind.BORDER));
        assertTrue(1.1 * 0.9 <= costs.limit(Kind.GAP));
        assertTrue(1.1 * 1.4 <= costs.limit(Kind.JUMPABLE));
    }

    @Test
    void freeAbilitiesAreAllowed() {
        Actor walker = Actor.walker("a", 0.25, 0.1);
        Actor free = new Actor(
                "a",
                "",
                "",
                walker.bodyHeight(),
                walker.footRadius(),
                walker.stepHeight(),
                walker.maxBorder(),
                new Actor.Walk(0.25, 0, 1),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
        JourneyCosts costs = new JourneyCosts(free, Preferences.NEUTRAL, 0.1);
        assertEquals(0, costs.standing(WALK, 4));
        assertEquals(0, costs.cheapestStraight());
    }
}
