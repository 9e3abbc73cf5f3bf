package troupe.cli;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.List;
import troupe.exchange.ExchangeException;
import troupe.run.RunException;
import troupe.run.RunFile;
import troupe.scene.SceneException;

/** Finds the command that was typed, runs it, and turns what goes wrong into one line and an exit code. */
final class CommandLine {
    /** Exit codes. */
    static final int OK = 0;

    static final int FAILED = 1;
    static final int BAD_USE = 2;
    static final int BAD_INPUT = 3;
    static final int FAULT = 4;

    /** What a shell gives a process that Ctrl-C ended. */
    static final int INTERRUPTED = 130;

    private final List<Command> commands;
    private final Command standard;

    /** Makes a command line; {@code standard} runs when nothing is typed. */
    CommandLine(List<Command> commands, Command standard) {
        this.commands = List.copyOf(commands);
        this.standard = standard;
    }

    /** Runs what was typed and returns the exit code. */
    int run(List<String> typed, Terminal terminal) {
        int code = typed(typed, terminal);
        if (terminal.out().checkError() && code != BAD_USE) {
            terminal.say("standard output cannot be written; what was to go there is lost");
            return BAD_INPUT;
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
                return OK;
            }
            if (List.of("--version", "-V").contains(word)) {
                terminal.out().println("Troupe " + RunFile.program());
                return OK;
            }
            return run(find(word), typed.subList(1, typed.size()), terminal);
        } catch (UsageException e) {
            terminal.say(e.getMessage());
            terminal.say("see --help");
            return BAD_USE;
        } catch (SceneException | RunException | ExchangeException e) {
            terminal.say(e.getMessage());
            return BAD_INPUT;
        } catch (InterruptedIOException e) {
            terminal.say(e.getMessage());
            return INTERRUPTED;
        } catch (IOException e) {
            terminal.say(line(e));
            return BAD_INPUT;
        }
    }

    private int run(Command command, List<String> typed, Terminal terminal)
            throws UsageException, SceneException, RunException, ExchangeException, IOException {
        int end = typed.indexOf("--");
        List<String> options = end < 0 ? typed : typed.subList(0, end);
        if (options.contains("--help") || options.contains("-h")) {
            Help.one(command, terminal.out());
            return OK;
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
    static String describe(Throwable fault) {
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
