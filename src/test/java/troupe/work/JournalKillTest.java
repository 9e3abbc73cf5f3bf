package troupe.work;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Kills a process that simulates; fifty times by {@code troupe.bench.JournalKills}, a few times here. */
class JournalKillTest {
    private static final long SEED = Long.getLong("seed", 20_261_122);

    @TempDir
    Path folder;

    @Test
    void everythingThatWasKeptBeforeAKillCanBeOpened() throws Exception {
        SplittableRandom random = new SplittableRandom(SEED);
        for (int k = 0; k < 3; k++) {
            long[] found = KilledRuns.kill(folder, random, 150);
            assertTrue(found[0] >= found[1] && found[1] > 0, "seed " + SEED + ", kill " + k);
        }
    }
}
