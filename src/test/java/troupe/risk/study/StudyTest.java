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
import org.junit.jupiter.api.Test;
import troupe.SharedData;
import troupe.risk.forecast.Blur;
import troupe.run.Run;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Growth;
import troupe.scene.Encounter.Method;
import troupe.scene.SceneChecks;
import troupe.scene.Settings;
import troupe.scene.Severity;
import troupe.scene.TrackTable;
import troupe.search.Outcome;
import troupe.work.EncounterBatch;

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

    /** Makes people who walk straight and evenly but for what a known Gaussian adds at the end of each walk. */
    private static TrackTable walks(double sigma, double mobility, long seed) throws Exception {
        Random chance = new Random(seed);
        StringBuilder text = new StringBuilder("# fps=10\n");
        int id = 0;
        for (int k = 0; k < 3000; k++) {
            int ahead = 4 * (1 + k % 8);
            double off = sigma * (1 + mobility * ahead / 10.0);
            id++;
            for (int f = 0; f <= 8; f++) {
                text.append(String.format(Locale.ROOT, "%d,%d,%.9f,0%n", f, id, 0.1 * f));
            }
            text.append(String.format(
                    Locale.ROOT,
                    "%d,%d,%.9f,%.9f%n",
                    8 + ahead,
                    id,
                    0.1 * (8 + ahead) + off * chance.nextGaussian(),
                    off * chance.nextGaussian()));
        }
        return TrackTable.read(
                new ByteArrayInputStream(text.toString().getBytes(StandardCharsets.UTF_8)),
                "walks.csv",
                OptionalDouble.empty());
    }

    @Test
    void calibrationJudgesAGaussianByItsOwnDiscs() throws Exception {
        long seed = 5;
        Calibration calibration = Calibration.of(walks(0.1, 2, seed), 8, Avatar.DEFAULT_SPEED);
        // predictions from the middle of the walks see straight lines: only the widest blur tells nothing
        Blur wide = new Blur(10, Growth.CONSTANT, 0);
        for (double ahead : Calibration.AHEAD) {
            assertTrue(calibration.count(ahead) > 0);
            assertEquals(1, calibration.insideHalf(wide, ahead), 1e-9);
        }
        Blur fitted = calibration.fit(Growth.LINEAR);
        assertTrue(fitted.sigma() < 0.15, "seed " + seed + ": " + fitted);
        TrackTable none = TrackTable.read(
                new ByteArrayInputStream("# fps=10\n0,1,0,0\n".getBytes(StandardCharsets.UTF_8)),
                "none.csv",
                OptionalDouble.empty());
        Calibration empty = Calibration.of(none, 8, 1.8);
        assertThrows(IllegalArgumentException.class, () -> empty.fit(Growth.LINEAR));
        assertThrows(IllegalArgumentException.class, () -> calibration.count(0.5));
    }

    @Test
    void fittingBringsTheSharesOfRealPeopleNearerOnTheOtherSceneToo() throws Exception {
        Calibration hotel = real("hotel");
        Calibration zara = real("zara01");
        Blur usual = new Blur(0.1, Growth.LINEAR, Avatar.DEFAULT_MOBILITY);
        Blur fitted = hotel.fit(Growth.LINEAR);
        assertTrue(off(hotel, fitted) < off(hotel, usual));
        assertTrue(off(zara, fitted) < off(zara, usual));
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
