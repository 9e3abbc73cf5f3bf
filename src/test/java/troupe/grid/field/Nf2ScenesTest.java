package troupe.grid.field;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import troupe.grid.region.Region;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Scene;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;

/** Checks what must hold of NF2 on every sample scene, with the movable obstacles and without them. */
class Nf2ScenesTest {
    static List<Path> scenes() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("scenes/unified"))) {
            return files.filter(file -> file.toString().endsWith(".xml"))
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void fieldsOfEachJourneyAreSound(Path file) throws IOException, SceneException {
        Scene scene = SceneXml.read(file).scene();
        List<Obstacle> fixed =
                scene.obstacles().stream().filter(o -> !o.movable()).toList();
        Scene cleared = new Scene(scene.title(), scene.world(), fixed, scene.ditches(), scene.actors(), scene.tasks());
        for (Scene each : fixed.size() == scene.obstacles().size() ? List.of(scene) : List.of(scene, cleared)) {
            each.tasks().stream()
                    .filter(Journey.class::isInstance)
                    .map(Journey.class::cast)
                    .limit(1)
                    .forEach(journey -> check(each, journey, file.getFileName() + " " + journey.id()));
        }
    }

    private static void check(Scene scene, Journey journey, String message) {
        Set<Ability> lost = EnumSet.allOf(Ability.class);
        lost.removeIf(journey.preferences()::allows);
        Actor actor = scene.actor(journey.actor()).orElseThrow().without(lost);
        Region region = Region.of(scene, actor);
        int goal = region.locate(journey.goal());
        FieldsOracle oracle = new FieldsOracle(region, message);
        Nf2 fields = new Nf2(region);
        for (Journey.Spread spread : Journey.Spread.values()) {
            oracle.checkPotential(fields.compute(goal, spread));
        }
        oracle.checkPieces(fields);
        oracle.checkThin(fields);
        oracle.checkMedial(fields);
    }
}
