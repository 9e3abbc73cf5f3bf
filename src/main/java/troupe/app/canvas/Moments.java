package troupe.app.canvas;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import troupe.app.look.Look;
import troupe.app.plan.Plan;
import troupe.app.session.RunViews;
import troupe.app.session.Session;
import troupe.paint.field.OverlayPainter;
import troupe.run.Run;
import troupe.scene.Task;
import troupe.work.view.MomentViews;

/**
 * Makes the views of a simulation at the moment shown on a background thread: playing asks for them with each frame,
 * and the newest request wins, so that nobody waits. Belongs to the event thread but for its work.
 */
final class Moments implements AutoCloseable {
    private final Look look;
    private final Executor eventThread;
    private final Consumer<List<OverlayPainter>> taker;
    private final AtomicReference<Request> newest = new AtomicReference<>();
    /** Made by the worker, the only one that uses it. */
    private MomentViews views;

    private final ExecutorService worker = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "moments");
        thread.setDaemon(true);
        return thread;
    });
    private Optional<Request> last = Optional.empty();

    private record Request(Run run, int frame, Set<String> keys, double aheadSeconds) {}

    /** Makes a maker for a look; {@code taker} gets the painters on the event thread, none where none is wanted. */
    Moments(Look look, Executor eventThread, Consumer<List<OverlayPainter>> taker) {
        this.look = look;
        this.eventThread = eventThread;
        this.taker = taker;
    }

    /** Asks for what is shown of the newest plan of a session at the moment shown, unless that was asked for last. */
    void request(Session session) {
        Optional<Request> wanted = session.plan().flatMap(plan -> request(session, plan));
        if (wanted.equals(last)) {
            return;
        }
        last = wanted;
        if (wanted.isEmpty()) {
            newest.set(null);
            taker.accept(List.of());
        } else if (newest.getAndSet(wanted.get()) == null) {
            worker.execute(this::make);
        }
    }

    private static Optional<Request> request(Session session, Plan plan) {
        Set<String> keys = RunViews.keys(plan).stream()
                .filter(key -> RunViews.isOfMoment(key) && session.overlays().shows(key))
                .collect(Collectors.toUnmodifiableSet());
        Task task = RunViews.task(plan).orElse(null);
        double ahead = RunViews.aheadSeconds(task, session.overlays());
        return plan.run()
                .filter(run -> !keys.isEmpty() && run.frames().count() > 0)
                .map(run -> {
                    double frame =
                            Math.floor(session.playback().time() * run.frames().rate() + 1e-6);
                    return new Request(run, (int) Math.min(frame, run.frames().count() - 1.0), keys, ahead);
                });
    }

    private void make() {
        if (views == null) {
            views = new MomentViews();
        }
        Request request = newest.get();
        while (request != null) {
            double time = request.frame() / request.run().frames().rate();
            List<OverlayPainter> made = views.at(request.run(), time, request.keys(), request.aheadSeconds()).stream()
                    .map(overlay -> new OverlayPainter(overlay, look.theme()))
                    .toList();
            Request done = request;
            eventThread.execute(() -> {
                if (last.filter(r -> r.keys().equals(done.keys())).isPresent()) {
                    taker.accept(made);
                }
            });
            request = newest.compareAndSet(done, null) ? null : newest.get();
        }
    }

    @Override
    public void close() {
        last = Optional.empty();
        newest.set(null);
        worker.shutdown();
    }
}
