package troupe.app.tool;

import java.util.Optional;
import troupe.geometry.Point;

/** Holds where a place, or a displacement, came to lie after snapping, and to what, if to anything. */
public record Snap(Point at, Optional<Guide> guide) {

    static Snap to(Point at, Guide.Kind kind, Point from, Point to) {
        return new Snap(at, Optional.of(new Guide(kind, from, to)));
    }
}
