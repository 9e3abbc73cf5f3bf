package troupe.app.document;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;

/** Holds observers and tells each of them in the order in which they came; one may leave while it is told. */
public final class Listeners<T> {
    private final List<Consumer<? super T>> observers = new CopyOnWriteArrayList<>();

    /** Adds an observer and returns what removes it again. */
    public Runnable add(Consumer<? super T> observer) {
        observers.add(observer);
        return () -> observers.remove(observer);
    }

    /** Tells every observer. */
    public void tell(T event) {
        observers.forEach(observer -> observer.accept(event));
    }
}
