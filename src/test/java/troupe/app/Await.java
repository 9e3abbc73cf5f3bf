package troupe.app;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javax.swing.Timer;

/** Waits until something holds, which is looked at on the event thread again and again. */
public final class Await {
    private static final int LOOK_MS = 15;
    private static final int LIMIT_S = 30;

    private Await() {}

    /** Waits until a condition holds; fails with its name after half a minute. */
    public static void until(String what, BooleanSupplier condition) {
        CountDownLatch holds = new CountDownLatch(1);
        Timer timer = new Timer(LOOK_MS, e -> {
            if (condition.getAsBoolean()) {
                holds.countDown();
            }
        });
        timer.setInitialDelay(0);
        timer.start();
        try {
            assertTrue(holds.await(LIMIT_S, TimeUnit.SECONDS), "never came to pass: " + what);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        } finally {
            timer.stop();
        }
    }
}
