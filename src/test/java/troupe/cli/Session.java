package troupe.cli;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import troupe.cli.command.DefaultCommand;
import troupe.cli.terminal.Terminal;

/** Runs command lines in this process, with streams of its own. */
public final class Session {
    private final Path folder;
    private final CommandLine line = new CommandLine(Troupe.all(), new DefaultCommand(Optional::empty));

    /** What a command line left. */
    public record Result(int code, byte[] bytes, String err) {
        public String out() {
            return new String(bytes, StandardCharsets.UTF_8);
        }

        @Override
        public String toString() {
            return "exit code " + code + ", out '" + out() + "', err '" + err + "'";
        }
    }

    /** Makes a session in whose folder commands leave their files. */
    public Session(Path folder) {
        this.folder = folder;
    }

    public Result run(String... typed) {
        return run(new byte[0], false, typed);
    }

    public Result run(byte[] in, boolean interrupted, String... typed) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        return run(in, interrupted, out, out, typed);
    }

    /** Runs a command line whose results go to a stream of the test's own. */
    public Result run(OutputStream out, String... typed) {
        return run(new byte[0], false, out, new ByteArrayOutputStream(), typed);
    }

    private Result run(byte[] in, boolean interrupted, OutputStream out, ByteArrayOutputStream kept, String... typed) {
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        Terminal terminal = new Terminal(
                new ByteArrayInputStream(in),
                new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8),
                false,
                folder,
                () -> interrupted);
        int code = line.run(List.of(typed), terminal);
        return new Result(code, kept.toByteArray(), err.toString(StandardCharsets.UTF_8));
    }
}
