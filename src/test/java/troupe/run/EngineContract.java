package troupe.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import troupe.run.view.Aspect;
import troupe.run.view.Overlay;
import troupe.search.Outcome;

/** States what every engine keeps to. A planner's test implements it with tasks of its own. */
@SuppressWarnings("exports")
public interface EngineContract {

    /** Makes new engines, none yet at work, for tasks that end: some with an answer, some without one. */
    List<Engine> engines();

    @Test
    default void slicedEqualsWhole() {
        List<Engine> whole = engines();
        for (long budget : new long[] {1, 7, Long.MAX_VALUE}) {
            List<Engine> sliced = engines();
            for (int i = 0; i < whole.size(); i++) {
                while (sliced.get(i).step(budget).isRunning()) {
                    assertTrue(sliced.get(i).outcome().isRunning());
                }
                whole.get(i).finish();
                assertSame(whole.get(i).run(), sliced.get(i).run(), "task " + i + ", budget " + budget);
            }
        }
    }

    @Test
    default void interleavedEqualsAlone() {
        List<Engine> alone = engines();
        List<Engine> first = engines();
        List<Engine> second = engines();
        for (int i = 0; i < alone.size(); i++) {
            Engine other = second.get((i + 1) % alone.size());
            while (first.get(i).step(5).isRunning() | other.step(3).isRunning()) {
                assertNotNull(first.get(i).outcome());
            }
            assertSame(alone.get(i).finish(), first.get(i).run(), "task " + i);
        }
    }

    @Test
    default void staysAsItIsAfterTheEnd() {
        for (Engine engine : engines()) {
            Run run = engine.finish();
            Outcome outcome = engine.outcome();
            assertFalse(outcome.isRunning());
            assertEquals(outcome, engine.step(1000));
            engine.cancel();
            assertEquals(outcome, engine.outcome());
            assertEquals(1, engine.progress().share());
            assertSame(run, engine.run(), "after the end");
        }
    }

    @Test
    default void canBeCancelledBeforeAndDuringTheWork() {
        for (Engine engine : engines()) {
            engine.cancel();
            assertEquals(Outcome.CANCELLED, engine.step(1));
            assertNotNull(engine.run().report());
        }
        for (Engine engine : engines()) {
            if (engine.step(1).isRunning()) {
                engine.cancel();
                assertEquals(Outcome.CANCELLED, engine.outcome());
                long work = engine.progress().work();
                assertEquals(Outcome.CANCELLED, engine.step(1000));
                assertEquals(work, engine.progress().work());
                assertEquals(Outcome.CANCELLED, engine.run().outcome());
            }
        }
    }

    @Test
    default void showsViewsRunAndProgressAtAnyTime() {
        for (Engine engine : engines()) {
            long work = 0;
            do {
                for (Overlay overlay : engine.overlays()) {
                    assertFalse(overlay.key().isEmpty());
                }
                assertNotNull(engine.run().frames());
                assertTrue(engine.progress().work() >= work, "work shrinks");
                work = engine.progress().work();
            } while (engine.step(50).isRunning());
            assertNotNull(engine.overlays());
        }
    }

    @Test
    default void showsTheViewsOfEveryChoice() {
        for (Engine engine : engines()) {
            assertNotNull(engine.aspects(List.of()));
            engine.finish();
            List<Aspect> aspects = engine.aspects(List.of());
            assertEquals(aspects, engine.aspects(List.of(-1)), "no choice");
            assertEquals(keys(engine.overlays()), keys(engine.overlays(List.of())), "no choice");
            for (int i = 0; i < aspects.size(); i++) {
                Integer[] last = new Integer[i + 1];
                Arrays.fill(last, 0);
                last[i] = aspects.get(i).choices().size() - 1;
                List<Integer> chosen = List.of(last);
                assertEquals(aspects.get(i), engine.aspects(chosen).get(i), "an aspect depends on itself");
                assertNotNull(engine.overlays(chosen));
            }
        }
    }

    private static List<String> keys(List<Overlay> overlays) {
        return overlays.stream().map(Overlay::key).toList();
    }

    @Test
    default void refusesABudgetOfNothing() {
        for (Engine engine : engines()) {
            assertThrows(IllegalArgumentException.class, () -> engine.step(0));
        }
    }

    private static void assertSame(Run expected, Run actual, String which) {
        assertEquals(expected.outcome(), actual.outcome(), which);
        assertEquals(Digest.of(expected.frames()), Digest.of(actual.frames()), which);
        assertEquals(timeless(expected.report()), timeless(actual.report()), which);
        assertEquals(expected.legs().size(), actual.legs().size(), which);
        for (int i = 0; i < expected.legs().size(); i++) {
            Run.Leg a = expected.legs().get(i);
            Run.Leg b = actual.legs().get(i);
            assertEquals(a.ability() + a.what() + a.begin() + a.end(), b.ability() + b.what() + b.begin() + b.end());
        }
    }

    private static Map<String, Object> timeless(Report report) {
        return report.values().entrySet().stream()
                .filter(e -> !e.getKey().endsWith("_ms"))
                .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue));
    }
}
