package troupe.app;

import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/** Looks at the stack of the event thread every few milliseconds for code that has no business there. */
final class EventThreadWatch implements AutoCloseable {
    private static final Set<String> PACKAGES = Set.of("grid", "unified", "search", "work", "risk", "crowd");
    private static final Set<String> CLASSES = Set.of(
            "troupe.scene.xml.SceneXml",
            "troupe.scene.xml.SceneReader",
            "troupe.scene.xml.SceneWriter",
            "troupe.scene.check.SceneChecks");
    private static final Set<String> HARMLESS = Set.of(
            "troupe.grid.GridFrame",
            "troupe.search.Outcome",
            "troupe.work.inspect.Blockage",
            "troupe.work.explain.Explanation",
            "troupe.work.explain.Flip",
            "troupe.work.explain.Route");

    private final Thread watched = OnEventThread.get(Thread::currentThread);
    private final Thread watch = new Thread(this::look, "watch");
    private volatile boolean done;
    private volatile String found;

    EventThreadWatch() {
        watch.setDaemon(true);
        watch.start();
    }

    private void look() {
        while (!done && found == null) {
            for (StackTraceElement frame : watched.getStackTrace()) {
                if (isForeign(frame.getClassName())) {
                    found = frame.toString();
                }
            }
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(3));
        }
    }

    private static boolean isForeign(String name) {
        String outer = name.contains("$") ? name.substring(0, name.indexOf('$')) : name;
        String[] words = outer.split("\\.");
        boolean below = words.length > 2 && words[0].equals("troupe") && PACKAGES.contains(words[1]);
        return !HARMLESS.contains(outer) && (CLASSES.contains(outer) || below);
    }

    /** Returns the first frame that was seen and should not have been. */
    Optional<String> found() {
        return Optional.ofNullable(found);
    }

    @Override
    public void close() {
        done = true;
    }
}
