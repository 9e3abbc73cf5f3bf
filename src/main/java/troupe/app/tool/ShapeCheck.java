package troupe.app.tool;

import java.util.Optional;
import troupe.app.look.Texts;
import troupe.geometry.Box;
import troupe.geometry.Polygon;
import troupe.geometry.SelfIntersection;
import troupe.scene.World;

/** Says at once what is wrong with an outline that is being drawn or bent. Pure. */
public final class ShapeCheck {
    private static final double LEAST_AREA = 1e-4;
    /** The most pairs of edges that are looked at; a larger outline is checked in the background only. */
    private static final long PAIRS = 200_000;

    private ShapeCheck() {}

    /** Returns what is wrong with the outline in the words of the person, empty if nothing is. */
    public static Optional<String> wrong(Polygon outline, World world, Texts texts) {
        if (outline.size() < 3) {
            return Optional.of(texts.get("shape.corners"));
        }
        Optional<SelfIntersection.Edges> meeting = SelfIntersection.find(outline, new SelfIntersection.Work(PAIRS));
        if (meeting.isPresent()) {
            int first = meeting.get().first() + 1;
            int second = meeting.get().second() + 1;
            return Optional.of(
                    first == second ? texts.format("shape.same", first) : texts.format("shape.meets", first, second));
        }
        if (Math.abs(outline.signedArea()) < LEAST_AREA) {
            return Optional.of(texts.get("shape.area"));
        }
        Box box = outline.bounds();
        boolean outside =
                box.maxX() <= 0 || box.maxY() <= 0 || box.minX() >= world.width() || box.minY() >= world.depth();
        return outside ? Optional.of(texts.get("shape.outside")) : Optional.empty();
    }
}
