package troupe.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class LabelPoolTest {
    @Test
    void keepsEveryColumnWhileItGrows() {
        LabelPool pool = new LabelPool(1);
        for (int i = 0; i < 1_000; i++) {
            assertEquals(i, pool.add(11 * i, 3 * i, i - 1, 5L * i, 0.25 * i, 7 * i, i - 2));
        }
        pool.setNext(10, 999);
        pool.setTask(20, 5);
        for (int i = 0; i < 1_000; i++) {
            assertEquals(11 * i, pool.space(i));
            assertEquals(3 * i, pool.state(i));
            assertEquals(i == 20 ? 5 : LabelPool.NONE, pool.task(i));
            assertEquals(i - 1, pool.parent(i));
            assertEquals(5L * i, pool.cost(i));
            assertEquals(0.25 * i, pool.used(i));
            assertEquals(7 * i, pool.begin(i));
            assertEquals(i == 10 ? 999 : i - 2, pool.next(i));
        }
        pool.clear();
        assertEquals(0, pool.size());
    }

    @Test
    void refusesToHaveNoRoom() {
        assertThrows(IllegalArgumentException.class, () -> new LabelPool(0));
    }
}
