package troupe.grid.region.crossing;

import java.util.Arrays;
import java.util.List;
import troupe.grid.GridFrame;
import troupe.grid.Morphology;
import troupe.grid.Window;
import troupe.grid.layer.Columns;
import troupe.grid.layer.Spans;
import troupe.grid.region.ground.CrossingSurvey;
import troupe.grid.region.ground.Kind;
import troupe.grid.region.ground.Solid;
import troupe.grid.region.ground.Solids;
import troupe.grid.region.ground.Structure;
import troupe.grid.region.ground.Words;
import troupe.scene.Ability;
import troupe.scene.Actor;

/**
 * Finds crossings that bound every vault which some placement of the movable obstacles allows. A placement can
 * make places vaultable that are not so without it; but where a vault passes nothing else than obstacles that
 * could be moved, there one can walk without them, at no more cost.
 *
 * <p>Per take-off floor, with no movable obstacle there: {@code C} are the cells where one cannot walk within a step
 * of the floor; {@code X} those of them that an opening by a disc of diameter {@code reach} removes and that
 * lie near nothing which no vault can take. Whatever stands where, the cells of a vault lie near nothing that no
 * vault can take, and are either in {@code X} or can be walked on, because an opening of more removes no
 * more. Steps between the latter are legal without the movable obstacles unless two neighbouring cells have
 * open spans within a step of the floor that are not joined, {@code Y}. A vault that passes or touches neither
 * X nor Y can thus be walked. Any other one lies within the longest way over an obstacle, {@code maxJump}, and
 * three cells of a cell of X or Y; the crossings are all cells there, if not near what no vault can take, and not
 * kept by the opening. They need not lie on a straight crossing. From a floor from which no movable obstacle can be
 * vaulted, only cells over fixed solids are vaulted, and only those are crossings.
 */
public final class WidestVaults {
    /** One direction of each pair of opposite ones. */
    private static final int[] UP = {0, 1, 4, 5};

    private final Structure structure;
    private final Actor.Vault vault;
    private final Spans spans;
    private final CrossingSurvey survey;
    private final Solids solids;
    private final List<Solid> movables;
    private final Words words;
    private final GridFrame frame;
    private final double cell;
    private final int[] at;
    private long[] found = new long[64];
    private int count;

    /** Prepares the search in the words of the region without movable obstacles; the actor must be able to vault. */
    public WidestVaults(Structure structure, Words words) {
        this.structure = structure;
        this.vault = structure.actor().vault().orElseThrow();
        this.spans = structure.spans();
        this.survey = structure.survey();
        this.solids = structure.fixed().about(structure.solids(structure.none()));
        this.movables = Structure.present(structure.movables());
        this.words = words;
        this.frame = spans.frame();
        this.cell = frame.cell();
        this.at = spans.columnAt();
    }

    /** Returns the keys of {@link Crossings}, ascending. Cost O(cells) per take-off floor at worst. */
    public long[] find() {
        for (int level = 0; level < spans.levels(); level++) {
            if (survey.takesOff(level)) {
                Window window = survey.takeOff(level).grown(far() + 1, frame);
                if (isMovableVaulted(spans.elevation(level))) {
                    find(level, window);
                } else {
                    findFixed(level, window);
                }
            }
        }
        return Crossings.sorted(found, count);
    }

    /** Returns how far in cells a vault goes from a seed that it passes or touches. */
    private int far() {
        double most = Math.max(vault.maxJump(), vault.reach()) / cell;
        return (int) Math.min(Math.ceil(most) + 3, Math.max(frame.cols(), frame.rows()));
    }

    /** Tells whether hands can push off from some movable obstacle, wherever it stands, on a vault from a floor. */
    private boolean isMovableVaulted(double floor) {
        for (Solid movable : movables) {
            if (movable.blocks(floor) && movable.inRange(floor, vault)) {
                return true;
            }
        }
        return false;
    }

    /** Finds the crossings where only fixed solids can be vaulted: those over them that the opening does not keep. */
    private void findFixed(int level, Window window) {
        byte[] vaultable = new byte[window.size()];
        if (!solids.vaultable(spans.elevation(level), vault, window, vaultable)) {
            return;
        }
        byte[] barred = new byte[window.size()];
        findBarred(level, window, barred);
        open(window.occupied(vaultable), window, barred, new byte[window.size()], vaultable);
        add(level, window, vaultable);
    }

    private void add(int level, Window window, byte[] mask) {
        for (int row = 0, i = 0; row < window.rows(); row++) {
            int c = (window.row0() + row) * frame.cols() + window.col0();
            for (int end = i + window.cols(); i < end; i++, c++) {
                if (mask[i] != 0) {
                    if (count == found.length) {
                        found = Arrays.copyOf(found, 2 * count);
                    }
                    found[count++] = Crossings.key(c, level, Kind.JUMPABLE);
                }
            }
        }
    }

    private void find(int level, Window window) {
        byte[] seeds = new byte[window.size()];
        byte[] barred = new byte[window.size()];
        findBarred(level, window, barred);
        byte[] untakeable = new byte[window.size()];
        solids.untakeable(spans.elevation(level), vault, window, untakeable);
        for (int row = 0, i = 0; row < window.rows(); row++) {
            int c = (window.row0() + row) * frame.cols() + window.col0();
            for (int end = i + window.cols(); i < end; i++, c++) {
                untakeable[i] |= (byte) (at[c] == Columns.ROCK ? 1 : 0);
                seeds[i] = (byte) (barred[i] & ~untakeable[i]);
            }
        }
        Window narrow = window.occupied(seeds);
        if (narrow.size() > 0) {
            open(narrow, window, barred, untakeable, seeds);
        }
        addUnjoined(level, window, seeds);
        Window occupied = window.occupied(seeds);
        if (occupied.size() == 0) {
            return;
        }
        Window near = occupied.grown(far(), frame).common(window);
        byte[] spread = window.cut(seeds, near);
        new Morphology(near.cols(), near.rows(), far()).dilate(spread, far(), false, spread);
        for (int row = 0, i = 0; row < near.rows(); row++) {
            int own = (near.row0() + row - window.row0()) * window.cols() + near.col0() - window.col0();
            for (int end = i + near.cols(); i < end; i++, own++) {
                spread[i] &= (byte) ~untakeable[own];
            }
        }
        add(level, near, spread);
    }

    /** Sets the cells of a window where one cannot walk within a step of a level. */
    private void findBarred(int level, Window window, byte[] barred) {
        int[] base = survey.sheetsNear(level);
        for (int row = 0, i = 0; row < window.rows(); row++) {
            int c = (window.row0() + row) * frame.cols() + window.col0();
            for (int end = i + window.cols(); i < end; i++, c++) {
                int first = base[at[c]];
                barred[i] = (byte) (first >= 0 && (words.get(first + c) & Ability.WALK.bit()) != 0 ? 0 : 1);
            }
        }
    }

    /** Takes from the seeds, and adds to what no vault can take, what an opening of the barred cells keeps. */
    private void open(Window narrow, Window window, byte[] barred, byte[] untakeable, byte[] seeds) {
        int reach = (int) Math.ceil(vault.reach() / cell) + 1;
        Window around = narrow.grown(reach, frame);
        byte[] opened = window.cut(barred, around.common(window), around);
        double radius = vault.reach() / 2 / cell;
        new Morphology(around.cols(), around.rows(), radius).open(opened, radius, true, opened);
        for (int row = narrow.row0(); row < narrow.row0() + narrow.rows(); row++) {
            for (int col = narrow.col0(); col < narrow.col0() + narrow.cols(); col++) {
                int own = (row - window.row0()) * window.cols() + col - window.col0();
                if (seeds[own] != 0 && opened[(row - around.row0()) * around.cols() + col - around.col0()] != 0) {
                    seeds[own] = 0;
                    untakeable[own] = 1;
                }
            }
        }
    }

    /** Adds neighbouring cells that have open spans within a step of a level, of which none steps to the other. */
    private void addUnjoined(int level, Window window, byte[] seeds) {
        int[] base = survey.sheetsNear(level);
        for (int row = 0; row < window.rows(); row++) {
            for (int col = 0; col < window.cols(); col++) {
                int c = (window.row0() + row) * frame.cols() + window.col0() + col;
                int span = open(base, c);
                for (int k = 0; span >= 0 && k < UP.length; k++) {
                    int x = col + GridFrame.dx(UP[k]);
                    int y = row + GridFrame.dy(UP[k]);
                    if (x < 0 || x >= window.cols() || y >= window.rows()) {
                        continue;
                    }
                    int other = c + GridFrame.dy(UP[k]) * frame.cols() + GridFrame.dx(UP[k]);
                    if (at[other] != at[c] && open(base, other) >= 0 && !joined(base, c, other)) {
                        seeds[row * window.cols() + col] = 1;
                        seeds[y * window.cols() + x] = 1;
                    }
                }
            }
        }
    }

    private int open(int[] base, int c) {
        int first = base[at[c]];
        return first >= 0 && (words.get(first + c) & Words.STANDING) != 0 ? first + c : -1;
    }

    private boolean joined(int[] base, int a, int b) {
        Actor actor = structure.actor();
        int sheet = base[at[a]] / frame.size();
        return spans.linked(at[a], sheet, at[b], actor.stepHeight(), actor.bodyHeight()) * frame.size() == base[at[b]];
    }
}
