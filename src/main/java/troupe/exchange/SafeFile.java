package troupe.exchange;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import troupe.run.AtomicFile;

/** Writes a file whole or not at all, and lets an {@link ExchangeException} through. */
final class SafeFile {
    private SafeFile() {}

    /** Writes the content of a file. */
    interface Content {
        void write(OutputStream out) throws IOException, ExchangeException;
    }

    /** Carries the refusal of a format through a writer that knows input and output errors alone. */
    private static final class Refusal extends IOException {
        private final ExchangeException reason;

        private Refusal(ExchangeException reason) {
            super(reason);
            this.reason = reason;
        }
    }

    /** Writes or replaces {@code target}; if anything fails, what was there is still there. */
    static void write(Path target, Content content) throws IOException, ExchangeException {
        try {
            AtomicFile.write(target, out -> {
                try {
                    content.write(out);
                } catch (ExchangeException e) {
                    throw new Refusal(e);
                }
            });
        } catch (Refusal refusal) {
            throw refusal.reason;
        }
    }
}
