package troupe.app.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import troupe.app.OnEventThread;
import troupe.app.Scenes;
import troupe.app.document.Version;
import troupe.run.Engine;
import troupe.run.Run;
import troupe.run.view.Overlay;
import troupe.scene.Ability;
import troupe.scene.Journey;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.search.Outcome;
import troupe.work.explain.Explanation;
import troupe.work.explain.Route;

class LivePlannerTest implements PlanningSteps {
    private static final long FOREVER = 1_000_000;
    private static final Run.Leg VAULT = new Run.Leg("ann", "vault", "crate", 0, 1, 2, List.of());
    private static final Run.Leg ROUND = new Run.Leg("ann", "walk", "", 0, 1, 6, List.of());

    private final BlockingQueue<Plan> told = new LinkedBlockingQueue<>();
    private final BlockingQueue<Work> works = new LinkedBlockingQueue<>();
    private final Map<Scene, Runnable> during = new ConcurrentHashMap<>();
    private final Map<Scene, List<Problem>> problems = new ConcurrentHashMap<>();
    private final Map<Scene, Runnable> whileViewing = new ConcurrentHashMap<>();
    private final BlockingQueue<List<Boolean>> asked = new LinkedBlockingQueue<>();
    private volatile Runnable whileExplaining = () -> {};
    private LivePlanner planner;

    @Override
    public List<Problem> check(Scene scene) {
        assertFalse(EventQueue.isDispatchThread());
        return problems.getOrDefault(scene, List.of());
    }

    @Override
    public List<Problem> inspect(Scene scene) {
        assertFalse(EventQueue.isDispatchThread());
        return List.of(new Problem(Severity.WARNING, "crate", 0, "inspected", ""));
    }

    @Override
    public Engine start(Scene scene, String task) {
        assertFalse(EventQueue.isDispatchThread());
        Journey journey = (Journey) scene.task(task).orElseThrow();
        boolean vaults = journey.preferences().of(Ability.VAULT) < 3;
        Runnable each =
                journey.preferences().allows(Ability.VAULT) ? during.getOrDefault(scene, () -> {}) : whileExplaining;
        return new ScriptedEngine(scene, task, 3, List.of(vaults ? VAULT : ROUND), each);
    }

    @Override
    public List<Overlay> overlays(
            Scene scene, String task, Engine engine, List<Integer> chosen, Predicate<String> wanted) {
        assertFalse(EventQueue.isDispatchThread());
        asked.add(List.of(wanted.test("trigger"), wanted.test("clearance")));
        whileViewing.getOrDefault(scene, () -> {}).run();
        return engine.overlays(chosen, wanted);
    }

    private void begin(long patienceMs) {
        planner = new LivePlanner(this, EventQueue::invokeLater, patienceMs);
        planner.plans().add(plan -> {
            assertTrue(EventQueue.isDispatchThread());
            told.add(plan);
        });
        planner.works().add(works::add);
    }

    @AfterEach
    void close() {
        planner.close();
    }

    private static Snapshot snapshot(long revision, long preview) {
        Scene scene = Scenes.room();
        Scene titled = new Scene(
                revision + "." + preview,
                scene.world(),
                scene.obstacles(),
                scene.ditches(),
                scene.actors(),
                scene.tasks());
        return new Snapshot(new Version(revision, preview), titled, "there");
    }

    private void request(Snapshot snapshot) {
        OnEventThread.run(() -> planner.request(snapshot));
    }

    private Plan next() throws InterruptedException {
        Plan plan = told.poll(20, TimeUnit.SECONDS);
        assertNotNull(plan, "nothing was told");
        return plan;
    }

    /** Holds the work on a snapshot, once it has begun, until another has been asked for. */
    private void replaceDuring(Snapshot first, Snapshot second) throws InterruptedException {
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch goOn = new CountDownLatch(1);
        during.put(first.scene(), () -> {
            begun.countDown();
            await(goOn);
        });
        request(first);
        assertTrue(begun.await(20, TimeUnit.SECONDS));
        request(second);
        goOn.countDown();
    }

    private static void await(CountDownLatch latch) {
        try {
            assertTrue(latch.await(20, TimeUnit.SECONDS));
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void tellsThePlanThenItsViewsThenWhatElseCouldBeDone() throws InterruptedException {
        begin(FOREVER);
        request(snapshot(1, 0));
        Plan plan = next();
        assertTrue(plan.run().orElseThrow().outcome().isFound());
        assertEquals(List.of(), plan.overlays());
        assertEquals(1, next().overlays().size());
        Plan inspected = next();
        assertEquals("inspected", inspected.problems().get(0).message());
        List<Route> routes = next().why().orElseThrow().without();
        assertEquals(
                List.of(EnumSet.of(Ability.VAULT), EnumSet.complementOf(EnumSet.of(Ability.WALK))),
                routes.stream().map(Route::without).toList());
        Journey without = (Journey) routes.get(0).run().scene().task("there").orElseThrow();
        assertFalse(without.preferences().allows(Ability.VAULT));
        assertTrue(without.preferences().allows(Ability.STRIDE));
        Explanation whole = next().why().orElseThrow();
        assertEquals(3, whole.givenUp(Ability.VAULT).orElseThrow().times(), 1e-9);
    }

    @Test
    void aNewRequestEndsTheExplanationOfTheOneBefore() throws InterruptedException {
        begin(FOREVER);
        replaceWhileExplaining(snapshot(1, 0), snapshot(2, 0));
        Plan plan = next();
        while (plan.snapshot().version().revision() == 1) {
            assertTrue(plan.why().isEmpty());
            plan = next();
        }
        assertEquals(2, plan.snapshot().version().revision());
    }

    /** Asks for another snapshot while the first one is planned without its ability to vault. */
    private void replaceWhileExplaining(Snapshot first, Snapshot second) throws InterruptedException {
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch goOn = new CountDownLatch(1);
        whileExplaining = () -> {
            begun.countDown();
            await(goOn);
        };
        request(first);
        assertTrue(begun.await(20, TimeUnit.SECONDS));
        request(second);
        goOn.countDown();
    }

    @Test
    void anOlderRevisionIsCancelledAndNeverTold() throws InterruptedException {
        begin(FOREVER);
        replaceDuring(snapshot(1, 0), snapshot(2, 0));
        assertEquals(2, next().snapshot().version().revision());
    }

    @Test
    void anEarlierMomentOfAGestureMayFinish() throws InterruptedException {
        begin(FOREVER);
        replaceDuring(snapshot(1, 1), snapshot(1, 2));
        assertEquals(1, next().snapshot().version().preview());
        Plan second = next();
        if (second.snapshot().version().preview() == 1) {
            assertEquals(1, second.overlays().size(), "its views may come before the second plan");
            second = next();
        }
        assertEquals(2, second.snapshot().version().preview());
    }

    @Test
    void anEarlierMomentThatTakesTooLongIsCancelled() throws InterruptedException {
        begin(-1);
        replaceDuring(snapshot(1, 1), snapshot(1, 2));
        assertEquals(2, next().snapshot().version().preview());
    }

    @Test
    void aMomentOfAGestureIsNotExplained() throws InterruptedException {
        begin(FOREVER);
        request(snapshot(1, 1));
        next();
        next();
        request(snapshot(2, 0));
        assertEquals(2, next().snapshot().version().revision());
    }

    @Test
    void cancelEndsTheWorkUnderWay() throws InterruptedException {
        begin(FOREVER);
        Snapshot snapshot = snapshot(1, 0);
        during.put(snapshot.scene(), () -> planner.cancel());
        request(snapshot);
        assertEquals(Outcome.CANCELLED, next().run().orElseThrow().outcome());
    }

    private static double x(Plan plan) {
        return ((Overlay.Points) plan.overlays().get(0)).coordinates()[0];
    }

    @Test
    void viewsOfAnotherChoiceAreMadeOfThePlanThatIsThere() throws InterruptedException {
        begin(FOREVER);
        request(snapshot(1, 0));
        Plan plan = next();
        while (plan.why().isEmpty() || plan.why().get().flips().isEmpty()) {
            plan = next();
        }
        assertEquals(1, x(plan));
        OnEventThread.run(() -> planner.look(List.of(1)));
        Plan other = next();
        assertEquals(2, x(other));
        assertEquals(2, other.views().aspects().get(1).choices().size());
        assertSame(plan.run().orElseThrow(), other.run().orElseThrow());
        assertEquals(plan.why(), other.why());
        request(snapshot(2, 1));
        next();
        assertEquals(2, x(next()), "the choice stays");
    }

    @Test
    void viewsOfAnotherChoiceComeBeforeTheExplanationEnds() throws InterruptedException {
        begin(FOREVER);
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch goOn = new CountDownLatch(1);
        whileExplaining = () -> {
            begun.countDown();
            await(goOn);
        };
        request(snapshot(1, 0));
        assertTrue(begun.await(20, TimeUnit.SECONDS));
        OnEventThread.run(() -> planner.look(List.of(1)));
        Plan plan = next();
        while (plan.overlays().isEmpty() || x(plan) == 1) {
            assertTrue(plan.why().isEmpty());
            plan = next();
        }
        assertEquals("inspected", plan.problems().get(0).message());
        goOn.countDown();
        while (plan.why().isEmpty()) {
            plan = next();
            assertEquals(2, x(plan));
        }
    }

    /** Lets the views of a snapshot take until {@code goOn}, deaf to everything, and waits until they have begun. */
    private void stickInTheViews(Snapshot snapshot, CountDownLatch goOn) throws InterruptedException {
        CountDownLatch begun = new CountDownLatch(1);
        whileViewing.put(snapshot.scene(), () -> {
            begun.countDown();
            boolean over = false;
            while (!over) {
                try {
                    over = goOn.await(20, TimeUnit.SECONDS);
                } catch (InterruptedException e) {
                    assertFalse(over);
                }
            }
        });
        request(snapshot);
        assertEquals(snapshot, next().snapshot());
        assertTrue(begun.await(20, TimeUnit.SECONDS));
    }

    @Test
    void anotherSceneIsPlannedThoughTheOldOneIsStuck() throws InterruptedException {
        begin(FOREVER);
        CountDownLatch goOn = new CountDownLatch(1);
        stickInTheViews(snapshot(1, 0), goOn);
        request(snapshot(2, 0));
        assertEquals(2, next().snapshot().version().revision());
        goOn.countDown();
        Plan plan = next();
        while (plan.why().isEmpty()) {
            assertEquals(2, plan.snapshot().version().revision());
            plan = next();
        }
    }

    @Test
    void cancelEndsWorkThatIsStuckAndTheSameSceneCanBePlannedAgain() throws InterruptedException {
        begin(FOREVER);
        CountDownLatch goOn = new CountDownLatch(1);
        Snapshot stuck = snapshot(1, 0);
        stickInTheViews(stuck, goOn);
        works.clear();
        planner.cancel();
        assertEquals(Work.IDLE, works.poll(20, TimeUnit.SECONDS));
        whileViewing.clear();
        Snapshot again = new Snapshot(stuck.version(), stuck.scene(), stuck.task());
        request(again);
        Plan plan = next();
        assertSame(again, plan.snapshot());
        goOn.countDown();
        while (plan.why().isEmpty()) {
            plan = next();
            assertSame(again, plan.snapshot(), "what was left behind is not told");
        }
    }

    @Test
    void noMomentWaitsForTheViewsOfTheOneBefore() throws InterruptedException {
        begin(FOREVER);
        CountDownLatch goOn = new CountDownLatch(1);
        stickInTheViews(snapshot(1, 1), goOn);
        request(snapshot(1, 2));
        Plan second = next();
        assertEquals(2, second.snapshot().version().preview());
        assertEquals(List.of(), second.overlays());
        goOn.countDown();
        Plan lent = next();
        assertEquals(2, lent.snapshot().version().preview(), "views that come late are shown with the plan of now");
        assertSame(second.run().orElseThrow(), lent.run().orElseThrow());
        assertEquals(1, x(lent));
        assertFalse(lent.views().current());
    }

    @Test
    void aPlanIsToldWithTheViewsOfBeforeUntilItsOwnAreMade() throws InterruptedException {
        begin(FOREVER);
        request(snapshot(1, 1));
        next();
        Plan viewed = next();
        request(snapshot(2, 0));
        Plan plan = next();
        assertSame(viewed.overlays(), plan.overlays());
        assertFalse(plan.views().current());
        Plan own = next();
        assertTrue(own.views().current());
    }

    @Test
    void viewsOfAnotherDocumentAreForgotten() throws InterruptedException {
        begin(FOREVER);
        request(snapshot(1, 1));
        next();
        next();
        OnEventThread.run(planner::forget);
        request(snapshot(2, 0));
        assertEquals(List.of(), next().overlays());
    }

    @Test
    void momentsOfAGestureHaveTheViewsThatAreShown() throws InterruptedException {
        begin(FOREVER);
        OnEventThread.run(() -> planner.show(Set.of("trigger")));
        request(snapshot(1, 1));
        next();
        next();
        assertEquals(List.of(true, false), asked.poll(20, TimeUnit.SECONDS));
        request(snapshot(2, 0));
        assertEquals(List.of(true, true), asked.poll(20, TimeUnit.SECONDS));
    }

    @Test
    void aSceneWithErrorsIsNotPlanned() throws InterruptedException {
        begin(FOREVER);
        Snapshot snapshot = snapshot(1, 0);
        Problem error = new Problem(Severity.ERROR, "crate", 0, "twisted", "untwist it");
        problems.put(snapshot.scene(), List.of(error));
        request(snapshot);
        Plan plan = next();
        assertTrue(plan.run().isEmpty());
        assertEquals(List.of(error), plan.problems());
    }

    @Test
    void workIsToldFromPlanningToIdle() throws InterruptedException {
        begin(FOREVER);
        request(snapshot(1, 0));
        Work first = works.poll(20, TimeUnit.SECONDS);
        assertTrue(first.planning());
        Work work = first;
        while (work.planning()) {
            work = works.poll(20, TimeUnit.SECONDS);
            assertNotNull(work);
        }
        assertEquals(Work.IDLE, work);
    }
}
