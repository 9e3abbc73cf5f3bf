package troupe.cli;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.List;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.exchange.format.ExchangeException;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;
import troupe.scene.xml.SceneException;

/** Finds the command that was typed, runs it, and turns what goes wrong into one line and an exit code. */
public final class CommandLine {
    private final List<Command> commands;
    private final Command standard;

    /** Makes a command line; {@code standard} runs when nothing is typed. */
    public CommandLine(List<Command> commands, Command standard) {
        this.commands = List.copyOf(commands);
        this.standard = standard;
    }

    /** Runs what was typed and returns the exit code. */
    public int run(List<String> typed, Terminal terminal) {
        int code = typed(typed, terminal);
        if (terminal.out().checkError() && code != ExitCode.BAD_USE) {
            terminal.say("standard output cannot be written; what was to go there is lost");
            return ExitCode.BAD_INPUT;
        }
        return code;
    }

    private int typed(List<String> typed, Terminal terminal) {
        try {
            if (typed.isEmpty()) {
                return standard.run(Arguments.parse(standard, List.of()), terminal);
            }
            String word = typed.get(0);
            if (List.of("help", "--help", "-h").contains(word)) {
                Help.all(commands, terminal.out());
                return ExitCode.OK;
            }
            if (List.of("--version", "-V").contains(word)) {
                terminal.out().println("Troupe " + RunFile.program());
                return ExitCode.OK;
            }
            return run(find(word), typed.subList(1, typed.size()), terminal);
        } catch (UsageException e) {
            terminal.say(e.getMessage());
            terminal.say("see --help");
            return ExitCode.BAD_USE;
        } catch (SceneException | RunException | ExchangeException e) {
            terminal.say(e.getMessage());
            return ExitCode.BAD_INPUT;
        } catch (InterruptedIOException e) {
            terminal.say(e.getMessage());
            return ExitCode.INTERRUPTED;
        } catch (IOException e) {
            terminal.say(line(e));
            return ExitCode.BAD_INPUT;
        }
    }

    private int run(Command command, List<String> typed, Terminal terminal)
            throws UsageException, SceneException, RunException, ExchangeException, IOException {
        int end = typed.indexOf("--");
        List<String> options = end < 0 ? typed : typed.subList(0, end);
        if (options.contains("--help") || options.contains("-h")) {
            Help.one(command, terminal.out());
            return ExitCode.OK;
        }
        return command.run(Arguments.parse(command, typed), terminal);
    }

    private Command find(String word) throws UsageException {
        for (Command command : commands) {
            if (command.name().equals(word)) {
                return command;
            }
        }
        throw new UsageException("unknown command '" + word + "'; there are "
                + String.join(", ", commands.stream().map(Command::name).toList()));
    }

    /** Says in a few words what went wrong inside the program, and where. */
    public static String describe(Throwable fault) {
        StackTraceElement[] trace = fault.getStackTrace();
        String where = trace.length == 0 ? "" : " at " + trace[0];
        if (fault instanceof OutOfMemoryError) {
            return "out of memory" + where + "; choose a larger cell, or give Java more with -Xmx";
        }
        return "fault of the program: " + fault + where + "; please report it with the scene";
    }

    private static String line(IOException e) {
        if (e instanceof NoSuchFileException missing) {
            return "there is no file " + missing.getFile();
        }
        if (e instanceof AccessDeniedException denied) {
            return "no right to open " + denied.getFile();
        }
        if (e instanceof FileSystemException file && file.getReason() != null) {
            return file.getFile() + ": " + file.getReason();
        }
        return String.valueOf(e.getMessage());
    }
}
