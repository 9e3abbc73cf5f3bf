package troupe.app.tool;

import troupe.geometry.Point;

/** Says what a place was snapped to: a corner, an edge or a direction from one place to another, or the grid. */
public record Guide(Kind kind, Point from, Point to) {

    /** What there is to snap to, the first before the later. */
    public enum Kind {
        CORNER,
        EDGE,
        ANGLE,
        GRID
    }
}
