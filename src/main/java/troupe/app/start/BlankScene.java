package troupe.app.start;

import java.util.List;
import troupe.app.document.SceneEdits;
import troupe.app.look.Texts;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Makes new scenes: empty ground, one actor, and a journey across it, so that there is a plan at once.
 *
 * @param key the word for the size in the texts
 * @param width the width in metres
 * @param depth the depth in metres
 */
public record BlankScene(String key, double width, double depth) {
    /** The sizes that have a name. */
    public static final List<BlankScene> SIZES =
            List.of(new BlankScene("room", 6, 5), new BlankScene("flat", 12, 9), new BlankScene("hall", 30, 20));

    /** The least side in metres. */
    public static final double LEAST = 2;

    /** The largest side in metres. */
    public static final double MOST = 100;

    private static final double[] CELLS = {0.025, 0.05, 0.1};
    private static final int CELLS_ALONG = 320;

    /** Tells whether a scene may have a side of this length in metres. */
    public static boolean isSide(double metres) {
        return metres >= LEAST && metres <= MOST;
    }

    /**
     * Makes a scene of this size, with names in a language.
     *
     * @throws IllegalArgumentException if a side is outside {@value #LEAST} to {@value #MOST} metres
     */
    public Scene scene(Texts texts) {
        if (!isSide(width) || !isSide(depth)) {
            throw new IllegalArgumentException(
                    "scene of " + width + " by " + depth + " m; each side needs " + LEAST + " to " + MOST);
        }
        double middle = SceneEdits.rounded(depth / 2);
        Journey journey = Journey.of(
                        "across",
                        "ann",
                        Place.of(SceneEdits.rounded(width / 6), middle),
                        Place.of(SceneEdits.rounded(width * 5 / 6), middle))
                .named("across", texts.get("new.across"));
        return new Scene(
                "",
                new World(width, depth, cell()),
                List.of(),
                List.of(),
                List.of(Actor.standard("ann").named("ann", "Ann")),
                List.of(journey));
    }

    /** Returns the finest cell in metres that is not too fine for planning while a thing is dragged. */
    private double cell() {
        for (double cell : CELLS) {
            if (Math.max(width, depth) / cell <= CELLS_ALONG) {
                return cell;
            }
        }
        return CELLS[CELLS.length - 1];
    }
}
