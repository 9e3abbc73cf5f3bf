package troupe.app.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.Component;
import java.awt.EventQueue;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import troupe.app.Await;
import troupe.app.OnEventThread;
import troupe.app.Scenes;
import troupe.app.ScriptedSteps;
import troupe.app.Studios;
import troupe.app.document.SceneDocument;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.session.Session;
import troupe.paint.Theme;

class AspectBarTest {
    private final Session session = OnEventThread.get(() -> new Session(
            new SceneDocument(Scenes.room(), Optional.empty()),
            new ScriptedSteps(1, () -> {}),
            Studios.NO_FILES,
            EventQueue::invokeLater));

    @AfterEach
    void end() {
        session.close();
    }

    private AspectBar bar(Locale language) {
        return OnEventThread.get(() -> new AspectBar(new Look(Theme.LIGHT, new Texts(language)), session));
    }

    private static List<String> offered(AspectBar bar) {
        return OnEventThread.get(() -> Stream.of(bar.getComponents())
                .map(Component.class::cast)
                .map(c -> ((AbstractButton) c).getText())
                .toList());
    }

    @Test
    void offersAChoiceOnlyWhereThereIsOneAndItsViewsAreShown() {
        AspectBar bar = bar(Locale.ENGLISH);
        assertFalse(OnEventThread.get(bar::isVisible));
        OnEventThread.run(session::planNow);
        Await.until("spaces are offered", () -> offered(bar).equals(List.of("Space: as drawn")));
        OnEventThread.run(() -> session.overlays().choose(0, 1));
        Await.until("another is chosen", () -> offered(bar).equals(List.of("Space: Crate moved")));
        OnEventThread.run(() -> session.overlays().show("trigger", true));
        Await.until("its instances are offered", () -> offered(bar)
                .equals(List.of("Space: Crate moved", "Instance: 1: plain")));
        assertEquals(List.of("搜尋空間: Crate已搬移", "搬移實例: 1: plain"), offered(bar(Locale.TRADITIONAL_CHINESE)));
    }

    @Test
    void beginsAnewWithAnotherTask() {
        AspectBar bar = bar(Locale.ENGLISH);
        OnEventThread.run(session::planNow);
        Await.until("spaces are offered", () -> offered(bar).equals(List.of("Space: as drawn")));
        OnEventThread.run(() -> session.overlays().choose(0, 1));
        Await.until("another is chosen", () -> offered(bar).equals(List.of("Space: Crate moved")));
        OnEventThread.run(() -> session.document().lookAt("back"));
        Await.until("the first again", () -> offered(bar).equals(List.of("Space: as drawn")));
        assertEquals(List.of(), OnEventThread.get(() -> session.overlays().chosen()));
    }

    @Test
    void aSavedRunHasNoChoicesOfTheSceneBefore() {
        AspectBar bar = bar(Locale.ENGLISH);
        OnEventThread.run(session::planNow);
        Await.until("spaces are offered", () -> offered(bar).equals(List.of("Space: as drawn")));
        OnEventThread.run(() -> session.show(session.run().orElseThrow()));
        assertEquals(List.of(), offered(bar));
    }
}
