package troupe.risk.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import troupe.SharedData;
import troupe.risk.forecast.Blur;
import troupe.run.Run;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Growth;
import troupe.scene.Encounter.Method;
import troupe.scene.check.SceneChecks;
import troupe.scene.check.Severity;
import troupe.scene.setting.Settings;
import troupe.scene.xml.TrackTable;
import troupe.search.Outcome;
import troupe.work.batch.EncounterBatch;

/** Checks the studies: random encounters, threads, calibration, recorded walkers. */
class StudyTest {

    @Test
    void aSeedMakesOneSoundEncounter() {
        for (long seed = 1; seed <= 40; seed++) {
            assertTrue(
                    SceneChecks.check(RandomEncounters.scene(seed)).stream()
                            .noneMatch(p -> p.severity() == Severity.ERROR),
                    "seed " + seed);
            assertEquals(RandomEncounters.scene(seed), RandomEncounters.scene(seed));
            assertNotEquals(RandomEncounters.scene(seed), RandomEncounters.scene(seed + 1));
        }
    }

    @Test
    void theRowsAreTheSameOnAnyNumberOfThreads() {
        List<EncounterBatch.Case> cases = new ArrayList<>();
        for (EncounterBatch.Case one : EncounterBatch.random(1, 3)) {
            cases.add(new EncounterBatch.Case(
                    one.name(), Settings.apply(one.scene(), one.task(), "rate", "10"), one.task(), one.recorded()));
        }
        EncounterBatch batch = new EncounterBatch(cases, List.of(Method.RISK));
        List<List<String>> digests = new ArrayList<>();
        for (int threads : new int[] {1, 2, 16}) {
            List<String> rows = new ArrayList<>();
            batch.run(threads, () -> false, row -> rows.add(row.of().name() + row.method() + row.digest()));
            digests.add(rows);
        }
        assertEquals(3, digests.get(0).size());
        assertEquals(digests.get(0), digests.get(1));
        assertEquals(digests.get(0), digests.get(2));
    }

    @Test
    void predictingCollidesLessThanTheOthersAtASmallDetour() {
        double[] collisions = new double[3];
        double[] detour = new double[3];
        List<EncounterBatch.Case> cases = new ArrayList<>();
        for (EncounterBatch.Case one : EncounterBatch.random(3, 12)) {
            cases.add(new EncounterBatch.Case(
                    one.name(), Settings.apply(one.scene(), one.task(), "rate", "10"), one.task(), one.recorded()));
        }
        new EncounterBatch(cases, List.of(Method.values())).run(2, () -> false, row -> {
            assertEquals(Outcome.FOUND, row.run().outcome());
            collisions[row.method().ordinal()] += number(row.run(), "collisions");
            detour[row.method().ordinal()] += number(row.run(), "detour");
        });
        int risk = Method.RISK.ordinal();
        int still = Method.STATIC.ordinal();
        assertTrue(collisions[risk] < collisions[Method.ONCE.ordinal()], "once");
        assertTrue(collisions[risk] < collisions[still], "static");
        assertTrue(detour[risk] <= 1.15 * detour[still], detour[risk] + " against " + detour[still]);
    }

    private static double number(Run run, String key) {
        return ((Number) run.report().values().get(key)).doubleValue();
    }

    @Test
    void aFitFindsTheBlurThatTheErrorsWereDrawnFrom() {
        long seed = 5;
        Random chance = new Random(seed);
        for (Blur drawn : List.of(new Blur(0.1, Growth.LINEAR, 2), new Blur(0.06, Growth.ROOT, 5))) {
            List<double[]> errors = new ArrayList<>();
            for (int k = 1; k <= 8; k++) {
                double sigma = drawn.after(0.4 * k);
                errors.add(DoubleStream.generate(() -> sigma * Math.hypot(chance.nextGaussian(), chance.nextGaussian()))
                        .limit(4_000)
                        .toArray());
            }
            Calibration calibration = new Calibration(errors);
            Blur fitted = calibration.fit(drawn.growth());
            for (double ahead : Calibration.AHEAD) {
                assertEquals(drawn.after(ahead), fitted.after(ahead), 0.02 * drawn.after(ahead), "seed " + seed);
                assertEquals(0.5, calibration.insideHalf(fitted, ahead), 0.03, "seed " + seed);
                assertEquals(0.9, calibration.insideNineTenths(fitted, ahead), 0.02, "seed " + seed);
            }
        }
    }

    @Test
    void aPredictionIsJudgedByWhereThePersonWas() throws Exception {
        // a second straight on at 1 m/s, then straight to the left at the same speed
        StringBuilder text = new StringBuilder("# fps=10\n");
        for (int f = 0; f <= 20; f++) {
            text.append(String.format(
                    Locale.ROOT, "%d,1,%.1f,%.1f%n", f, Math.min(f, 10) / 10.0, Math.max(0, f - 10) / 10.0));
        }
        Calibration calibration = Calibration.of(table(text.toString()), 8, Avatar.DEFAULT_SPEED);
        // predictions are made from 0.1 s on, and judged where the recording goes on for long enough
        assertEquals(16, calibration.count(0.4));
        assertEquals(4, calibration.count(1.6));
        // made at 0.1, 0.2, 0.3 and 0.4 s: 0.7, 0.8, 0.9 and 1 m past the turn, and as much to the side
        assertEquals(Math.hypot(0.9, 0.9), calibration.median(1.6), 1e-9);
        assertThrows(IllegalArgumentException.class, () -> calibration.count(0.5));
        Calibration none = Calibration.of(table("# fps=10\n0,1,0,0\n"), 8, 1.8);
        assertThrows(IllegalArgumentException.class, () -> none.fit(Growth.LINEAR));
    }

    private static TrackTable table(String text) throws Exception {
        return TrackTable.read(
                new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), "walks.csv", OptionalDouble.empty());
    }

    @Test
    void fittingBringsTheSharesOfRealPeopleNearerOnTheOtherSceneToo() throws Exception {
        Calibration hotel = real("hotel");
        Calibration zara = real("zara01");
        Blur usual = new Blur(0.1, Growth.LINEAR, Avatar.DEFAULT_MOBILITY);
        for (Blur fitted : List.of(hotel.fit(Growth.LINEAR), zara.fit(Growth.LINEAR))) {
            assertTrue(off(hotel, fitted) < off(hotel, usual), fitted::toString);
            assertTrue(off(zara, fitted) < off(zara, usual), fitted::toString);
        }
    }

    private static Calibration real(String name) throws Exception {
        try (InputStream in = Files.newInputStream(SharedData.require("pedestrians/" + name + ".csv"))) {
            return Calibration.of(TrackTable.read(in, name, OptionalDouble.empty()), 8, Avatar.DEFAULT_SPEED);
        }
    }

    private static double off(Calibration calibration, Blur blur) {
        double sum = 0;
        for (double ahead : Calibration.AHEAD) {
            sum += Math.abs(calibration.insideHalf(blur, ahead) - 0.5);
            sum += Math.abs(calibration.insideNineTenths(blur, ahead) - 0.9);
        }
        return sum;
    }

    @Test
    void anActorTakesThePlaceOfRecordedWalkers() throws Exception {
        TrackTable tracks;
        try (InputStream in = Files.newInputStream(SharedData.require("pedestrians/zara01.csv"))) {
            tracks = TrackTable.read(in, "zara01", OptionalDouble.empty());
        }
        List<Walkers.Walker> chosen = new Walkers(tracks, List.of()).choose(30);
        assertEquals(30, chosen.stream().map(Walkers.Walker::id).distinct().count());
        Walkers.Walker one = chosen.get(7);
        assertEquals(List.of(), SceneChecks.check(one.scene()));
        Encounter encounter = (Encounter) one.scene().task(Walkers.TASK).orElseThrow();
        assertTrue(encounter.avatar("p" + one.id()).isEmpty(), "the walker himself is not there");
    }
}
