package troupe.cli;

import java.util.List;
import troupe.cli.command.BatchCommand;
import troupe.cli.command.CheckCommand;
import troupe.cli.command.DefaultCommand;
import troupe.cli.command.ExplainCommand;
import troupe.cli.command.ExportCommand;
import troupe.cli.command.FieldsCommand;
import troupe.cli.command.FitCommand;
import troupe.cli.command.ImportCommand;
import troupe.cli.command.OpenCommand;
import troupe.cli.command.RecordCommand;
import troupe.cli.command.ReplayCommand;
import troupe.cli.command.RunCommand;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Interruption;
import troupe.cli.terminal.Terminal;

/** Starts the program. */
public final class Troupe {
    private Troupe() {}

    /** Runs a command; see {@code --help}. The process ends with the command's exit code. */
    public static void main(String[] arguments) {
        boolean opens = arguments.length == 0 || arguments[0].equals("open");
        if (!opens && System.getProperty("java.awt.headless") == null) {
            System.setProperty("java.awt.headless", "true");
        }
        int code;
        try (Interruption interruption = new Interruption()) {
            CommandLine line = new CommandLine(all(), new DefaultCommand(OpenCommand::window));
            Terminal terminal = Terminal.system(interruption);
            Thread.currentThread().setUncaughtExceptionHandler((thread, fault) -> {
                terminal.say(CommandLine.describe(fault));
                Runtime.getRuntime().halt(ExitCode.FAULT);
            });
            code = line.run(List.of(arguments), terminal);
        }
        if (code != ExitCode.OK) {
            System.exit(code);
        }
    }

    /** Returns all commands, in the order of the help. */
    static List<Command> all() {
        return List.of(
                new OpenCommand(),
                new CheckCommand(),
                new RunCommand(),
                new ExplainCommand(),
                new FieldsCommand(),
                new ReplayCommand(),
                new ExportCommand(),
                new ImportCommand(),
                new BatchCommand(),
                new FitCommand(),
                new RecordCommand());
    }
}
