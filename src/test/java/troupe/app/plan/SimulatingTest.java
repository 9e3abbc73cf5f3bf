package troupe.app.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import troupe.app.Await;
import troupe.app.Scenes;
import troupe.run.Run;
import troupe.run.RunComparison;
import troupe.search.Outcome;

class SimulatingTest {
    private final List<Run> told = new ArrayList<>();
    private final Simulating simulating = new Simulating(fresh(), SimulatingTest::fresh);
    private boolean obsolete;
    private boolean cancelled;

    private static Walkers fresh() {
        return new Walkers(Scenes.room(), "go", 100);
    }

    /** Watches the work and does something with each run that is told. */
    private Simulating.Watcher watcher(Consumer<Run> each) {
        return new Simulating.Watcher() {
            @Override
            public boolean isObsolete() {
                return obsolete;
            }

            @Override
            public boolean isCancelled() {
                return cancelled;
            }

            @Override
            public void publish(Run run, Live live) {
                assertEquals(run.frames().count(), live.stepMillis().length);
                told.add(run);
                each.accept(run);
            }

            @Override
            public void report(long done, double share) {
                assertTrue(done <= 100);
            }
        };
    }

    private Run last() {
        return told.get(told.size() - 1);
    }

    private static double x(Run run, int frame) {
        return run.frames().value(frame, 0, 0);
    }

    @Test
    void leftAloneItRunsToItsEnd() throws InterruptedException {
        assertTrue(simulating.work(watcher(run -> {})));
        assertEquals(Outcome.FOUND, last().outcome());
        assertEquals(100, last().frames().count());
        assertEquals(100, x(last(), 99));
    }

    @Test
    void whatIsSetHoldsFromTheStepThatIsShownAndNothingBeforeItChanges() throws InterruptedException {
        assertTrue(simulating.work(watcher(run -> {})));
        simulating.steering().grab(40);
        simulating.steering().set("speed", 3);
        simulating.steering().release();
        assertTrue(simulating.work(watcher(run -> {})));
        assertEquals(List.of(new Run.Input(40, "speed", 3)), last().inputs());
        assertEquals(40, x(last(), 39));
        assertEquals(43, x(last(), 40));
        assertEquals(220, x(last(), 99));
        simulating.steering().grab(60);
        simulating.steering().set("speed", 0);
        simulating.steering().release();
        assertTrue(simulating.work(watcher(run -> {})));
        assertEquals(List.of(new Run.Input(40, "speed", 3), new Run.Input(60, "speed", 0)), last().inputs());
        assertEquals(100, x(last(), 99));
    }

    @Test
    void whileHeldItStaysNearWhatIsShown() throws InterruptedException {
        simulating.steering().grab(0);
        simulating.work(watcher(run -> {
            int frames = run.frames().count();
            assertTrue(frames <= Steering.LEAD + 10, "frames: " + frames);
            if (frames == Steering.LEAD) {
                simulating.steering().pace(10);
            }
            obsolete = frames == Steering.LEAD + 10;
        }));
        assertEquals(Steering.LEAD + 10, last().frames().count());
    }

    @Test
    void whatIsDroppedTakesItsInputsWithIt() throws InterruptedException {
        simulating.work(watcher(run -> {}));
        simulating.steering().grab(50);
        simulating.steering().set("speed", 3);
        simulating.steering().release();
        simulating.work(watcher(run -> {}));
        simulating.steering().grab(20);
        simulating.steering().release();
        simulating.work(watcher(run -> {}));
        assertEquals(List.of(), last().inputs());
        assertEquals(100, x(last(), 99));
    }

    private static void steer(Simulating one, long step, double speed) {
        one.steering().grab(step);
        one.steering().set("speed", speed);
        one.steering().release();
    }

    @Test
    void whoeverSteersWhereItIsShownGoesOnWithTheUnderstudy() throws InterruptedException {
        List<Walkers> made = new CopyOnWriteArrayList<>();
        Simulating one = new Simulating(fresh(), () -> {
            made.add(fresh());
            return made.get(made.size() - 1);
        });
        one.work(watcher(run -> {}));
        steer(one, 30, 2);
        one.work(watcher(run -> {}));
        assertEquals(1, made.size());
        one.steering().pace(80);
        Await.until(
                "the understudy is there",
                () -> made.size() == 2 && made.get(1).progress().work() == 80);
        steer(one, 81, 3);
        one.work(watcher(run -> {}));
        assertEquals(2, made.size(), "it was simulated from the beginning");
        assertEquals(List.of(new Run.Input(30, "speed", 2), new Run.Input(81, "speed", 3)), last().inputs());
        assertEquals(100, last().frames().count());
        // 30 steps of 1, 51 of 2, 19 of 3
        assertEquals(30 + 102 + 57, x(last(), 99));
    }

    @Test
    void anUnderstudyNeverChangesWhatComesOfSteering() throws InterruptedException {
        long seed = Long.getLong("seed", 11);
        Random random = new Random(seed);
        for (int round = 0; round < 60; round++) {
            simulating.work(watcher(run -> {}));
            for (int k = random.nextInt(4); k > 0; k--) {
                simulating.steering().pace(random.nextInt(100));
                LockSupport.parkNanos(random.nextInt(200_000));
            }
            steer(simulating, random.nextInt(100), random.nextInt(9));
            simulating.work(watcher(run -> {}));
            Walkers again = fresh();
            last().inputs().forEach(again::give);
            again.step(100);
            assertEquals(
                    Optional.empty(),
                    RunComparison.firstDifference(again.run().frames(), last().frames(), 100),
                    "round " + round + " seed " + seed);
        }
    }

    @Test
    void whatIsCancelledTellsWhatThereIsAndCanBeTakenUpAgain() throws InterruptedException {
        simulating.steering().grab(0);
        assertTrue(simulating.work(watcher(run -> cancelled = true)));
        assertEquals(Outcome.CANCELLED, last().outcome());
        cancelled = false;
        simulating.steering().grab(2);
        simulating.steering().release();
        assertTrue(simulating.work(watcher(run -> {})));
        assertEquals(Outcome.FOUND, last().outcome());
    }

    @Test
    void endsWithoutATraceWhenOtherWorkIsWanted() throws InterruptedException {
        obsolete = true;
        assertFalse(simulating.work(watcher(run -> {})));
        assertEquals(List.of(), told);
    }
}
