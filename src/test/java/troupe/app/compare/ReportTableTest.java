package troupe.app.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import troupe.run.Report;

class ReportTableTest {
    @Test
    void marksWhatDiffersAndLeavesOutWallTime() {
        Report shown = Report.builder()
                .put("energy", 25.25)
                .put("solved", true)
                .put("plan_ms", 3.0)
                .put("search", Report.builder().put("labels", 12).build())
                .put("moved", List.of(Report.builder().put("id", "crate").build()))
                .build();
        Report kept = Report.builder()
                .put("energy", 42.75)
                .put("solved", true)
                .put("plan_ms", 9.0)
                .put("search", Report.builder().put("labels", 10).build())
                .put("vaults", 1)
                .build();
        assertEquals(
                List.of(
                        new ReportTable.Row("energy", "25.250", "42.750", "\u221217.500"),
                        new ReportTable.Row("solved", "true", "true", ""),
                        new ReportTable.Row("plan_ms", "3", "9", ""),
                        new ReportTable.Row("search.labels", "12", "10", "+2"),
                        new ReportTable.Row("moved.1.id", "crate", "", "\u2260"),
                        new ReportTable.Row("vaults", "", "1", "\u2260")),
                ReportTable.rows(shown, kept));
    }
}
