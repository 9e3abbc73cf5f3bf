package troupe.run.view;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntUnaryOperator;
import troupe.grid.GridFrame;
import troupe.grid.Morphology;
import troupe.grid.layer.Column;
import troupe.grid.region.Region;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;
import troupe.scene.Actor;

/**
 * Shows how the opening finds what can be vaulted: for each storey the cells in which nobody can walk, and what becomes
 * of them. {@code core} is what the erosion leaves, {@code regrown} what the dilation gives back, {@code thin} what the
 * opening has taken away and yet is no vault, {@code vault} what it has taken away and a legal vault crosses. Pure.
 *
 * <p>Source: Unified section 5, figure 2 (a) to (d). Deviations: the four pictures of the figure are one, as each holds
 * the next; the opening is that of everything barred at the floor on which most of a storey's places lie, see
 * {@code docs/grid.md}, so places from which another floor is taken off are not looked at.
 */
final class OpeningSteps {
    static final String KEY = "opening";

    private static final List<String> WORDS = List.of("core", "regrown", "thin", "vault");

    private final Region region;
    private final Storeys storeys;
    private final IntUnaryOperator layer;

    /**
     * Prepares the steps of a region.
     *
     * @param layer tells the layer of a configuration, below 0 where there is none
     */
    OpeningSteps(Region region, Storeys storeys, IntUnaryOperator layer) {
        this.region = region;
        this.storeys = storeys;
        this.layer = layer;
    }

    /** Returns an overlay for each storey where somebody can walk; none for an actor that does not vault. */
    List<Overlay> overlays() {
        List<Overlay> overlays = new ArrayList<>();
        for (int storey = 0; storey < storeys.count() && region.actor().vault().isPresent(); storey++) {
            int level = level(storey);
            if (level >= 0) {
                overlays.add(steps(storey, level, region.actor().vault().get()));
            }
        }
        return overlays;
    }

    private boolean isWalked(int q) {
        return (region.abilities(q) & Ability.WALK.bit()) != 0;
    }

    /** Returns the level with the most places of a storey, the lowest of several, -1 if nobody walks there. */
    private int level(int storey) {
        int[] counts = new int[region.spans().levels()];
        for (int q = 0; q < region.spanCount(); q++) {
            if (layer.applyAsInt(q) >= 0 && storeys.of(layer.applyAsInt(q)) == storey && isWalked(q)) {
                counts[region.level(q)]++;
            }
        }
        int best = -1;
        for (int level = 0; level < counts.length; level++) {
            if (counts[level] > (best < 0 ? 0 : counts[best])) {
                best = level;
            }
        }
        return best;
    }

    private Overlay steps(int storey, int level, Actor.Vault vault) {
        GridFrame frame = region.frame();
        byte[] barred = barred(level);
        double radius = vault.reach() / 2 / frame.cell();
        Morphology disc = new Morphology(frame.cols(), frame.rows(), radius);
        byte[] core = new byte[barred.length];
        byte[] opened = new byte[barred.length];
        disc.erode(barred, radius, true, core);
        disc.dilate(core, radius, true, opened);
        float[] values = new float[barred.length];
        for (int i = 0; i < values.length; i++) {
            boolean vaulted = opened[i] == 0 && region.crossing(i, level, Kind.JUMPABLE) >= 0;
            values[i] = barred[i] == 0 ? Float.NaN : core[i] != 0 ? 0 : opened[i] != 0 ? 1 : vaulted ? 3 : 2;
        }
        return new Overlay.Field(KEY, storey, frame, values, new Overlay.Categories(WORDS));
    }

    /** Returns the cells in which nobody can walk within a step of a level. */
    private byte[] barred(int level) {
        double floor = region.spans().elevation(level);
        double step = region.actor().stepHeight() + Column.SAME;
        byte[] barred = new byte[region.frame().size()];
        Arrays.fill(barred, (byte) 1);
        for (int q = 0; q < region.spanCount(); q++) {
            if (isWalked(q) && Math.abs(region.elevation(q) - floor) <= step) {
                barred[region.cell(q)] = 0;
            }
        }
        return barred;
    }
}
