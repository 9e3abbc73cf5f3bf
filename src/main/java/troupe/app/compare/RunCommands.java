package troupe.app.compare;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.filechooser.FileNameExtensionFilter;
import troupe.app.command.Command;
import troupe.app.command.Commands;
import troupe.app.look.Failures;
import troupe.app.look.Look;
import troupe.app.look.widget.Question;
import troupe.app.session.Notice;
import troupe.app.session.Session;
import troupe.run.Run;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;

/** Adds the commands for saved runs and for comparing: open, save, keep, compare with a file, stop comparing. */
public final class RunCommands implements AutoCloseable {
    private final JFrame frame;
    private final Session session;
    private final Look look;
    private final Executor eventThread;
    private final ExecutorService background = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "runs");
        thread.setDaemon(true);
        return thread;
    });
    private final List<Runnable> leave = new ArrayList<>();
    private Optional<CompareDialog> dialog = Optional.empty();

    /** Makes the commands of a session. */
    public RunCommands(JFrame frame, Session session, Look look, Executor eventThread) {
        this.frame = frame;
        this.session = session;
        this.look = look;
        this.eventThread = eventThread;
    }

    /**
     * Adds the commands to the menu of runs.
     *
     * @param opening does something that gives up the document, if the person agrees
     */
    public void add(Commands commands, Consumer<Runnable> opening) {
        commands.add("run", "openrun", () -> opening.accept(() -> ask(true).ifPresent(this::open)));
        Command save = commands.add("run", "saverun", this::save);
        commands.separate();
        Command keep = commands.add("run", "keep", this::keep);
        commands.add("run", "comparewith", () -> ask(true).ifPresent(this::compareWith));
        Command table = commands.add("run", "compare", this::showTable);
        Command drop = commands.add("run", "nocompare", session.comparison()::drop);
        Runnable refresh = () -> {
            boolean run = session.run().isPresent();
            boolean kept = session.comparison().kept().isPresent();
            save.setEnabled(run);
            keep.setEnabled(run);
            table.setEnabled(kept);
            drop.setEnabled(kept);
        };
        leave.add(session.plans().add(plan -> refresh.run()));
        leave.add(session.comparison().listeners().add(c -> refresh.run()));
        refresh.run();
    }

    private Optional<Path> ask(boolean reading) {
        JFileChooser chooser = new JFileChooser();
        chooser.setFileFilter(new FileNameExtensionFilter(look.text("file.runs"), "run"));
        Path folder = session.document()
                .file()
                .map(f -> f.toAbsolutePath().getParent())
                .orElse(Path.of("").toAbsolutePath());
        chooser.setCurrentDirectory(folder.toFile());
        if (!reading) {
            session.run()
                    .ifPresent(run -> chooser.setSelectedFile(
                            folder.resolve(run.task() + ".run").toFile()));
        }
        int answer = reading ? chooser.showOpenDialog(frame) : chooser.showSaveDialog(frame);
        return answer == JFileChooser.APPROVE_OPTION
                ? Optional.of(chooser.getSelectedFile().toPath())
                : Optional.empty();
    }

    /** Opens a saved run to be played; nothing is planned until it is asked for. */
    public void open(Path file) {
        read(file, session::show);
    }

    /** Keeps the run of a file for comparison and shows the table. */
    public void compareWith(Path file) {
        read(file, run -> {
            session.comparison().keep(file.getFileName().toString(), run);
            showTable();
        });
    }

    private void read(Path file, Consumer<Run> taker) {
        background.execute(() -> {
            try {
                Run run = RunFile.read(file);
                eventThread.execute(() -> taker.accept(run));
            } catch (RunException | IOException e) {
                tell(file, e);
            }
        });
    }

    private void tell(Path file, Exception e) {
        String text = Failures.line(file, e);
        eventThread.execute(() -> session.notices().tell(new Notice(true, text)));
    }

    private void save() {
        Run run = session.run().orElse(null);
        Optional<Path> chosen = run == null ? Optional.empty() : ask(false);
        chosen.map(f -> f.toString().endsWith(".run") ? f : f.resolveSibling(f.getFileName() + ".run"))
                .filter(file -> !Files.exists(file)
                        || new Question(look, "replace")
                                .ask(
                                        frame,
                                        look.texts().format("replace", file.getFileName()),
                                        List.of("yes", "cancel"))
                                .equals(Optional.of("yes")))
                .ifPresent(file -> write(run, file));
    }

    private void write(Run run, Path file) {
        background.execute(() -> {
            try {
                RunFile.write(run, file);
                String text = look.texts().format("export.done", file.getFileName());
                eventThread.execute(() -> session.notices().tell(new Notice(false, text)));
            } catch (IOException e) {
                tell(file, e);
            }
        });
    }

    private void keep() {
        session.run().ifPresent(run -> {
            String task = run.scene().task(run.task()).map(t -> t.name()).orElse(run.task());
            session.comparison().keep(task, run);
        });
    }

    private void showTable() {
        dialog.ifPresent(CompareDialog::close);
        CompareDialog made = new CompareDialog(frame, look, session);
        dialog = Optional.of(made);
        made.show();
    }

    @Override
    public void close() {
        leave.forEach(Runnable::run);
        dialog.ifPresent(CompareDialog::close);
        background.shutdown();
    }
}
