package troupe.run.view;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import troupe.grid.field.Nf2;
import troupe.grid.layer.Layers;
import troupe.grid.region.Region;
import troupe.grid.region.ground.Kind;
import troupe.scene.Ability;

/**
 * Turns the grid core into overlays, one for each storey: layers that do not lie over each other share a
 * storey, the ground floor is storey 0. A crossing is shown in the storey that it is entered from; where it
 * passes over a span of another layer of that storey (the top of the wall that is vaulted), the crossing is
 * shown. Immutable; serves any thread.
 */
public final class GridOverlays {
    /** The keys of the overlays, in the order of menus. */
    public static final List<String> KEYS = List.of(
            "layers",
            "elevation",
            "region",
            "class",
            "clearance",
            "crossings",
            OpeningSteps.KEY,
            "skeleton",
            "potential");

    private static final List<String> KINDS = IntStream.rangeClosed(Kind.ABSENT, Kind.FORBIDDEN)
            .mapToObj(kind -> Kind.word((byte) kind))
            .toList();
    private static final int NOWHERE = -1;
    private static final double CONTOURS = 12;

    private final Region region;
    private final int[] layer;
    private final int layers;
    private final Storeys storeys;

    /**
     * Makes the overlays of a region.
     *
     * @param layers the layers of the spans of the region. Cost O(size of the region).
     */
    public GridOverlays(Region region, Layers layers) {
        this.region = region;
        this.layers = layers.count();
        this.storeys = new Storeys(region, layers);
        layer = new int[region.size()];
        Arrays.fill(layer, NOWHERE);
        for (int q = 0; q < region.spanCount(); q++) {
            if (region.spans().exists(q)) {
                layer[q] = layers.layer(q);
            }
        }
        spreadToCrossings();
    }

    private void spreadToCrossings() {
        int[] targets = new int[Region.MAX_NEIGHBOURS];
        int[] directions = new int[Region.MAX_NEIGHBOURS];
        boolean changed = true;
        while (changed) {
            changed = false;
            for (int q = region.spanCount(); q < region.size(); q++) {
                int count = region.neighbours(q, targets, directions);
                for (int i = 0; i < count; i++) {
                    int other = layer[targets[i]];
                    if (other != NOWHERE && (layer[q] == NOWHERE || other < layer[q])) {
                        layer[q] = other;
                        changed = true;
                    }
                }
            }
        }
    }

    /**
     * Returns the overlays of one kind; none if it needs NF2 and that is missing.
     *
     * @param nf2 the field towards the goal, null if there is none
     * @throws IllegalArgumentException if the key is not one of {@link #KEYS}
     * @throws CancellationException if the thread is interrupted
     */
    public List<Overlay> of(String key, Nf2 nf2) {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("interrupted before overlay '" + key + "'");
        }
        return switch (key) {
            case "layers" -> layers();
            case "elevation" -> elevation();
            case "region" -> region();
            case "class" -> kinds();
            case "clearance" -> clearance();
            case "crossings" -> crossings();
            case OpeningSteps.KEY -> opening();
            case "skeleton" -> nf2 == null ? List.of() : skeleton(nf2);
            case "potential" -> nf2 == null ? List.of() : potential(nf2);
            default ->
                throw new IllegalArgumentException("overlay '" + key + "'; needs one of " + String.join(", ", KEYS));
        };
    }

    /** Returns the storey that a layer is shown in. */
    public int storey(int layer) {
        return storeys.of(layer);
    }

    /** Returns which cells each layer covers. */
    public List<Overlay> layers() {
        List<String> words =
                IntStream.range(0, layers).mapToObj(k -> "layer " + (k + 1)).toList();
        return fields("layers", q -> q < region.spanCount(), q -> layer[q], new Overlay.Categories(words));
    }

    /** Returns the floor elevations. */
    public List<Overlay> elevation() {
        return measured("elevation", q -> q < region.spanCount(), region::elevation, false);
    }

    /** Returns where the actor can be, by the first ability usable there. */
    public List<Overlay> region() {
        List<String> words =
                Arrays.stream(Ability.values()).map(Ability::key).limit(4).toList();
        return fields(
                "region",
                region::open,
                q -> Integer.numberOfTrailingZeros(region.abilities(q)),
                new Overlay.Categories(words));
    }

    /** Returns the class of every configuration, forbidden also where a movable obstacle stands. */
    public List<Overlay> kinds() {
        return fields(
                "class",
                q -> true,
                q -> region.open(q) ? region.kind(q) : Kind.FORBIDDEN,
                new Overlay.Categories(KINDS));
    }

    /** Returns the crossings. */
    public List<Overlay> crossings() {
        return fields("crossings", q -> q >= region.spanCount(), region::kind, new Overlay.Categories(KINDS));
    }

    /** Returns the steps of the opening that finds what can be vaulted; none for an actor that does not vault. */
    public List<Overlay> opening() {
        return new OpeningSteps(region, storeys, q -> layer[q]).overlays();
    }

    /** Returns the clearance of the spans. */
    public List<Overlay> clearance() {
        return measured("clearance", q -> q < region.spanCount(), region::clearance, false);
    }

    /** Returns the potential, with contour lines. */
    public List<Overlay> potential(Nf2 nf2) {
        return measured("potential", q -> region.open(q) && Double.isFinite(nf2.potential(q)), nf2::potential, true);
    }

    /** Returns the skeleton as polylines. */
    public List<Overlay> skeleton(Nf2 nf2) {
        int[] storey =
                Arrays.stream(layer).map(k -> k == NOWHERE ? 0 : storeys.of(k)).toArray();
        SkeletonLines lines = new SkeletonLines(region, nf2::skeleton, storey, storeys.count());
        List<Overlay> overlays = new ArrayList<>();
        for (int k = 0; k < storeys.count(); k++) {
            if (!lines.inStorey(k).isEmpty()) {
                overlays.add(new Overlay.Lines("skeleton", k, lines.inStorey(k)));
            }
        }
        return overlays;
    }

    private List<Overlay> measured(String key, IntPredicate shown, IntToDoubleFunction value, boolean contours) {
        double min = Double.POSITIVE_INFINITY;
        double max = Double.NEGATIVE_INFINITY;
        for (int q = 0; q < layer.length; q++) {
            if (layer[q] != NOWHERE && shown.test(q)) {
                double v = value.applyAsDouble(q);
                min = Math.min(min, v);
                max = Math.max(max, v);
            }
        }
        if (!(min <= max)) {
            min = 0;
            max = 0;
        }
        double least = key.equals("elevation") ? min : 0;
        double step = contours && max > 0 ? round(max / CONTOURS) : 0;
        return fields(key, shown, value, new Overlay.Continuous("m", least, Math.max(max, least + 1e-3), step));
    }

    /** Returns the number of the form 1, 2 or 5 times a power of ten next above {@code value}. */
    static double round(double value) {
        double power = 1e-9;
        while (power * 10 <= value) {
            power *= 10;
        }
        for (double factor : new double[] {1, 2, 5}) {
            if (power * factor >= value) {
                return power * factor;
            }
        }
        return power * 10;
    }

    private List<Overlay> fields(String key, IntPredicate shown, IntToDoubleFunction value, Overlay.Scale scale) {
        int[][] holders = new int[storeys.count()][];
        for (int q = 0; q < layer.length; q++) {
            if (layer[q] == NOWHERE || !shown.test(q)) {
                continue;
            }
            int storey = storeys.of(layer[q]);
            if (holders[storey] == null) {
                holders[storey] = new int[region.frame().size()];
                Arrays.fill(holders[storey], NOWHERE);
            }
            int holder = holders[storey][region.cell(q)];
            if (holder == NOWHERE || !region.open(holder) || layer[holder] != layer[q]) {
                holders[storey][region.cell(q)] = q;
            }
        }
        List<Overlay> overlays = new ArrayList<>();
        for (int k = 0; k < holders.length; k++) {
            if (holders[k] != null) {
                float[] values = new float[holders[k].length];
                for (int cell = 0; cell < values.length; cell++) {
                    int q = holders[k][cell];
                    values[cell] = q == NOWHERE ? Float.NaN : (float) value.applyAsDouble(q);
                }
                overlays.add(new Overlay.Field(key, k, region.frame(), values, scale));
            }
        }
        return overlays;
    }
}
