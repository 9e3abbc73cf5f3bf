package troupe.app.play;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.app.Scenes;
import troupe.app.play.Figures.Stretch;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.Frames;
import troupe.scene.Ability;
import troupe.search.Outcome;

class FiguresTest {
    private static final Frames NONE = new Frames() {
        @Override
        public List<Channel> channels() {
            return List.of();
        }

        @Override
        public double rate() {
            return 25;
        }

        @Override
        public int count() {
            return 0;
        }

        @Override
        public double value(int frame, int channel, int k) {
            throw new IndexOutOfBoundsException();
        }
    };

    private static Run run(Run.Leg... legs) {
        return new Run(Scenes.room(), "there", Outcome.FOUND, Report.builder().build(), NONE, List.of(legs), List.of());
    }

    private static Run.Leg leg(String ability, String what, double begin, double end, double energy, double... xs) {
        List<double[]> points = java.util.Arrays.stream(xs)
                .mapToObj(x -> new double[] {x, 0, 5 * x})
                .toList();
        return new Run.Leg("ann", ability, what, begin, end, energy, points);
    }

    private final Run run = run(
            leg("walk", "", 0, 2, 3, 0, 1, 3),
            leg("walk", "", 2, 3, 1, 3, 4),
            leg("vault", "crate", 3, 4, 8, 4, 5),
            leg("walk", "", 4, 5, 2, 5, 7));

    @Test
    void tellsWhatWasMovedAndHowFar() {
        Report moved = Report.builder()
                .put(
                        "moved",
                        List.of(
                                Report.builder()
                                        .put("id", "crate")
                                        .put("length", 1.5)
                                        .build(),
                                "gone"))
                .build();
        Run moving = new Run(Scenes.room(), "there", Outcome.FOUND, moved, NONE, List.of(), List.of());
        assertEquals(
                List.of(new Figures.Move("crate", 1.5), new Figures.Move("gone", Double.NaN)), Figures.moves(moving));
        assertEquals(List.of(), Figures.moves(run));
    }

    @Test
    void sumsEnergyAndLengthSeenFromAbove() {
        assertEquals(14, Figures.energy(run));
        assertEquals(7, Figures.length(run));
        double[] energy = new double[Ability.values().length];
        energy[Ability.WALK.ordinal()] = 6;
        energy[Ability.VAULT.ordinal()] = 8;
        assertArrayEquals(energy, Figures.energyByAbility(run));
    }

    @Test
    void joinsLegsOfOneAbility() {
        assertEquals(
                List.of(
                        new Stretch(Optional.of(Ability.WALK), "", 0, 3, 4),
                        new Stretch(Optional.of(Ability.VAULT), "crate", 3, 4, 8),
                        new Stretch(Optional.of(Ability.WALK), "", 4, 5, 2)),
                Figures.stretches(run));
    }

    @Test
    void spendsEnergyEvenlyWithinALeg() {
        assertEquals(0, Figures.energyUntil(run, -1));
        assertEquals(1.5, Figures.energyUntil(run, 1));
        assertEquals(8, Figures.energyUntil(run, 3.5));
        assertEquals(14, Figures.energyUntil(run, 99));
    }

    @Test
    void findsTheLegUnderWay() {
        assertEquals("walk", Figures.legAt(run, 2.9).orElseThrow().ability());
        assertEquals("vault", Figures.legAt(run, 3).orElseThrow().ability());
        assertEquals("walk", Figures.legAt(run, 99).orElseThrow().ability());
        assertEquals(Optional.empty(), Figures.legAt(run(), 0));
    }
}
