package troupe.grid.region;

import java.util.List;
import troupe.grid.GridFrame;
import troupe.grid.layer.Columns;
import troupe.grid.layer.Layers;
import troupe.grid.layer.Spans;
import troupe.grid.region.ground.Structure;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * Holds what does not depend on where the movable obstacles of a scene stand: spans, layers, how an actor stands
 * on them, and the widest region. Each is made when it is first asked for. Scenes that differ in the places of movable
 * obstacles only can share it, and get the same regions as without. Safe for any thread.
 */
public final class Groundwork {
    private final Scene scene;
    private final Actor actor;
    private Columns columns;
    private Spans spans;
    private Layers layers;
    private Structure structure;
    private Region widest;
    private Region bare;
    private volatile Region last;

    /** Makes the groundwork of an actor that has already lost the abilities which preferences switch off. */
    public Groundwork(Scene scene, Actor actor) {
        this.scene = scene;
        this.actor = actor;
    }

    /**
     * Tells whether it holds for another scene and actor: the same actor, world and ditches, and the same obstacles in
     * the same order, of which movable ones may have other outlines.
     */
    public boolean fits(Scene other, Actor walker) {
        List<Obstacle> mine = scene.obstacles();
        List<Obstacle> others = other.obstacles();
        boolean same = actor.equals(walker)
                && scene.world().equals(other.world())
                && scene.ditches().equals(other.ditches())
                && mine.size() == others.size();
        for (int i = 0; same && i < mine.size(); i++) {
            Obstacle a = mine.get(i);
            Obstacle b = others.get(i);
            same = a == b || a.equals(a.movable() && b.movable() ? b.withOutline(a.outline()) : b);
        }
        return same;
    }

    /** Finds the spans. */
    synchronized Spans spans() {
        if (spans == null) {
            GridFrame frame = GridFrame.of(scene.world());
            columns = new Columns(frame, scene);
            spans = new Spans(frame, columns, smallestBody());
        }
        return spans;
    }

    /** Numbers the layers of the spans. */
    synchronized Layers layers() {
        if (layers == null) {
            layers = new Layers(spans(), actor.stepHeight(), smallestBody());
        }
        return layers;
    }

    private double smallestBody() {
        return actor.vault()
                .map(v -> Math.min(v.bodyHeight(), actor.bodyHeight()))
                .orElse(actor.bodyHeight());
    }

    /** Returns what the regions of a scene that it fits have in common. */
    synchronized Structure structure(Scene fitting) {
        if (structure == null) {
            spans();
            structure = new Structure(scene, actor, columns, spans);
        }
        return fitting == scene ? structure : structure.of(fitting);
    }

    /** Finds the widest region. */
    synchronized Region widest() {
        if (widest == null) {
            widest = Region.widest(structure(scene));
        }
        return widest;
    }

    /** Returns a region of a scene that it fits as it is without any movable obstacle. */
    synchronized Region bare(Region fitting) {
        if (bare == null) {
            bare = fitting.bare();
        }
        return bare;
    }

    /**
     * Returns the region of a scene that it fits: the one asked for last with what has been moved since, if that is little,
     * else a new one.
     */
    Region region(Structure fitting) {
        Region before = last;
        Region made = before == null ? new Region(fitting, fitting.movables()) : before.at(fitting);
        last = made;
        return made;
    }
}
