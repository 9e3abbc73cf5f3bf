package troupe.cli;

import java.util.List;

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
                Runtime.getRuntime().halt(CommandLine.FAULT);
            });
            code = line.run(List.of(arguments), terminal);
        }
        if (code != CommandLine.OK) {
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
