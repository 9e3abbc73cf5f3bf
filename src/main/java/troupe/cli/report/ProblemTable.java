package troupe.cli.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import troupe.work.batch.ProblemBatch;

/** Makes the lines of a table of problems, and counts what they say. */
public final class ProblemTable {
    private final ProblemBatch batch;
    private double[] micros = new double[1024];
    private int count;
    private int different;
    private String firstDifferent = "";

    /** Begins the table of a batch. */
    public ProblemTable(ProblemBatch batch) {
        this.batch = batch;
    }

    /** Returns the line of a row: {@code start,goal,length,optimal,expanded,micros}. */
    public String line(ProblemBatch.Row row) {
        if (count == micros.length) {
            micros = Arrays.copyOf(micros, 2 * count);
        }
        micros[count++] = row.micros();
        var p = row.problem();
        String line = p.startX() + " " + p.startY() + "," + p.goalX() + " " + p.goalY() + ","
                + (Double.isNaN(row.length()) ? "" : String.format(Locale.ROOT, "%.8f", row.length())) + ","
                + p.length() + "," + row.expanded() + ","
                + String.format(Locale.ROOT, "%.1f", row.micros());
        if (!batch.equal(row)) {
            different++;
            firstDifferent = firstDifferent.isEmpty() ? line : firstDifferent;
        }
        return line;
    }

    /** Returns how many lines there were. */
    public int count() {
        return count;
    }

    /** Tells whether every length was the one that the batch expects. */
    public boolean allEqual() {
        return different == 0;
    }

    /** Returns what the table says in a line or two. */
    public List<String> summary() {
        double[] all = Arrays.copyOf(micros, count);
        List<String> lines = new ArrayList<>();
        lines.add(String.format(
                Locale.ROOT,
                "%,d problems, %,d of optimal length; median %.0f us, p99 %.0f us",
                count,
                count - different,
                ProblemBatch.quantile(all, 0.5),
                ProblemBatch.quantile(all, 0.99)));
        if (different > 0) {
            lines.add("first other length: " + firstDifferent);
        }
        return lines;
    }
}
