package troupe.cli.terminal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.cli.command.RunCommand;

class ArgumentsTest {
    private final Command command = new RunCommand();

    @Test
    void sortsOptionsAndWordsInAnyOrder() throws UsageException {
        Arguments a = parse("--set", "a=1", "x.xml", "--set=b=2", "--json", "-o", "-");
        assertEquals("x.xml", a.only("SCENE"));
        assertEquals(List.of("a=1", "b=2"), a.all("--set"));
        assertTrue(a.has("--json"));
        assertFalse(a.has("--quiet"));
        assertEquals(Optional.of("-"), a.value("-o"));
    }

    @Test
    void takesLonelyDashAndWhatFollowsTwoDashesAsWords() throws UsageException {
        assertEquals("-", parse("-").only("SCENE"));
        assertEquals("--json", parse("--", "--json").only("SCENE"));
    }

    @Test
    void refusesWhatItDoesNotKnow() {
        UsageException e = assertThrows(UsageException.class, () -> parse("--frobnicate"));
        assertTrue(e.getMessage().startsWith("unknown option --frobnicate; run knows --task, --set"), e.getMessage());
        assertThrows(UsageException.class, () -> parse("-x"));
        assertThrows(UsageException.class, () -> parse("--json=yes"));
        assertThrows(UsageException.class, () -> parse("--task"));
        assertThrows(UsageException.class, () -> parse("--task", "a", "--task", "b"));
        assertThrows(UsageException.class, () -> parse("a", "b").only("SCENE"));
        assertThrows(UsageException.class, () -> parse().only("SCENE"));
    }

    @Test
    void readsNumbersWithinTheirRange() throws UsageException {
        assertEquals(Optional.of(7L), parse("--seed", "7").whole("--seed", 1, 9));
        assertEquals(Optional.empty(), parse().whole("--seed", 1, 9));
        for (String bad : List.of("10", "0", "x", "1.5", "99999999999999999999")) {
            Arguments a = parse("--seed", bad);
            assertThrows(UsageException.class, () -> a.whole("--seed", 1, 9));
        }
        assertEquals(Optional.of(-0.5), parse("--seed", "-0.5").number("--seed"));
        for (String bad : List.of("NaN", "Infinity", "x", "1e999")) {
            Arguments a = parse("--seed", bad);
            assertThrows(UsageException.class, () -> a.number("--seed"));
        }
    }

    private Arguments parse(String... typed) throws UsageException {
        return Arguments.parse(command, List.of(typed));
    }
}
