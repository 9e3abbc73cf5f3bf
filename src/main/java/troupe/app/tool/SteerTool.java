package troupe.app.tool;

import java.awt.Cursor;
import java.util.Optional;
import java.util.function.Supplier;
import troupe.app.session.Session;
import troupe.paint.Viewport;
import troupe.run.Run;
import troupe.run.frame.Frames;
import troupe.scene.Avatar;
import troupe.scene.Encounter;

/**
 * Steers an avatar by hand while an encounter is simulated: pressed on, it follows the pointer until it is let go,
 * and the actor gives way to it as it happens. Only avatars that a pointer moves can be steered.
 */
public final class SteerTool implements Tool {
    private static final double LEAST_PIXELS = 9;

    private final Session session;
    private final Supplier<Viewport> view;
    private Optional<String> held = Optional.empty();

    /** Makes the tool. */
    public SteerTool(Session session, Supplier<Viewport> view) {
        this.session = session;
        this.view = view;
    }

    @Override
    public String key() {
        return "steer";
    }

    /** Tells whether a press here would take hold of an avatar. */
    public boolean takes(Pointer pointer) {
        return under(pointer).isPresent();
    }

    private Optional<String> under(Pointer pointer) {
        Optional<Run> run = session.run();
        if (run.isEmpty() || !(run.get().scene().task(run.get().task()).orElse(null) instanceof Encounter encounter)) {
            return Optional.empty();
        }
        return encounter.avatars().stream()
                .filter(avatar -> avatar.motion() instanceof Avatar.Pointer)
                .filter(avatar -> isUnder(pointer, avatar, run.get().frames()))
                .map(Avatar::id)
                .findFirst();
    }

    private boolean isUnder(Pointer pointer, Avatar avatar, Frames frames) {
        int x = frames.channel(avatar.id(), "x");
        int y = frames.channel(avatar.id(), "y");
        if (x < 0 || y < 0 || frames.count() == 0) {
            return false;
        }
        int frame = (int)
                Math.min(frames.count() - 1L, Math.round(session.playback().time() * frames.rate()));
        double away = pointer.at().distance(frames.value(frame, x, 0), frames.value(frame, y, 0));
        return away <= Math.max(avatar.radius(), LEAST_PIXELS / view.get().scale());
    }

    @Override
    public void press(Pointer pointer) {
        held = under(pointer);
        if (held.isPresent()) {
            session.playback().play();
            session.grab();
            drag(pointer);
        }
    }

    @Override
    public void drag(Pointer pointer) {
        held.ifPresent(id -> session.run().ifPresent(run -> {
            double width = run.scene().world().width();
            double depth = run.scene().world().depth();
            session.steer(
                    "avatar." + id + ".x",
                    Math.max(0, Math.min(width, pointer.at().x())));
            session.steer(
                    "avatar." + id + ".y",
                    Math.max(0, Math.min(depth, pointer.at().y())));
        }));
    }

    @Override
    public void release(Pointer pointer) {
        cancel();
    }

    @Override
    public void cancel() {
        if (held.isPresent()) {
            held = Optional.empty();
            session.release();
        }
    }

    @Override
    public Cursor cursor(Pointer pointer) {
        return Cursor.getPredefinedCursor(Cursor.HAND_CURSOR);
    }
}
