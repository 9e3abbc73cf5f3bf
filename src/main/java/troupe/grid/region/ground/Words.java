package troupe.grid.region.ground;

import java.util.Arrays;
import troupe.scene.Ability;

/**
 * Holds one word of 16 bits for each span of a region: what a search asks of it again and again. Words lie in
 * pages that regions share; a copy owns a page from the first word that it changes there. Belongs to one
 * thread while it is written; immutable afterwards.
 *
 * <table>
 *   <caption>Bits of a word</caption>
 *   <tr><td>0, 1</td><td>the bits of {@link Ability#WALK} and {@link Ability#SIDESTEP}, set where usable</td></tr>
 *   <tr><td>2, 3</td><td>the kind, see {@link #kind}</td></tr>
 *   <tr><td>4</td><td>{@link #SPECIAL}</td></tr>
 *   <tr><td>5</td><td>{@link #ELSEWHERE}</td></tr>
 *   <tr><td>8 to 15</td><td>directions of the legal steps on the same sheet</td></tr>
 * </table>
 */
public final class Words {
    /** The abilities that one can stand with. */
    public static final int STANDING = Ability.WALK.bit() | Ability.SIDESTEP.bit();

    /** Set where steps lead to a crossing or to another sheet. */
    public static final int SPECIAL = 1 << 4;

    /** Set where a step leads to another sheet. */
    public static final int ELSEWHERE = 1 << 5;

    /** The first of the eight bits of directions. */
    public static final int MOVES = 8;

    private static final int KIND = 2;
    private static final int KIND_MASK = 3;
    private static final int PAGE_BITS = 10;
    private static final int PAGE = 1 << PAGE_BITS;

    private final char[][] pages;
    private final boolean[] owned;

    private Words(char[][] pages, boolean all) {
        this.pages = pages;
        this.owned = new boolean[pages.length];
        Arrays.fill(owned, all);
    }

    /** Packs the abilities and kinds of spans; one without abilities is forbidden. Kinds of crossings do not fit. */
    public static Words of(byte[] abilities, byte[] kinds) {
        char[][] pages = new char[(kinds.length + PAGE - 1) >> PAGE_BITS][PAGE];
        for (int p = 0; p < pages.length; p++) {
            char[] page = pages[p];
            for (int q = p << PAGE_BITS, end = Math.min(q + PAGE, kinds.length), i = 0; q < end; q++, i++) {
                int code = abilities[q] == 0 && kinds[q] != Kind.ABSENT ? KIND_MASK : kinds[q];
                page[i] = (char) (abilities[q] | code << KIND);
            }
        }
        return new Words(pages, true);
    }

    /** Returns words that share all pages until they are written. */
    public Words copy() {
        return new Words(pages.clone(), false);
    }

    /** Returns the word of a span. */
    public int get(int q) {
        return pages[q >> PAGE_BITS][q & PAGE - 1];
    }

    /** Copies the words of {@code count} spans from {@code q} on. */
    public void read(int q, int count, char[] into) {
        for (int done = 0; done < count; ) {
            int from = q + done & PAGE - 1;
            int part = Math.min(PAGE - from, count - done);
            System.arraycopy(pages[q + done >> PAGE_BITS], from, into, done, part);
            done += part;
        }
    }

    /** Changes the words of {@code count} spans from {@code q} on. */
    public void write(int q, int count, char[] from) {
        for (int done = 0; done < count; ) {
            int to = q + done & PAGE - 1;
            int part = Math.min(PAGE - to, count - done);
            int at = q + done >> PAGE_BITS;
            if (!Arrays.equals(pages[at], to, to + part, from, done, done + part)) {
                own(at);
                System.arraycopy(from, done, pages[at], to, part);
            }
            done += part;
        }
    }

    /** Changes the word of a span. */
    public void set(int q, int word) {
        int at = q >> PAGE_BITS;
        if (pages[at][q & PAGE - 1] == word) {
            return;
        }
        own(at);
        pages[at][q & PAGE - 1] = (char) word;
    }

    private void own(int page) {
        if (!owned[page]) {
            pages[page] = pages[page].clone();
            owned[page] = true;
        }
    }

    /** Returns the kind in a word: absent, stable, border or forbidden. */
    public static byte kind(int word) {
        int code = word >> KIND & KIND_MASK;
        return code == KIND_MASK ? Kind.FORBIDDEN : (byte) code;
    }
}
