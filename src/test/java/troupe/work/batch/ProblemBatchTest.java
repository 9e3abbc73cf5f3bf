package troupe.work.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import troupe.exchange.scenario.MovingAiMap;
import troupe.exchange.scenario.MovingAiProblems;

class ProblemBatchTest {
    private static final int PROBLEMS = 200;

    private static ProblemBatch batch() throws Exception {
        String map = "type octile\nheight 4\nwidth 4\nmap\n....\n....\n....\n....\n";
        String problem = "0\tsmall.map\t4\t4\t0\t0\t3\t3\t4.24264069\n";
        String problems = "version 1\n" + problem.repeat(PROBLEMS);
        return new ProblemBatch(
                MovingAiMap.read(new ByteArrayInputStream(map.getBytes(StandardCharsets.US_ASCII)), "small.map"),
                MovingAiProblems.read(
                        new ByteArrayInputStream(problems.getBytes(StandardCharsets.US_ASCII)), "small.scen"));
    }

    @Test
    void solvesAllInOrder() throws Exception {
        ProblemBatch batch = batch();
        List<ProblemBatch.Row> rows = new ArrayList<>();
        batch.run(2, () -> false, rows::add);
        assertEquals(PROBLEMS, rows.size());
        assertTrue(rows.stream().allMatch(batch::equal));
    }

    @Test
    void noticesThatItIsCancelledWithinAChunkAndKeepsWhatIsComplete() throws Exception {
        ProblemBatch batch = batch();
        List<ProblemBatch.Row> rows = new ArrayList<>();
        AtomicInteger asked = new AtomicInteger();
        batch.run(1, () -> asked.incrementAndGet() > 20, rows::add);
        assertTrue(!rows.isEmpty() && rows.size() < 20, rows.size() + " rows");
        assertTrue(rows.stream().allMatch(r -> r.outcome().isFound()));
    }
}
