package troupe.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import troupe.run.file.RunException;
import troupe.work.KilledRuns;

/**
 * Kills a process that simulates a crowd with a journal at fifty random moments, and opens what each left; ends with
 * an exception at the first that holds less than had been kept. Arguments: number of kills, seed.
 */
public final class JournalKills {
    private JournalKills() {}

    /** Kills and reports. */
    public static void main(String[] arguments) throws IOException, RunException, InterruptedException {
        int kills = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 50;
        long seed = arguments.length > 1 ? Long.parseLong(arguments[1]) : 1;
        SplittableRandom random = new SplittableRandom(seed);
        Path folder = Files.createTempDirectory("kills");
        int torn = 0;
        for (int k = 1; k <= kills; k++) {
            long[] found = KilledRuns.kill(folder, random, 700);
            torn += found[2] > 0 ? 1 : 0;
            System.out.printf(
                    "kill %d: %d frames recovered, %d had been told, %d bytes cut off%n",
                    k, found[0], found[1], found[2]);
        }
        Files.delete(folder);
        System.out.printf(
                "%d of %d opened with all that had been kept; %d with a record cut off%n", kills, kills, torn);
    }
}
