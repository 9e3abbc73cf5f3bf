package troupe.app.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JSlider;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import troupe.app.Await;
import troupe.app.OnEventThread;
import troupe.app.Scenes;
import troupe.app.ScriptedSteps;
import troupe.app.Studios;
import troupe.app.document.NewElements;
import troupe.app.document.SceneDocument;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.panel.inspector.InspectorPanel;
import troupe.app.panel.inspector.PreferencesSection;
import troupe.app.session.Session;
import troupe.geometry.Polygon;
import troupe.paint.Theme;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Ability;
import troupe.scene.Crowd;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Preferences;
import troupe.scene.Scene;
import troupe.search.Outcome;

/** Works the panels without a window. */
class PanelsTest {
    private final Look look = new Look(Theme.LIGHT, new Texts(Locale.ENGLISH));
    private final CountDownLatch goOn = new CountDownLatch(1);
    private Session session;

    private void begin(ScriptedSteps steps) {
        session = OnEventThread.get(() -> new Session(
                new SceneDocument(Scenes.room(), Optional.empty()), steps, Studios.NO_FILES, EventQueue::invokeLater));
    }

    @AfterEach
    void end() {
        goOn.countDown();
        if (session != null) {
            session.close();
        }
    }

    @SuppressWarnings("unchecked")
    private static <C extends Component> C find(Container in, String name) {
        List<Component> todo = new ArrayList<>(List.of(in.getComponents()));
        while (!todo.isEmpty()) {
            Component next = todo.remove(0);
            if (name.equals(next.getName())) {
                return (C) next;
            }
            if (next instanceof Container container) {
                todo.addAll(List.of(container.getComponents()));
            }
        }
        throw new AssertionError("no component " + name);
    }

    private Obstacle crate() {
        return session.document().scene().obstacle("crate").orElseThrow();
    }

    @Test
    void numbersInTheInspectorBecomeEdits() {
        begin(new ScriptedSteps(1, () -> {}));
        OnEventThread.run(() -> {
            InspectorPanel inspector = new InspectorPanel(look, session);
            session.selection().set(List.of("crate"));
            JTextField x = find(inspector, "property.x");
            assertEquals("4.50", x.getText());
            x.setText("6");
            x.postActionEvent();
            assertEquals(Polygon.rectangle(5.5, 3, 6.5, 4), crate().outline());
            JTextField height = find(inspector, "property.height");
            height.setText("-1");
            height.postActionEvent();
            assertEquals(1, crate().height());
            height.setText("0.8");
            height.postActionEvent();
            assertEquals(0.8, crate().height());
            AbstractButton movable = find(inspector, "property.movable");
            movable.doClick();
            assertTrue(crate().movable());
            JTextField mass = find(inspector, "property.mass");
            assertEquals("20.0", mass.getText());
            assertEquals(
                    List.of("Move crate", "Height of crate", "Movable crate"),
                    session.document().history().names());
        });
    }

    @Test
    void slidersPreviewWhileDraggedAndMakeOneEdit() {
        begin(new ScriptedSteps(1, () -> {}));
        OnEventThread.run(() -> {
            InspectorPanel inspector = new InspectorPanel(look, session);
            JSlider vault = find(inspector, "preference.vault");
            vault.setValueIsAdjusting(true);
            vault.setValue(20);
            vault.setValue(30);
            assertEquals(2.0, preference(Ability.VAULT));
            assertTrue(session.document().isPreviewing());
            vault.setValueIsAdjusting(false);
            assertFalse(session.document().isPreviewing());
            assertEquals(
                    List.of("Preference: vault"), session.document().history().names());
            vault.setValue(vault.getMaximum());
            assertEquals(Preferences.OFF, preference(Ability.VAULT));
            JSlider walk = find(inspector, "preference.walk");
            walk.setValue(walk.getMaximum());
            assertEquals(10, preference(Ability.WALK));
            session.document().history().jump(0);
            assertEquals(0, vault.getValue());
        });
    }

    @Test
    void theWayOfMovingThingsIsEditedBesideThePreferences() {
        begin(new ScriptedSteps(1, () -> {}));
        OnEventThread.run(() -> {
            InspectorPanel inspector = new InspectorPanel(look, session);
            AbstractButton grip = find(inspector, "manipulation.grip");
            assertTrue(grip.isSelected());
            grip.doClick();
            assertEquals(Journey.Manipulation.FREE, journey().manipulation());
            JTextField headings = find(inspector, "manipulation.headings");
            assertEquals("24", headings.getText());
            for (String wrong : List.of("0", "361", "8.5", "many")) {
                headings.setText(wrong);
                headings.postActionEvent();
                assertEquals(24, journey().headings());
            }
            headings.setText("360");
            headings.postActionEvent();
            assertEquals(360, journey().headings());
            assertEquals(
                    List.of("Way of moving things", "Headings of moved things"),
                    session.document().history().names());
            session.document().history().jump(0);
            assertTrue(grip.isSelected());
            assertEquals("24", headings.getText());
        });
    }

    private Journey journey() {
        return (Journey) session.document().shownTask().orElseThrow();
    }

    private double preference(Ability ability) {
        return journey().preferences().of(ability);
    }

    @Test
    void positionsOfASliderReadBack() {
        for (double factor : new double[] {0.1, 0.25, 0.5, 1, 1.5, 2, 5, 10, Preferences.OFF}) {
            assertEquals(factor, PreferencesSection.factor(PreferencesSection.position(factor)), 0.02 * factor);
        }
    }

    @Test
    void theOutlineSelects() {
        begin(new ScriptedSteps(1, () -> {}));
        OnEventThread.run(() -> {
            OutlinePanel outline = new OutlinePanel(look, session, id -> {});
            JList<OutlineRow> list = find(outline, "outline.list");
            List<String> names = new ArrayList<>();
            for (int i = 0; i < list.getModel().getSize(); i++) {
                names.add(list.getModel().getElementAt(i).name());
            }
            assertTrue(
                    names.containsAll(List.of("ann", "crate", "post", "ditch", "there", "back", "None")), "" + names);
            list.setSelectedIndex(names.indexOf("post"));
            assertEquals(List.of("post"), session.selection().ids());
            session.selection().set(List.of("crate"));
            assertEquals("crate", list.getSelectedValue().name());
            list.setSelectedIndex(names.indexOf("back"));
            assertEquals("back", session.document().task());
        });
    }

    @Test
    void longWorkShowsProgressAndCanBeCancelled() {
        CountDownLatch begun = new CountDownLatch(1);
        begin(new ScriptedSteps(1_000, () -> {
            begun.countDown();
            hold();
        }));
        StatusBar status = OnEventThread.get(() -> {
            StatusBar made = new StatusBar(look, session);
            session.planNow();
            return made;
        });
        AbstractButton cancel = find(status, "status.cancel");
        Await.until("cancel is offered", cancel::isVisible);
        JLabel happened = find(status, "status.happened");
        assertEquals("Planning…", OnEventThread.get(happened::getText));
        OnEventThread.run(cancel::doClick);
        goOn.countDown();
        Await.until("it says so", () -> happened.getText().equals("Planning was cancelled"));
        Await.until("nothing is left to cancel", () -> !cancel.isVisible());
    }

    private void hold() {
        try {
            goOn.await(20, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void theStatusTellsHowLongItTook() {
        begin(new ScriptedSteps(1, () -> {}));
        StatusBar status = OnEventThread.get(() -> {
            StatusBar made = new StatusBar(look, session);
            session.planNow();
            return made;
        });
        JLabel happened = find(status, "status.happened");
        Await.until("planned", () -> happened.getText().matches("Planned in \\d+(\\.\\d)? ms"));
    }

    @Test
    void theStatusTellsOfACrowdThatItWasSimulated() {
        begin(new ScriptedSteps(1, () -> {}));
        Crowd crowd = Crowd.of("crowd", List.of());
        Scene with = new Scene("", session.document().scene().world(), List.of(), List.of(), List.of(), List.of(crowd));
        Run run = new Run(with, "crowd", Outcome.FOUND, Report.builder().build(), frames(), List.of(), List.of());
        String text = OnEventThread.get(() -> {
            StatusBar status = new StatusBar(look, session);
            session.show(run);
            return PanelsTest.<JLabel>find(status, "status.happened").getText();
        });
        assertEquals("Simulated in 0.0 s", text);
    }

    private static Frames frames() {
        return new FrameRecorder(25, List.of(new Channel("x", "m", Channel.Type.F64, "crowd", 1))).frames();
    }

    @Test
    void onlyThingsThatAreAlikeShareARowOfTheOutline() {
        begin(new ScriptedSteps(1, () -> {}));
        OnEventThread.run(() -> {
            Scene scene = session.document().scene();
            for (int i = 1; i <= 3; i++) {
                scene = NewElements.with(scene, Scenes.box("planter-" + i, i, 5, 0.5));
                scene = NewElements.with(scene, Scenes.box("obstacle-" + i, i, 1, 0.2 + 0.1 * i));
            }
            session.document().commit("Add", scene);
            List<String> names = OutlineRow.of(session, look).stream()
                    .filter(row -> row.kind() == OutlineRow.Kind.THING)
                    .map(row -> row.name() + " " + row.ids().size())
                    .toList();
            assertTrue(names.contains("Planter 3"), names.toString());
            assertTrue(names.contains("obstacle-2 1"), names.toString());
        });
    }
}
