package troupe.app.recovery;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import troupe.app.document.EventThread;
import troupe.app.document.SceneDocument;
import troupe.app.plan.Live;
import troupe.app.plan.Plan;
import troupe.app.plan.Snapshot;
import troupe.app.session.Session;
import troupe.run.Run;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;
import troupe.run.file.RunJournal;

/**
 * Keeps what a session simulates in a journal of the person's, at most a second old, for as long as it is shown and not
 * given up: so what a person has steered outlives the studio. Short simulations are not kept, and none beyond
 * {@link #MOST_BYTES}. Belongs to the event thread; writes on a thread of its own, which the program waits for when it
 * ends.
 */
final class RunKeeping implements AutoCloseable {
    /** How long in ms a simulation works before it is kept: a shorter one is made again sooner than it is read. */
    static final long BEGIN_MS = 1_000;

    /** How large in bytes a journal becomes at most; of a longer simulation the beginning is kept. */
    static final long MOST_BYTES = 1L << 29;

    /** Journals of earlier processes beyond so many are removed, the oldest first. */
    static final int MOST_LEFT = 3;

    private static final long PERIOD_MS = 300;

    private final Session session;
    private final KeptFiles kept;
    private final Executor eventThread;
    private final Consumer<IOException> failed;
    private final long beginMs;
    private final AtomicReference<Plan> newest = new AtomicReference<>();
    private final ScheduledExecutorService background =
            Executors.newSingleThreadScheduledExecutor(task -> new Thread(task, "journal"));
    private final List<Runnable> leave = new ArrayList<>();
    /** What the journal is of; also read by the event thread. */
    private volatile Snapshot current;

    private RunJournal journal;
    private List<Run.Input> inputs = List.of();
    private boolean full;
    private final List<Path> taken = new ArrayList<>();

    /** Keeps what a session simulates from now on; {@code failed} is told, on the background thread, what cannot be kept. */
    RunKeeping(Session session, KeptFiles kept, Executor eventThread, Consumer<IOException> failed) {
        this(session, kept, eventThread, failed, BEGIN_MS);
    }

    /** Keeps simulations that have worked for {@code beginMs}. */
    RunKeeping(Session session, KeptFiles kept, Executor eventThread, Consumer<IOException> failed, long beginMs) {
        EventThread.require();
        this.session = session;
        this.kept = kept;
        this.eventThread = eventThread;
        this.failed = failed;
        this.beginMs = beginMs;
        leave.add(session.plans().add(this::take));
        leave.add(session.document().listeners().add(change -> {
            if (change == SceneDocument.Change.OPENED) {
                forget();
            }
        }));
    }

    private void take(Plan plan) {
        boolean simulated = !plan.live().equals(Live.NONE) && plan.run().isPresent();
        if (!simulated || plan.snapshot().version().preview() != 0) {
            forget();
            return;
        }
        boolean begun = current == plan.snapshot();
        if (!begun && current != null) {
            forget();
        }
        if ((begun || plan.millis() >= beginMs) && newest.getAndSet(plan) == null) {
            background.schedule(this::keep, PERIOD_MS, TimeUnit.MILLISECONDS);
        }
    }

    private void keep() {
        Plan plan = newest.getAndSet(null);
        if (plan == null) {
            return;
        }
        Run run = plan.run().orElseThrow();
        try {
            if (current != plan.snapshot() || diverges(run)) {
                discard();
                Files.createDirectories(kept.folder());
                journal = new RunJournal(kept.run());
                current = plan.snapshot();
                full = false;
            }
            full |= journal.bytes() > MOST_BYTES;
            if (!full) {
                journal.keep(run);
                inputs = run.inputs();
            }
        } catch (IOException e) {
            full = true;
            failed.accept(e);
        }
    }

    /** Tells whether a run is not that of the journal gone on: whoever steers takes back what came after the moment shown. */
    private boolean diverges(Run run) {
        int known = inputs.size();
        List<Run.Input> now = run.inputs();
        return now.size() < known
                || !now.subList(0, known).equals(inputs)
                || now.size() > known && now.get(known).step() < journal.frames();
    }

    private void forget() {
        newest.set(null);
        if (current != null) {
            current = null;
            background.execute(() -> {
                try {
                    discard();
                } catch (IOException e) {
                    failed.accept(e);
                }
            });
        }
    }

    private void discard() throws IOException {
        if (journal != null) {
            journal.discard();
            journal = null;
        }
        inputs = List.of();
    }

    /**
     * Returns the newest simulation that was left behind, and removes what is too old or holds nothing; to be called in
     * the background.
     *
     * @throws IOException if the folder cannot be listed or changed
     */
    Optional<Recovery.RunOffer> left() throws IOException {
        Optional<Recovery.RunOffer> found = Optional.empty();
        int count = 0;
        for (KeptFiles.Left left : kept.leftRuns()) {
            try {
                Run run = RunFile.read(left.kept());
                if (run.frames().count() > 0 && count++ < MOST_LEFT) {
                    found = found.or(() -> Optional.of(new Recovery.RunOffer(left, run)));
                    continue;
                }
            } catch (RunException e) {
                // cut off before its first frame: there is nothing in it
            }
            Files.deleteIfExists(left.kept());
        }
        return found;
    }

    /** Shows a simulation that was left behind, which is this process's from then on; then tells {@code shown}. */
    void bringBack(Path left, Runnable shown) {
        EventThread.require();
        background.execute(() -> {
            try {
                Path mine = free();
                Files.move(left, mine);
                taken.add(mine);
                Run run = RunFile.read(mine);
                eventThread.execute(() -> {
                    session.show(run);
                    shown.run();
                });
            } catch (RunException e) {
                failed.accept(new IOException(e.getMessage(), e));
            } catch (IOException e) {
                failed.accept(e);
            }
        });
    }

    private Path free() {
        Path file = RunJournal.file(kept.run(), RunJournal.MOST - 1);
        for (int k = RunJournal.MOST - 1; k > 0 && Files.exists(file); k--) {
            file = RunJournal.file(kept.run(), k - 1);
        }
        return file;
    }

    /** Removes a simulation that was left behind. */
    void remove(Path left) {
        background.execute(() -> {
            try {
                Files.deleteIfExists(left);
            } catch (IOException e) {
                failed.accept(e);
            }
        });
    }

    /** Ends, as what is shown is given up on purpose: nothing is kept of it. Closing again does nothing. */
    @Override
    public void close() {
        if (background.isShutdown()) {
            return;
        }
        leave.forEach(Runnable::run);
        newest.set(null);
        background.execute(() -> {
            try {
                discard();
                for (Path file : taken) {
                    Files.deleteIfExists(file);
                }
            } catch (IOException e) {
                failed.accept(e);
            }
        });
        background.shutdown();
    }
}
