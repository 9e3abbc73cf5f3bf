package troupe.work.inspect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import troupe.geometry.Polygon;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Avatar;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Encounter;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.scene.xml.SceneSource;

class SceneInspectionTest {
    private static final Actor ANNA = Actor.standard("anna").without(Set.of(Ability.MOVE));

    @Test
    void findsNothingWrongWithAWayAcrossAnEmptyRoom() {
        assertEquals(List.of(), problems(Place.of(5, 1)));
    }

    @Test
    void namesTheObstacleThatAGoalIsIn() {
        assertProblem(
                "the goal (3, 1) is inside obstacle 'wall', from whose top no way leads",
                problems(Place.of(3, 1), box("wall", 2.5, 0, 3.5, 2, 0, 2)));
        assertProblem(
                "the goal (3, 1, 0) is inside obstacle 'beam'",
                problems(Place.of(3, 1, 0), box("beam", 2.5, 0, 3.5, 2, 1.4, 1.5)));
    }

    @Test
    void saysWhatKeepsACrowdFromBeginning() {
        assertEquals(List.of(), crowd(Place.of(5, 1), 3));
        assertEquals(
                "move the goal into the open", crowd(Place.of(2.4, 1), 3).get(0).cure());
        Problem full = crowd(Place.of(5, 1), 90).get(0);
        assertTrue(full.message().startsWith("the spawn outline of 'all' has room for "), full.message());
        assertEquals("enlarge it or lower the count", full.cure());
    }

    @Test
    void namesEveryGroupOfACrowdThatCannotBegin() {
        Polygon open = Polygon.rectangle(0.2, 0.2, 2, 2.8);
        Polygon barred = Polygon.rectangle(2.6, 0.3, 3.4, 1.7);
        List<Problem> found = crowd(
                CrowdGroup.of("held", Place.of(3, 1), CrowdGroup.Members.of(2, open)),
                CrowdGroup.of("walled", Place.of(5, 1), CrowdGroup.Members.of(2, barred)),
                CrowdGroup.of("fine", Place.of(5, 1), CrowdGroup.Members.of(2, open)),
                CrowdGroup.of("half", Place.of(5, 1), CrowdGroup.Members.of(1, Polygon.rectangle(2, 0.3, 3.4, 1.7))));
        assertEquals(
                List.of(
                        "the goal (3, 1) of 'held' is inside obstacle 'wall'",
                        "nobody of 'walled' can stand in its spawn outline: obstacle 'wall' is at (2.65, 0.35)",
                        "less than half of the spawn outline of 'half' is free: obstacle 'wall' is at (2.55, 0.35)"),
                found.stream().map(Problem::message).toList());
        assertEquals(Severity.WARNING, found.get(2).severity());
        assertEquals("move it into the open", found.get(1).cure());
    }

    @Test
    void findsWallsBetweenACrowdAndItsGoal() {
        Scene scene = new Scene(
                "",
                new World(6, 3, 0.1),
                List.of(box("wall", 2.5, 0, 3.5, 3, 0, 2)),
                List.of(),
                List.of(),
                List.of(Crowd.of(
                        "crowd",
                        List.of(CrowdGroup.of(
                                "all",
                                Place.of(5, 1),
                                CrowdGroup.Members.of(2, Polygon.rectangle(0.2, 0.2, 2, 2.8)))))));
        Problem apart = SceneInspection.check(new SceneSource(scene, Map.of())).get(0);
        assertEquals("walls keep the spawn outline of 'all' and its goal (5, 1) apart", apart.message());
        assertEquals("leave a gap of at least 0.50 m for them", apart.cure());
    }

    private static List<Problem> crowd(Place goal, int count) {
        return crowd(CrowdGroup.of("all", goal, CrowdGroup.Members.of(count, Polygon.rectangle(0.2, 0.2, 2, 2.8))));
    }

    private static List<Problem> crowd(CrowdGroup... groups) {
        Scene scene = new Scene(
                "",
                new World(6, 3, 0.1),
                List.of(box("wall", 2.5, 0, 3.5, 2, 0, 2)),
                List.of(),
                List.of(),
                List.of(Crowd.of("crowd", List.of(groups))));
        return SceneInspection.check(new SceneSource(scene, Map.of()));
    }

    @Test
    void letsAGoalStandOnAStep() {
        assertEquals(
                List.of(),
                problems(Place.of(3, 1), box("low", 2, 0, 2.5, 3, 0, 0.2), box("high", 2.5, 0, 3.5, 3, 0, 0.4)));
    }

    @Test
    void namesTheFloorsWhereNoLayerCarriesAGoal() {
        assertProblem(
                "no layer carries the goal (3, 1, 1.5); floors there: 0, 3",
                problems(Place.of(3, 1, 1.5), box("deck", 2, 0, 4, 3, 2.5, 0.5)));
        assertProblem(
                "the goal (3, 1) is inside obstacle 'crate'",
                problems(Place.of(3, 1), movable("crate", 2.5, 0, 3.5, 2, 0, 2)));
    }

    @Test
    void saysWhereThereIsNoRoomBesideAWall() {
        assertProblem(
                "the goal (3, 1) leaves actor 'anna' no room to stand",
                problems(Place.of(3, 1), box("wall", 3.1, 0, 3.5, 3, 0, 2)));
    }

    @Test
    void leavesTheGridAloneWhereTheSceneIsWrongAlready() {
        List<Problem> found = problems(Place.of(3, 1), box("flat", 2, 0, 2, 3, 0, 2));
        assertTrue(found.stream().allMatch(p -> p.element().equals("flat")), found.toString());
        assertTrue(found.size() >= 1, found.toString());
    }

    @Test
    void refusesObstaclesThatOverlapInTooManyWays() {
        Random random = new Random(7);
        Obstacle[] slabs = new Obstacle[600];
        for (int i = 0; i < slabs.length; i++) {
            double x = 1 + 2 * random.nextDouble();
            double y = 2 * random.nextDouble();
            slabs[i] = box("slab" + i, x, y, x + 2, y + 2, 3 + 0.1 * i, 0.04);
        }
        Actor thin = new Actor(
                "anna",
                "",
                "",
                ANNA.bodyHeight(),
                ANNA.footRadius(),
                ANNA.stepHeight(),
                ANNA.maxBorder(),
                ANNA.walk(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
        Scene scene = new Scene(
                "",
                new World(6, 5, 0.01),
                List.of(slabs),
                List.of(),
                List.of(thin),
                List.of(
                        Journey.of("j1", "anna", Place.of(0.5, 0.5), Place.of(5.5, 4.5)),
                        Journey.of("j2", "anna", Place.of(0.5, 0.5), Place.of(5.5, 4.5))));
        List<Problem> errors = SceneInspection.check(new SceneSource(scene, Map.of())).stream()
                .filter(p -> p.severity() == Severity.ERROR)
                .toList();
        assertEquals(1, errors.size(), errors::toString);
        assertTrue(errors.get(0).message().startsWith("obstacles overlap in more than"), errors::toString);
    }

    @Test
    void letsAGoalStandUnderWhatTheActorMayMove() {
        Obstacle crate = movable("crate", 2.5, 0, 3.5, 2, 0, 2);
        Actor mover = Actor.standard("anna");
        assertEquals(List.of(), problems(mover, Place.of(1, 1), Place.of(3, 1), crate));
        assertEquals(1, problems(mover, Place.of(3, 1), Place.of(1, 1), crate).size());
        Obstacle near = movable("crate", 2.5, 0, 3.05, 2, 0, 2);
        assertProblem(
                "the goal (3, 1) leaves actor 'anna' no room to stand",
                problems(mover, Place.of(1, 1), Place.of(3, 1), near, box("wall", 3.1, 0, 3.5, 3, 0, 2)));
    }

    @Test
    void warnsOfWhatIsMovableAndRestsOnNothing() {
        Place goal = Place.of(5, 1);
        List<Problem> found = problems(goal, movable("hung", 2, 2, 3, 3, 0.5, 1));
        assertEquals(1, found.size(), found::toString);
        assertEquals(Severity.WARNING, found.get(0).severity());
        assertEquals("hung", found.get(0).element());
        assertEquals(
                "it rests on nothing, so it cannot be moved: its bottom is at 0.5 m",
                found.get(0).message());
        Obstacle shelf = box("shelf", 2, 2, 2.7, 3, 0, 0.5);
        assertEquals(List.of(), problems(goal, shelf, movable("laid", 2, 2, 3, 3, 0.5, 1)));
    }

    @Test
    void findsWhatKeepsTheActorOfAnEncounterFromItsGoal() {
        assertEquals(List.of(), meeting(Place.of(1, 1), Place.of(5, 1)));
        assertProblem(
                "the start (3, 1) is inside obstacle 'wall', from whose top no way leads",
                meeting(Place.of(3, 1), Place.of(5, 1), box("wall", 2.5, 0, 3.5, 2, 0, 2)));
        assertProblem(
                "the goal (5, 1) leaves actor 'anna' no room to stand",
                meeting(Place.of(1, 1), Place.of(5, 1), box("wall", 5.2, 0, 5.5, 3, 0, 2)));
        assertProblem(
                "walls keep the start (1, 1) and the goal (5, 1) apart",
                meeting(Place.of(1, 1), Place.of(5, 1), box("wall", 2.5, 0, 3, 3.7, 0, 2)));
    }

    @Test
    void warnsOfAvatarsThatWalkThroughThingsOrBeginAtTheActor() {
        Obstacle wall = box("wall", 2.5, 0, 3.5, 2, 0, 2);
        Avatar through = Avatar.of(
                "bob",
                new Avatar.Script(Place.of(1, 1), 1, List.of(new Avatar.Head(Place.of(5, 1), OptionalDouble.empty()))));
        assertWarning(
                "avatar 'bob' walks through obstacle 'wall', 1.5 s after the start at (2.50, 1.00)", wall, through);
        Avatar round = Avatar.of(
                "bob",
                new Avatar.Script(Place.of(1, 1), 1, List.of(new Avatar.Head(Place.of(2, 3), OptionalDouble.empty()))));
        assertEquals(List.of(), meeting(Place.of(1, 3), Place.of(5, 3), List.of(round), wall));
        Avatar inside = Avatar.of("bob", new Avatar.Pointer(Place.of(3, 1)));
        assertWarning("avatar 'bob' begins inside obstacle 'wall', at (3.00, 1.00)", wall, inside);
        Avatar near = Avatar.of("bob", new Avatar.Pointer(Place.of(1.3, 3)));
        assertWarning("avatar 'bob' begins 0.30 m from the actor, so they touch", wall, near);
    }

    private static void assertWarning(String message, Obstacle wall, Avatar avatar) {
        List<Problem> found = meeting(Place.of(1, 3), Place.of(5, 3), List.of(avatar), wall);
        assertEquals(1, found.size(), found::toString);
        assertEquals(Severity.WARNING, found.get(0).severity());
        assertEquals("go", found.get(0).element());
        assertEquals(message, found.get(0).message());
    }

    private static List<Problem> meeting(Place start, Place goal, Obstacle... obstacles) {
        return meeting(start, goal, List.of(), obstacles);
    }

    private static List<Problem> meeting(Place start, Place goal, List<Avatar> avatars, Obstacle... obstacles) {
        Scene scene = new Scene(
                "",
                new World(6, 4, 0.1),
                List.of(obstacles),
                List.of(),
                List.of(ANNA),
                List.of(Encounter.of("go", "anna", start, goal, avatars)));
        return SceneInspection.check(new SceneSource(scene, Map.of("go", 7)));
    }

    private static void assertProblem(String message, List<Problem> found) {
        assertEquals(1, found.size(), found.toString());
        assertEquals(Severity.ERROR, found.get(0).severity());
        assertEquals("go", found.get(0).element());
        assertEquals(7, found.get(0).line());
        assertEquals(message, found.get(0).message());
    }

    private static List<Problem> problems(Place goal, Obstacle... obstacles) {
        return problems(ANNA, Place.of(1, 1), goal, obstacles);
    }

    private static List<Problem> problems(Actor actor, Place start, Place goal, Obstacle... obstacles) {
        Scene scene = new Scene(
                "",
                new World(6, 4, 0.1),
                List.of(obstacles),
                List.of(),
                List.of(actor),
                List.of(Journey.of("go", "anna", start, goal)));
        return SceneInspection.check(new SceneSource(scene, Map.of("go", 7)));
    }

    private static Obstacle box(String id, double x0, double y0, double x1, double y1, double offset, double height) {
        return new Obstacle(
                id, "", Polygon.rectangle(x0, y0, x1, y1), offset, height, false, Obstacle.DEFAULT_MASS, "");
    }

    private static Obstacle movable(
            String id, double x0, double y0, double x1, double y1, double offset, double height) {
        return new Obstacle(id, "", Polygon.rectangle(x0, y0, x1, y1), offset, height, true, Obstacle.DEFAULT_MASS, "");
    }
}
