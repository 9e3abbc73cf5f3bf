package troupe.unified.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.grid.GridFrame;
import troupe.grid.region.Region;
import troupe.grid.region.RegionBuilder;
import troupe.scene.Actor;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.manipulation.Plans;
import troupe.unified.manipulation.Shapes;
import troupe.unified.manipulation.SlowGrip;
import troupe.unified.manipulation.SlowInstance;

/**
 * Compares where an actor may let go with what its body meets on the way to the centre of its cell. The
 * cells are as broad as rounding off their corners allows, so that both ends may be free and the way not.
 */
class GripPropertyTest {
    private static final Actor ACTOR = Actor.walker("a", 0.3, 0);

    @Test
    void letsGoWhereTheBodyHasRoomToTheCentreOfItsCell() {
        Random random = new Random(9);
        int allowed = 0;
        int refused = 0;
        for (int trial = 0; trial < 600; trial++) {
            Scene scene = Plans.scene(
                    new World(4, 4, 0.42),
                    List.of(
                            Plans.solid(Shapes.star(random, 2, 2, 0.9), 0, 1, true),
                            Plans.solid(Shapes.star(random, 1 + 2 * random.nextDouble(), 3, 0.7), 0, 1, false)),
                    List.of());
            Movable movable = Plans.movable(scene, 12);
            Region base = new RegionBuilder(scene, ACTOR).region();
            GridFrame frame = base.frame();
            int trigger = frame.cellAt(1 + 2 * random.nextDouble(), 1 + 2 * random.nextDouble());
            Turns turns = new Turns(frame, movable, base.x(trigger), base.y(trigger));
            SlowGrip slow = new SlowGrip(scene, movable, base, trigger);
            Grip grip = SlowGrip.grip(scene, movable, base, trigger);
            for (int k = 0; k < 12; k++) {
                int stand = frame.index(turns.col(k), turns.row(k));
                LatticePose pose = new LatticePose(0, 0, k);
                boolean expected = slow.settles(new SlowInstance.State(pose, stand));
                assertEquals(expected, grip.settles(stand, 0, 0, k), "trial " + trial + ", heading " + k);
                allowed += expected ? 1 : 0;
                refused += expected ? 0 : 1;
            }
        }
        assertTrue(allowed > 300 && refused > 300, allowed + " allowed, " + refused + " refused");
    }
}
