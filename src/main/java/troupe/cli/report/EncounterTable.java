package troupe.cli.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import troupe.run.Report;
import troupe.scene.Encounter;
import troupe.work.batch.EncounterBatch;

/** Writes the rows of a batch of encounters, and sums them up by method. */
public final class EncounterTable {
    private static final List<String> COLUMNS = List.of(
            "collisions", "smallest_distance", "arrival", "length", "straight", "detour", "mean_risk", "peak_risk");

    private final Map<Encounter.Method, Sums> sums = new LinkedHashMap<>();

    /** What is added up of one method. */
    private static final class Sums {
        private int count;
        private int arrivals;
        private double collisions;
        private int struck;
        private double detour;
        private double risk;
        private double smallest = Double.POSITIVE_INFINITY;
        private double share;
        private final List<Double> medians = new ArrayList<>();
        private final List<Double> firsts = new ArrayList<>();
    }

    /** Returns the line with the names of the columns. */
    public static String header() {
        List<String> words = new ArrayList<>(List.of("case", "method", "outcome", "avatars"));
        words.addAll(COLUMNS);
        words.addAll(List.of("recorded", "frames", "digest", "first_plan_ms", "step_median_ms", "step_p99_ms"));
        return Csv.line(words);
    }

    /** Returns the line of one encounter, and counts it in. */
    public String line(EncounterBatch.Row row) {
        Report report = row.run().report();
        Encounter encounter = (Encounter) row.of().scene().task(row.of().task()).orElseThrow();
        add(row, report);
        List<String> words = new ArrayList<>(List.of(
                row.of().name(),
                word(row.method()),
                row.run().outcome().word(),
                Integer.toString(encounter.avatars().size())));
        for (String column : COLUMNS) {
            Object value = report.values().get(column);
            words.add(value instanceof Double number ? String.format(Locale.ROOT, "%.4f", number) : text(value));
        }
        words.add(
                Double.isNaN(row.of().recorded())
                        ? ""
                        : String.format(Locale.ROOT, "%.2f", row.of().recorded()));
        words.add(Integer.toString(row.run().frames().count()));
        words.add(row.digest());
        for (String key : List.of("first_plan", "step_median", "step_p99")) {
            words.add(String.format(Locale.ROOT, "%.3f", time(report, key)));
        }
        return Csv.line(words);
    }

    private static String text(Object value) {
        return value == null ? "" : value.toString();
    }

    private static String word(Encounter.Method method) {
        return method.name().toLowerCase(Locale.ROOT);
    }

    private static double time(Report report, String key) {
        return report.values().get("times_ms") instanceof Report times ? number(times, key) : 0;
    }

    private static double number(Report report, String key) {
        return report.values().get(key) instanceof Number value ? value.doubleValue() : 0;
    }

    private void add(EncounterBatch.Row row, Report report) {
        Sums all = sums.computeIfAbsent(row.method(), key -> new Sums());
        all.count++;
        double collisions = number(report, "collisions");
        all.collisions += collisions;
        all.struck += collisions > 0 ? 1 : 0;
        all.risk += number(report, "mean_risk");
        if (report.values().get("smallest_distance") instanceof Double smallest) {
            all.smallest = Math.min(all.smallest, smallest);
        }
        if (row.run().outcome().isFound()) {
            all.arrivals++;
            all.detour += number(report, "detour");
            all.share += number(report, "arrival") / row.of().recorded();
        }
        all.medians.add(time(report, "step_median"));
        all.firsts.add(time(report, "first_plan"));
    }

    /** Returns the table of sums, a line for each method. */
    public List<String> summary() {
        List<String> lines = new ArrayList<>();
        lines.add(String.format(
                "%-8s %10s %10s %8s %8s %8s %9s %8s %9s %9s",
                "method",
                "encounters",
                "collisions",
                "struck",
                "arrivals",
                "detour",
                "mean risk",
                "nearest",
                "step ms",
                "first ms"));
        sums.forEach((method, s) -> lines.add(String.format(
                Locale.ROOT,
                "%-8s %10d %10.0f %8d %8d %8.4f %9.4f %8.3f %9.3f %9.3f%s",
                word(method),
                s.count,
                s.collisions,
                s.struck,
                s.arrivals,
                s.detour / Math.max(1, s.arrivals),
                s.risk / s.count,
                s.smallest,
                median(s.medians),
                median(s.firsts),
                Double.isNaN(s.share)
                        ? ""
                        : String.format(
                                Locale.ROOT,
                                "   arrival %.3f times that of the walkers",
                                s.share / Math.max(1, s.arrivals)))));
        return lines;
    }

    private static double median(List<Double> values) {
        List<Double> sorted = values.stream().sorted().toList();
        return sorted.get(sorted.size() / 2);
    }
}
