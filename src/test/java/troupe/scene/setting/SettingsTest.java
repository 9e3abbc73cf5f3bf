package troupe.scene.setting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import troupe.scene.Ability;
import troupe.scene.Actor;
import troupe.scene.Journey;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.SceneTexts;
import troupe.scene.World;
import troupe.scene.xml.SceneXml;

class SettingsTest {
    private static final Scene SCENE = new Scene(
            "",
            World.of(10, 8),
            List.of(),
            List.of(),
            List.of(Actor.standard("a"), Actor.walker("w", 0.2, 0.1)),
            List.of(
                    Journey.of("j", "a", Place.of(1, 1), Place.of(2, 2)),
                    Journey.of("k", "w", Place.of(1, 1), Place.of(2, 2))));

    private static Journey journey(Scene scene) {
        return (Journey) scene.task("j").orElseThrow();
    }

    @Test
    void everyKeyChangesTheSceneAndSurvivesTheFile() throws Exception {
        Map<String, String> special = Map.of(
                "ordering",
                "bounded(1.5)",
                "spread",
                "clearance",
                "manipulation",
                "free",
                "start",
                "3,4,0.5",
                "goal",
                "5,6",
                "cell",
                "0.1");
        for (String key : Settings.keys(SCENE.task("j").orElseThrow())) {
            Scene changed = Settings.apply(SCENE, "j", key, special.getOrDefault(key, "77"));
            assertNotEquals(SCENE, changed, key);
            assertEquals(changed, SceneTexts.read(SceneXml.write(changed)), key);
            String told = Settings.values(changed, "j").get(key);
            assertEquals(special.getOrDefault(key, "77"), told, key);
        }
    }

    @Test
    void theValuesOfATaskMakeItAgainFromAnother() {
        Scene odd = Settings.apply(Settings.apply(SCENE, "j", "preference.vault", "off"), "j", "vault.reach", "1.2");
        Scene again = SCENE;
        for (Map.Entry<String, String> setting : Settings.values(odd, "j").entrySet()) {
            again = Settings.apply(again, "j", setting.getKey(), setting.getValue());
        }
        assertEquals(odd, again);
        assertEquals(false, Settings.values(SCENE, "k").containsKey("vault.reach"));
    }

    @Test
    void turnsAnAbilityOff() {
        Scene changed = Settings.apply(SCENE, "j", "preference.vault", "off");
        assertEquals(false, journey(changed).preferences().allows(Ability.VAULT));
    }

    @Test
    void theGridLimitFollowsTheGaitUnlessItWasSet() {
        Actor longer = Settings.apply(SCENE, "j", "stride.gait", "2").actor("a").orElseThrow();
        assertEquals(2.2, longer.stride().orElseThrow().maxGap(), 1e-12);
        Scene own = Settings.apply(SCENE, "j", "stride.maxGap", "3");
        Actor kept = Settings.apply(own, "j", "stride.gait", "2").actor("a").orElseThrow();
        assertEquals(3, kept.stride().orElseThrow().maxGap());
    }

    @Test
    void namesTheKnownKeysAndTheAllowedValues() {
        assertRefused("no such", "known are ordering, spread", "j", "no such", "1");
        assertRefused("task", "the scene has j, k", "x", "seed", "1");
        assertRefused("ordering", "paper(a,b) or bounded(w)", "j", "ordering", "fast");
        assertRefused("bounded", "needs a number from 1", "j", "ordering", "bounded(0.5)");
        assertRefused("slice", "from 1 to", "j", "slice", "0");
        assertRefused("manipulation", "needs free or grip", "j", "manipulation", "push");
        assertRefused("no heading", "from 1 to 360", "j", "headings", "0");
        assertRefused("headings", "from 1 to 360", "j", "headings", "361");
        assertRefused("preference", "above 0, or off", "j", "preference.walk", "0");
        assertRefused("vault", "cannot vault", "k", "vault.reach", "2");
        assertRefused("nan", "finite", "j", "walk.radius", "NaN");
        assertRefused("start", "x,y or x,y,z", "j", "start", "1");
    }

    private static void assertRefused(String what, String words, String task, String key, String value) {
        String message = assertThrows(
                        IllegalArgumentException.class, () -> Settings.apply(SCENE, task, key, value), what)
                .getMessage();
        assertTrue(message.contains(words), message);
    }
}
