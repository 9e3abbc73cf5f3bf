package troupe.app.compare;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import troupe.run.Report;

/** Sets two reports side by side: a row for each value that one of them has, nested names with dots. Pure. */
final class ReportTable {
    private ReportTable() {}

    /**
     * One row.
     *
     * @param shown the value of the run that is shown, {@code kept} that of the one kept; empty where it has none
     * @param change how they differ: a signed difference of numbers, an unequal sign for others, empty if they are
     *     equal or hold wall time
     */
    record Row(String name, String shown, String kept, String change) {
        boolean differs() {
            return !change.isEmpty();
        }
    }

    /** Returns the rows, in the order of the report that is shown, then what only the other has. */
    static List<Row> rows(Report shown, Report kept) {
        Map<String, Object> left = new LinkedHashMap<>();
        Map<String, Object> right = new LinkedHashMap<>();
        flatten("", shown, left);
        flatten("", kept, right);
        List<String> names = new ArrayList<>(left.keySet());
        right.keySet().stream().filter(name -> !left.containsKey(name)).forEach(names::add);
        List<Row> rows = new ArrayList<>();
        for (String name : names) {
            Object a = left.get(name);
            Object b = right.get(name);
            rows.add(new Row(name, word(a), word(b), name.endsWith("_ms") ? "" : change(a, b)));
        }
        return rows;
    }

    private static void flatten(String prefix, Report report, Map<String, Object> into) {
        report.values().forEach((name, value) -> {
            if (value instanceof Report nested) {
                flatten(prefix + name + ".", nested, into);
            } else if (value instanceof List<?> list && list.stream().anyMatch(Report.class::isInstance)) {
                for (int i = 0; i < list.size(); i++) {
                    if (list.get(i) instanceof Report nested) {
                        flatten(prefix + name + "." + (i + 1) + ".", nested, into);
                    }
                }
            } else {
                into.put(prefix + name, value);
            }
        });
    }

    private static String change(Object shown, Object kept) {
        if (Objects.equals(shown, kept)) {
            return "";
        }
        if (shown instanceof Number a && kept instanceof Number b) {
            double difference = a.doubleValue() - b.doubleValue();
            String number = number(Math.abs(difference));
            return (difference < 0 ? "\u2212" : "+") + number;
        }
        return "\u2260";
    }

    private static String word(Object value) {
        return value == null ? "" : value instanceof Double d ? number(d) : String.valueOf(value);
    }

    private static String number(double value) {
        if (value == Math.rint(value) && Math.abs(value) < 1e9) {
            return String.format(Locale.ROOT, "%.0f", value);
        }
        double size = Math.abs(value);
        String format = size >= 100 ? "%.1f" : size >= 0.01 ? "%.3f" : "%.2e";
        return String.format(Locale.ROOT, format, value);
    }
}
