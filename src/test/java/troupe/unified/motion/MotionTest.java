package troupe.unified.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.Frames;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.unified.body.SweptBody;
import troupe.unified.manipulation.Transfer;
import troupe.unified.obstacle.LatticePose;
import troupe.unified.obstacle.Movable;

class MotionTest {
    private static final int X = 0;
    private static final int Y = 1;
    private static final int Z = 2;
    private static final int HEADING = 3;
    private static final int ABILITY = 4;
    private static final int PHASE = 5;

    private final Actor actor = Actor.standard("ann");

    private static Stretch stretch(Ability ability, double... xyz) {
        List<double[]> points = new ArrayList<>();
        for (int i = 0; i < xyz.length; i += 3) {
            points.add(new double[] {xyz[i], xyz[i + 1], xyz[i + 2]});
        }
        return new Stretch(ability, "", 1, points);
    }

    @Test
    void walksStraightAtItsSpeed() {
        Motion.Recorded recorded = new Motion(actor, List.of(stretch(Ability.WALK, 1, 1, 0, 1, 3.6, 0))).record();
        Frames frames = recorded.frames();
        assertEquals(51, frames.count(), 1);
        assertEquals(1 + 1.3, frames.value(25, Y, 0), 1e-9);
        assertEquals(3.6, frames.value(frames.count() - 1, Y, 0));
        assertEquals(Math.PI / 2, frames.value(30, HEADING, 0), 1e-12);
        assertEquals(1.3 / 1.4, frames.value(25, PHASE, 0), 1e-6);
        assertEquals(2.0, recorded.legs().get(0).end(), 1e-9);
    }

    @Test
    void turnsItsBodySidewaysBeforeItSidesteps() {
        Frames frames = new Motion(
                        actor,
                        List.of(
                                stretch(Ability.WALK, 0, 0, 0, 1, 0, 0),
                                stretch(Ability.SIDESTEP, 1, 0, 0, 2, 0, 0),
                                stretch(Ability.WALK, 2, 0, 0, 3, 0, 0)))
                .record()
                .frames();
        int moved = 0;
        for (int f = 0; f < frames.count(); f++) {
            double x = frames.value(f, X, 0);
            if (frames.value(f, ABILITY, 0) == Ability.SIDESTEP.ordinal() && x > 1) {
                assertEquals(Math.PI / 2, frames.value(f, HEADING, 0), 1e-9, "frame " + f);
                moved++;
            }
        }
        assertEquals(41, moved, 1, "a metre at 0.6 m/s");
        assertEquals(0, frames.value(frames.count() - 1, HEADING, 0), 1e-9);
    }

    @Test
    void facesTheObstacleBeforeItVaultsIt() {
        Motion.Recorded recorded = new Motion(
                        actor,
                        List.of(
                                stretch(Ability.WALK, 0, 0, 0, 2, 0, 0),
                                stretch(Ability.VAULT, 2, 0, 0, 2, 0.5, 1, 2, 1, 0)))
                .record();
        Frames frames = recorded.frames();
        double highest = 0;
        for (int f = 0; f < frames.count(); f++) {
            if (frames.value(f, Y, 0) > 0) {
                assertEquals(Math.PI / 2, frames.value(f, HEADING, 0), 1e-9);
                assertEquals(frames.value(f, Y, 0), frames.value(f, PHASE, 0), 1e-6);
            }
            highest = Math.max(highest, frames.value(f, Z, 0));
        }
        assertEquals(1, highest, 0.08);
        assertEquals(2, recorded.legs().size());
        Run.Leg vault = recorded.legs().get(1);
        assertEquals("vault", vault.ability());
        assertEquals(recorded.legs().get(0).end(), vault.begin());
        assertTrue(vault.end() - vault.begin() >= 1 - 1e-9, "a metre at 1 m/s, and the turn");
    }

    @Test
    void standsStillWhereStartAndGoalAreOne() {
        Motion.Recorded recorded = new Motion(actor, List.of(stretch(Ability.WALK, 1, 2, 0.5))).record();
        assertEquals(1, recorded.frames().value(0, X, 0));
        assertEquals(0.5, recorded.frames().value(0, Z, 0));
        assertEquals(0, recorded.legs().get(0).end());
        assertEquals(0, new Motion(actor, List.of()).record().frames().count());
    }

    private static final Obstacle CRATE =
            new Obstacle("crate", "", Polygon.rectangle(1.5, 1.5, 2.5, 2.5), 0, 1, true, 10, "");

    /** Makes a route in which the crate is shifted by 0.2 m to the east and turned by a quarter counter-clockwise. */
    private List<Stretch> hauled(boolean gripped, Haul.Stand to) {
        Scene scene = new Scene("", new World(4, 4, 0.1), List.of(CRATE), List.of(), List.of(actor), List.of());
        Movable movable = new Movable(0, CRATE, 0.1, 4);
        List<LatticePose> poses =
                List.of(LatticePose.HOME, new LatticePose(1, 0, 0), new LatticePose(2, 0, 0), new LatticePose(2, 0, 1));
        Transfer transfer = new Transfer(0, gripped, 0, 0, poses, 0.2, Math.PI / 2, gripped ? 1 : 0);
        Haul haul = new Haul(movable, transfer, new Haul.Stand(1.2, 2, 0), to, new SweptBody(scene, actor));
        return List.of(
                stretch(Ability.WALK, 1.2, 1, 0, 1.2, 2, 0),
                new Stretch(Ability.MOVE, "crate", 3, haul.points(), Optional.of(haul)),
                stretch(Ability.WALK, to.x(), to.y(), 0, to.x() + 1, to.y(), 0));
    }

    @Test
    void movesRigidlyWithWhatItHolds() {
        Motion.Recorded recorded = new Motion(actor, hauled(true, new Haul.Stand(2.25, 1.2, 0))).record();
        Frames frames = recorded.frames();
        assertEquals(
                List.of("x", "y", "heading"),
                frames.channels().subList(6, 9).stream().map(Channel::name).toList());
        assertEquals("crate", frames.channels().get(8).owner());
        Run.Leg leg = recorded.legs().get(1);
        assertEquals("move", leg.ability());
        assertEquals("crate", leg.what());
        // a quarter turn to face the hold, the shift, the turn with an arm of 0.8 m, and a step to the centre
        double seconds = 0.25 + (0.2 + 0.8 * Math.PI / 2 + 0.05) / 0.5;
        assertEquals(seconds, leg.end() - leg.begin(), 1e-9);
        for (int f = 0; f < frames.count(); f++) {
            double heading = frames.value(f, 8, 0);
            boolean before = f / 25.0 <= leg.begin() + 0.25;
            boolean hauls = f / 25.0 > leg.begin() + 0.25 && f / 25.0 < leg.end() - 0.1;
            if (before) {
                assertEquals(2, frames.value(f, 6, 0));
            }
            if (hauls) {
                assertEquals(Ability.MOVE.ordinal(), frames.value(f, ABILITY, 0));
                assertEquals(frames.value(f, 6, 0) - 0.8 * Math.cos(heading), frames.value(f, X, 0), 1e-9);
                assertEquals(2 - 0.8 * Math.sin(heading), frames.value(f, Y, 0), 1e-9);
                assertEquals(heading, frames.value(f, HEADING, 0), 1e-9, "it faces its hold, frame " + f);
            }
        }
        int last = frames.count() - 1;
        assertEquals(2.2, frames.value(last, 6, 0), 1e-12);
        assertEquals(2, frames.value(last, 7, 0), 1e-12);
        assertEquals(Math.PI / 2, frames.value(last, 8, 0), 1e-12);
        List<double[]> points = leg.points();
        assertEquals(1.4, points.get(1)[0], 1e-12, "two shifts are one line");
        for (int i = 1; i < points.size() - 1; i++) {
            assertEquals(0.8, Math.hypot(points.get(i)[0] - 2.2, points.get(i)[1] - 2), 1e-9);
        }
    }

    @Test
    void standsAndLooksOnWhereNoGripIsAskedFor() {
        Motion.Recorded recorded = new Motion(actor, hauled(false, new Haul.Stand(1.2, 2, 0))).record();
        Frames frames = recorded.frames();
        Run.Leg leg = recorded.legs().get(1);
        double arm = Math.sqrt(0.5);
        assertEquals(0.25 + (0.2 + arm * Math.PI / 2) / 0.5, leg.end() - leg.begin(), 1e-9);
        for (int f = 0; f < frames.count(); f++) {
            if (frames.value(f, ABILITY, 0) == Ability.MOVE.ordinal()) {
                assertEquals(1.2, frames.value(f, X, 0), 1e-9);
                assertEquals(2, frames.value(f, Y, 0), 1e-9);
            }
            if (f / 25.0 > leg.begin() + 0.26 && f / 25.0 < leg.end()) {
                assertEquals(0, frames.value(f, HEADING, 0), 1e-9, "frame " + f);
            }
        }
        assertEquals(Math.PI / 2, frames.value(frames.count() - 1, 8, 0), 1e-12);
        assertEquals(2, leg.points().size());
    }

    @Test
    void stepsUpEvenlyWhileItHauls() {
        Obstacle plate = new Obstacle("plate", "", Polygon.rectangle(1.45, 0, 4, 4), 0, 0.2, false, 10, "");
        Obstacle crate = new Obstacle("crate", "", Polygon.rectangle(2, 1.5, 3, 2.5), 0.2, 1, true, 10, "");
        Scene scene = new Scene("", new World(6, 4, 0.1), List.of(plate, crate), List.of(), List.of(actor), List.of());
        List<LatticePose> poses =
                List.of(LatticePose.HOME, new LatticePose(1, 0, 0), new LatticePose(2, 0, 0), new LatticePose(3, 0, 0));
        Transfer transfer = new Transfer(1, true, 0, 0, poses, 0.3, 0, 0.3);
        Haul haul = new Haul(
                new Movable(1, crate, 0.1, 4),
                transfer,
                new Haul.Stand(1.3, 2, 0),
                new Haul.Stand(1.6, 2, 0.2),
                new SweptBody(scene, actor));
        assertEquals(0, haul.actor(0.1)[2], 1e-9);
        assertEquals(0.1, haul.actor(0.15)[2], 1e-9);
        assertEquals(0.2, haul.actor(0.2)[2], 1e-9);
        assertEquals(4, haul.points().size(), haul.points().toString());
    }

    @Test
    void randomRoutesTurnAndMoveNoFasterThanAllowed() {
        Random random = new Random(8);
        for (int trial = 0; trial < 200; trial++) {
            double[] at = {random.nextDouble(), random.nextDouble(), 0};
            List<Stretch> route = new ArrayList<>();
            for (int s = 0; s < 5; s++) {
                double[] xyz = new double[3 * (2 + random.nextInt(4))];
                for (int i = 0; i < xyz.length; i += 3) {
                    if (i > 0) {
                        at[0] += random.nextDouble() - 0.5;
                        at[1] += random.nextInt(3) - 1;
                        at[2] = random.nextDouble() * 0.2;
                    }
                    System.arraycopy(at, 0, xyz, i, 3);
                }
                route.add(stretch(Ability.values()[random.nextInt(4)], xyz));
            }
            check(new Motion(actor, route).record(), route, "seed 8, route " + trial);
        }
    }

    private static void check(Motion.Recorded recorded, List<Stretch> route, String which) {
        Frames frames = recorded.frames();
        for (int f = 1; f < frames.count(); f++) {
            double turn = Motion.wrapped(frames.value(f, HEADING, 0) - frames.value(f - 1, HEADING, 0));
            assertTrue(Math.abs(turn) <= 2 * Math.PI / 25 + 1e-9, which + ", frame " + f);
            double way = Math.hypot(
                    frames.value(f, X, 0) - frames.value(f - 1, X, 0),
                    frames.value(f, Y, 0) - frames.value(f - 1, Y, 0));
            assertTrue(way <= 1.5 / 25 + 1e-9, which + ", frame " + f + " moves " + way);
            double phase = frames.value(f, PHASE, 0);
            assertTrue(phase >= 0 && phase < 1, which);
        }
        assertEquals(route.size(), recorded.legs().size(), which);
        double[] goal = route.get(4).points().get(route.get(4).points().size() - 1);
        int last = frames.count() - 1;
        assertEquals(goal[0], frames.value(last, X, 0), which);
        assertEquals(goal[1], frames.value(last, Y, 0), which);
        assertEquals(goal[2], frames.value(last, Z, 0), which);
        assertTrue(frames.duration() - recorded.legs().get(4).end() < 1 / 25.0 + 1e-9, which);
    }
}
