package troupe.work.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.work.Tasks;

class BatchTest {
    private static final Scene SCENE = new Scene(
            "",
            new World(6, 4, 0.2),
            List.of(),
            List.of(),
            List.of(Actor.standard("anna")),
            List.of(Journey.of("go", "anna", Place.of(1, 1), Place.of(5, 2.5))));

    @Test
    void casesComeInOrderFirstAxisSlowestSeedFastest() {
        Batch batch = new Batch(
                SCENE,
                "go",
                List.of(
                        new Batch.Axis("preference.walk", List.of("1", "2")),
                        new Batch.Axis("goal", List.of("5,2.5", "4,2"))),
                List.of(3L, 1L));
        assertEquals(8, batch.size());
        List<String> seen = new ArrayList<>();
        batch.run(
                3,
                () -> false,
                row -> seen.add(row.of().values() + " " + row.of().seed()));
        assertEquals(
                List.of(
                        "[1, 5,2.5] 3",
                        "[1, 5,2.5] 1",
                        "[1, 4,2] 3",
                        "[1, 4,2] 1",
                        "[2, 5,2.5] 3",
                        "[2, 5,2.5] 1",
                        "[2, 4,2] 3",
                        "[2, 4,2] 1"),
                seen);
    }

    @Test
    void settingsReachThePlanner() {
        List<Object> costs = new ArrayList<>();
        new Batch(SCENE, "go", List.of(new Batch.Axis("preference.walk", List.of("1", "2"))), List.of(1L))
                .run(1, () -> false, row -> costs.add(row.report().values().get("cost")));
        assertEquals((double) costs.get(1), 2 * (double) costs.get(0), 1e-9);
    }

    @Test
    void wrongSettingsAreRefusedBeforeAnyWork() {
        List<Batch.Axis> unknown = List.of(new Batch.Axis("frob", List.of("1")));
        assertThrows(IllegalArgumentException.class, () -> new Batch(SCENE, "go", unknown, List.of(1L)));
        List<Batch.Axis> bad = List.of(new Batch.Axis("preference.walk", List.of("1", "x")));
        assertThrows(IllegalArgumentException.class, () -> new Batch(SCENE, "go", bad, List.of(1L)));
        List<Batch.Axis> lame = List.of(new Batch.Axis("preference.walk", List.of("1", "off")));
        String reason = assertThrows(
                        IllegalArgumentException.class, () -> new Batch(SCENE, "go", lame, List.of(1L, 2L)))
                .getMessage();
        assertTrue(reason.startsWith("preference.walk=off: "), reason);
        assertThrows(IllegalArgumentException.class, () -> new Batch.Axis("cell", List.of()));
        List<Long> seeds = LongStream.range(0, 2_000).boxed().toList();
        List<Batch.Axis> many = List.of(new Batch.Axis(
                "slice", LongStream.range(1, 1_000).mapToObj(Long::toString).toList()));
        assertThrows(IllegalArgumentException.class, () -> new Batch(SCENE, "go", many, seeds));
    }

    @Test
    void interruptionKeepsTheRowsThatAreComplete() {
        Batch batch = new Batch(
                SCENE, "go", List.of(), LongStream.range(0, 50).boxed().toList());
        List<Long> seen = Collections.synchronizedList(new ArrayList<>());
        batch.run(2, () -> seen.size() >= 5, row -> seen.add(row.of().seed()));
        assertTrue(seen.size() >= 5 && seen.size() < 50, seen.toString());
        assertEquals(LongStream.range(0, seen.size()).boxed().toList(), seen);
    }

    @Test
    void anUnknownTaskNamesTheKnownOnes() {
        assertEquals(
                "unknown task 'come'; the scene has go",
                assertThrows(IllegalArgumentException.class, () -> Tasks.start(SCENE, "come"))
                        .getMessage());
    }
}
