package troupe.scene;

import java.util.Locale;

/** Names what an actor can do, in the order of documents, legends and bit masks. */
public enum Ability {
    WALK,
    SIDESTEP,
    STRIDE,
    VAULT,
    MOVE;

    /** Returns the word for it in files, settings and reports: {@code walk}, {@code sidestep}, … */
    public String key() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Returns {@code 1 << ordinal()}, the bit of this ability in a mask. */
    public int bit() {
        return 1 << ordinal();
    }
}
