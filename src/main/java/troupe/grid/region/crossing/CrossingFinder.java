package troupe.grid.region.crossing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.geometry.Box;
import troupe.grid.GridFrame;
import troupe.grid.Morphology;
import troupe.grid.Window;
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
 * Finds the crossings of an actor over the cells of an area: per take-off floor the gaps it can stride and the
 * obstacles it can vault, as far as they lie on a legal straight crossing. Works in windows around the
 * surfaces or obstacles in question, so that the cost follows what there is to cross; the result is that of the
 * whole grid, cut to the area.
 *
 * <p>Source: Unified section 5 (opening); Li and Huang (gaps by closing); semantics in {@code docs/grid.md}.
 */
public final class CrossingFinder {
    private static final int WALK = Ability.WALK.bit();

    private final Actor actor;
    private final Spans spans;
    private final CrossingSurvey survey;
    private final Solids solids;
    private final Solids movable;
    private final Words words;
    private final GridFrame frame;
    private final double cell;
    private final int[] columnAt;
    private long[] found = new long[64];
    private int count;

    /** Prepares the search for crossings where movable obstacles stand and the words tell how spans are. */
    public CrossingFinder(Structure structure, Solid[] movables, Words words) {
        this.actor = structure.actor();
        this.spans = structure.spans();
        this.survey = structure.survey();
        this.solids = structure.fixed().about(structure.solids(movables));
        this.movable = structure.fixed().about(Structure.present(movables));
        this.words = words;
        this.frame = spans.frame();
        this.cell = frame.cell();
        this.columnAt = spans.columnAt();
    }

    /** Returns the keys of {@link Crossings} of what was found so far, ascending. */
    public long[] found() {
        return Crossings.sorted(found, count);
    }

    /** Finds all gaps and, unless they are found otherwise, all vaults. */
    public void findAll(boolean vaults) {
        Window whole = new Window(0, 0, frame.cols(), frame.rows());
        for (int level = 0; level < spans.levels(); level++) {
            gaps(level, whole);
            if (vaults) {
                vaults(level, whole);
            }
        }
    }

    /** Finds the gaps of a level over the cells of an area. */
    public void gaps(int level, Window area) {
        if (actor.stride().isPresent() && survey.takesOff(level)) {
            double gait = actor.stride().get().gait();
            Window around = area.grown(cells(gait), frame);
            for (CrossingSurvey.Mask mask : survey.gaps(level)) {
                gaps(level, gait, mask, around, area);
            }
        }
    }

    /**
     * Returns where gaps of a level change if only what is in a box of cells changes: those that candidates or ends
     * in it may belong to.
     */
    public List<Window> gapsAround(int level, Window box) {
        List<Window> areas = new ArrayList<>();
        if (actor.stride().isPresent() && survey.takesOff(level)) {
            for (CrossingSurvey.Mask mask : survey.gaps(level)) {
                add(
                        areas,
                        mask.window(),
                        box.grown(1, frame),
                        actor.stride().get().gait());
            }
        }
        return areas;
    }

    /**
     * Returns where vaults of a level change if only what is in a box of cells changes: an opening spreads that by
     * the reach, and the candidates there, near what can be vaulted now or could be before, pass it on by as much.
     *
     * @param changed solids that came or went
     */
    public List<Window> vaultsAround(int level, Window box, List<Solid> changed) {
        List<Window> areas = new ArrayList<>();
        if (actor.vault().isPresent() && survey.takesOff(level)) {
            double floor = spans.elevation(level);
            double reach = actor.vault().get().reach();
            List<Box> boxes =
                    new ArrayList<>(solids.vaultable(floor, actor.vault().get()));
            boxes.addAll(solids.about(changed).vaultable(floor, actor.vault().get()));
            for (Box low : boxes) {
                add(areas, Window.of(frame, low), box.grown(cells(reach), frame), reach);
            }
        }
        return areas;
    }

    private void add(List<Window> areas, Window candidates, Window changing, double limit) {
        Window common = candidates.common(changing);
        if (common.size() > 0) {
            areas.add(common.grown(cells(limit), frame));
        }
    }

    /** Finds the vaults of a level over the cells of an area. */
    public void vaults(int level, Window area) {
        if (actor.vault().isPresent() && survey.takesOff(level)) {
            vaults(level, actor.vault().get(), area);
        }
    }

    /** Returns how many cells a limit in metres may pass, one more for rounding. */
    private int cells(double limit) {
        return (int) Math.ceil(limit / cell) + 1;
    }

    private void gaps(int level, double gait, CrossingSurvey.Mask mask, Window around, Window area) {
        Window window = mask.window().common(around);
        if (window.size() == 0) {
            return;
        }
        byte[] candidates = mask.window().cut(mask.cells(), window);
        movable.clearNearObstacles(spans.elevation(level), window, candidates);
        keep(level, Kind.GAP, gait, window, candidates, area);
    }

    private void vaults(int level, Actor.Vault vault, Window area) {
        double floor = spans.elevation(level);
        Window around = area.grown(cells(vault.reach()), frame);
        List<Box> boxes = new ArrayList<>();
        for (Box box : solids.vaultable(floor, vault)) {
            if (Window.of(frame, box).meets(around)) {
                boxes.add(box);
            }
        }
        if (boxes.isEmpty()) {
            return;
        }
        Window reachable =
                survey.takeOff(level).grown(cells(vault.reach()), frame).common(around);
        List<Window> clusters = survey.clusters(level, vault.reach());
        List<Window> windows = new ArrayList<>();
        for (Box box : Window.apart(boxes)) {
            for (Window cluster : clusters) {
                Window window = Window.of(frame, box).common(reachable).common(cluster);
                if (window.size() > 0) {
                    windows.add(window);
                }
            }
        }
        int margin = 3 * (int) Math.ceil(vault.reach() / 2 / cell);
        Window.merged(windows, margin).forEach(window -> vaults(level, vault, window, area));
    }

    private void vaults(int level, Actor.Vault vault, Window inner, Window area) {
        Window window = inner.grown(cells(vault.reach()), frame);
        byte[] vaultable = new byte[window.size()];
        if (!solids.vaultable(spans.elevation(level), vault, window, vaultable)) {
            return;
        }
        byte[] barred = new byte[window.size()];
        int[] base = survey.sheetsNear(level);
        char[] lowest = new char[window.cols()];
        for (int row = 0, i = 0; row < window.rows(); row++) {
            int at = (window.row0() + row) * frame.cols() + window.col0();
            words.read(at, lowest.length, lowest);
            for (int k = 0; k < lowest.length; k++, i++, at++) {
                int first = base[columnAt[at]];
                int word = first == 0 ? lowest[k] : first > 0 ? words.get(first + at) : 0;
                barred[i] = (word & WALK) != 0 ? vaultable[i] : 1;
            }
        }
        double radius = vault.reach() / 2 / cell;
        new Morphology(window.cols(), window.rows(), radius).open(barred, radius, true, barred);
        byte[] candidates = window.cut(vaultable, inner);
        byte[] opened = window.cut(barred, inner);
        for (int i = 0; i < candidates.length; i++) {
            candidates[i] &= (byte) ~opened[i];
        }
        keep(level, Kind.JUMPABLE, vault.reach(), inner, candidates, area);
    }

    /** Keeps of the candidates in a window what lies in the area and on a legal straight crossing. */
    private void keep(int level, byte kind, double limit, Window window, byte[] candidates, Window area) {
        Window occupied = window.occupied(candidates);
        if (occupied.size() == 0) {
            return;
        }
        Window ends = occupied.grown(1, frame);
        byte[] state = window.cut(candidates, ends.common(window), ends);
        int[] base = survey.sheetsNear(level);
        char[] lowest = new char[ends.cols()];
        for (int row = 0, i = 0; row < ends.rows(); row++) {
            int at = (ends.row0() + row) * frame.cols() + ends.col0();
            words.read(at, lowest.length, lowest);
            for (int k = 0; k < lowest.length; k++, i++, at++) {
                int first = base[columnAt[at]];
                int word = first == 0 ? lowest[k] : first > 0 ? words.get(first + at) : 0;
                if ((word & WALK) != 0 && Words.kind(word) == Kind.STABLE) {
                    boolean begins = spans.level(columnAt[at], first / frame.size()) == level;
                    state[i] |= (byte) (begins ? Pruning.END | Pruning.BEGIN : Pruning.END);
                }
            }
        }
        byte[] kept = new Pruning(ends.cols(), ends.rows(), state).kept(Pruning.squaredCells(limit, cell));
        for (int row = 0, i = 0; row < ends.rows(); row++) {
            int at = (ends.row0() + row) * frame.cols() + ends.col0();
            for (int end = i + ends.cols(); i < end; i++, at++) {
                if (kept[i] != 0 && area.holds(ends.col0() + ends.cols() - (end - i), ends.row0() + row)) {
                    if (count == found.length) {
                        found = Arrays.copyOf(found, 2 * count + 64);
                    }
                    found[count++] = Crossings.key(at, level, kind);
                }
            }
        }
    }
}
