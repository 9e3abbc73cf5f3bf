package troupe.cli.command;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;
import troupe.cli.terminal.Terminal;
import troupe.run.Engine;
import troupe.run.Simulation;
import troupe.run.file.RunJournal;

/** Keeps what a simulation has made so far in a journal beside the run's file; other engines make their run at once. */
final class Journalling implements Consumer<Engine>, Closeable {
    private final Path target;
    private final Terminal terminal;
    private final RunJournal journal;
    private boolean failed;

    /** Prepares a journal beside the file of a run, and tells of one that is there already. */
    Journalling(Path target, Terminal terminal) {
        this.target = target;
        this.terminal = terminal;
        this.journal = new RunJournal(target);
        // a device has nothing beside it
        this.failed = Files.exists(target) && !Files.isRegularFile(target);
        if (!failed) {
            RunJournal.beside(target)
                    .forEach(left -> terminal.say(left.getFileName()
                            + " is there, of a run that was cut off or is still at work; troupe replay opens it"));
        }
    }

    @Override
    public void accept(Engine engine) {
        if (failed || !(engine instanceof Simulation simulation)) {
            return;
        }
        try {
            journal.keep(simulation);
        } catch (IOException e) {
            failed = true;
            terminal.say("no journal is kept beside " + target.getFileName() + ": " + e.getMessage());
        }
    }

    /** Removes the journal, once the run is in its place. */
    void discard() throws IOException {
        journal.discard();
    }

    /** Leaves the journal there. */
    @Override
    public void close() throws IOException {
        journal.close();
    }
}
