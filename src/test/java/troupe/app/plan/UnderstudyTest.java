package troupe.app.plan;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import troupe.app.Scenes;

class UnderstudyTest {
    /** The event thread tells each moment that is shown; it once waited until the engine had made its grid. */
    @Test
    void whoeverTellsItWhereToGoNeverWaitsForItsWork() throws InterruptedException {
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch told = new CountDownLatch(1);
        CountDownLatch ended = new CountDownLatch(1);
        AtomicBoolean inTime = new AtomicBoolean();
        Understudy understudy = new Understudy(() -> {
            begun.countDown();
            try {
                inTime.set(told.await(10, TimeUnit.SECONDS));
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            ended.countDown();
            return new Walkers(Scenes.room(), "go", 100);
        });
        understudy.follow(1, List.of());
        assertTrue(begun.await(10, TimeUnit.SECONDS));
        understudy.follow(2, List.of());
        told.countDown();
        assertTrue(ended.await(10, TimeUnit.SECONDS));
        assertTrue(inTime.get(), "telling waited for the work");
    }
}
