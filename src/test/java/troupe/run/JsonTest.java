package troupe.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;

class JsonTest {

    @Test
    void writesEveryKindOfValue() {
        Report report = Report.builder()
                .put("s", "x")
                .put("t", true)
                .put("n", 3)
                .put("d", 0.25)
                .put("l", List.of("a", 1L, List.of()))
                .put("r", Report.builder().put("k", false).build())
                .build();
        assertEquals(
                "{\"s\":\"x\",\"t\":true,\"n\":3,\"d\":0.25,\"l\":[\"a\",1,[]],\"r\":{\"k\":false}}", Json.of(report));
    }

    @Test
    void escapesWhatJsonCannotHold() {
        assertEquals("\"\\\"\\\\\\n\\t\\r\\u0001/庭😀\"", Json.of("\"\\\n\t\r\u0001/庭😀"));
        assertEquals("\"\\ud800\"", Json.of("\ud800"));
        assertEquals("\"\\udc00x\"", Json.of("\udc00x"));
    }

    @Test
    void refusesWhatAReportCannotHold() {
        assertThrows(IllegalArgumentException.class, () -> Json.of(Double.NaN));
        assertThrows(IllegalArgumentException.class, () -> Json.of(new Object()));
    }
}
