package troupe.app.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import troupe.app.Scenes;
import troupe.app.document.Version;
import troupe.app.look.Texts;
import troupe.app.plan.Plan;
import troupe.app.plan.Snapshot;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.FrameRecorder;
import troupe.run.frame.Frames;
import troupe.scene.Scene;
import troupe.scene.check.Problem;
import troupe.scene.check.Severity;
import troupe.scene.setting.Settings;
import troupe.scene.xml.SceneException;
import troupe.scene.xml.SceneXml;
import troupe.search.Outcome;
import troupe.work.Tasks;
import troupe.work.explain.Explainer;
import troupe.work.explain.Explanation;

class PlanWordsTest {
    private static Explanation explain(String file, String task) throws SceneException, IOException {
        return explain(SceneXml.read(Path.of("scenes", "unified", file)).scene(), task);
    }

    private static Explanation explainWithoutMoving(String file, String task) throws SceneException, IOException {
        Scene scene = SceneXml.read(Path.of("scenes", "unified", file)).scene();
        return explain(Settings.apply(scene, task, "preference.move", "off"), task);
    }

    private static Explanation explain(Scene scene, String task) {
        Explainer explainer =
                new Explainer((other, id) -> Tasks.start(other, id).finish());
        return explainer.explain(Tasks.start(scene, task).finish());
    }

    @Test
    void saysWhenAnActorWouldWalkRound() throws SceneException, IOException {
        Explanation crate = explainWithoutMoving("three-ways.xml", "past-the-crate");
        assertEquals(
                "If vaulting cost 1.37 times as much, Kit would walk round.",
                PlanWords.flips(crate, new Texts(Locale.ENGLISH)));
        assertEquals("若翻越的代價變為 1.37 倍，Kit 就會繞道行走。", PlanWords.flips(crate, new Texts(Locale.TRADITIONAL_CHINESE)));
    }

    @Test
    void saysWhenAnActorWouldNotMoveAThing() throws SceneException, IOException {
        Scene scene =
                SceneXml.read(Path.of("scenes", "unified", "three-ways.xml")).scene();
        Explanation crate = explain(scene, "past-the-crate");
        assertEquals(
                "If moving things cost 2.3 times as much, Kit would vault instead.",
                PlanWords.flips(crate, new Texts(Locale.ENGLISH)));
        assertEquals("若搬移物件的代價變為 2.3 倍，Kit 就會改為翻越。", PlanWords.flips(crate, new Texts(Locale.TRADITIONAL_CHINESE)));
    }

    @Test
    void saysWhatAnActorWouldDoInstead() throws SceneException, IOException {
        Explanation apartment = explainWithoutMoving("apartment.xml", "kitchen-to-bedroom");
        String actor = apartment.plan().run().scene().actors().get(0).name();
        assertEquals(
                "If sidestepping cost 5.1 times as much, " + actor + " would vault instead.",
                PlanWords.flips(apartment, new Texts(Locale.ENGLISH)));
        assertEquals(
                "若側行的代價變為 5.1 倍，" + actor + " 就會改為翻越。",
                PlanWords.flips(apartment, new Texts(Locale.TRADITIONAL_CHINESE)));
    }

    @Test
    void namesTheElementTheMistakeAndItsCure() {
        Problem twisted = new Problem(Severity.ERROR, "crate", 0, "is twisted", "untwist it");
        Problem twice = new Problem(Severity.ERROR, "ann", 0, "is there twice", "rename one");
        Problem mild = new Problem(Severity.WARNING, "ann", 0, "is slow", "");
        Snapshot snapshot = new Snapshot(new Version(1, 0), Scenes.room(), "there");
        Plan plan = new Plan(snapshot, Optional.empty(), List.of(twisted, twice, mild), 1);
        assertEquals(2, PlanWords.errors(plan));
        assertEquals(
                "Not planned, errors: 2. First: 'crate' is twisted; untwist it",
                PlanWords.firstError(plan, new Texts(Locale.ENGLISH)));
        assertEquals(
                "未規劃，共 2 個錯誤，首項：「crate」is twisted；untwist it",
                PlanWords.firstError(plan, new Texts(Locale.TRADITIONAL_CHINESE)));
        assertEquals(
                "'crate' is twisted; untwist it\n\n'ann' is there twice; rename one",
                PlanWords.allErrors(plan, new Texts(Locale.ENGLISH)));
    }

    @Test
    void aReasonFollowsALeadInThePersonsLanguage() {
        Outcome outcome = new Outcome.Infeasible("the goal is in 'Wall'");
        assertEquals("The goal is in 'Wall'", PlanWords.outcome(outcome, new Texts(Locale.ENGLISH)));
        Texts chinese = new Texts(Locale.TRADITIONAL_CHINESE);
        assertEquals("無路可走。The goal is in 'Wall'", PlanWords.outcome(outcome, chinese));
        Outcome known = new Outcome.Infeasible("no path: the start (1.00, 2.00) lies in 'Wall'");
        assertEquals("無路可走。起點 (1.00, 2.00)位於「Wall」之內", PlanWords.outcome(known, chinese));
    }

    @Test
    void saysWhatIsMovedAndHowFar() {
        Report.Builder crate = Report.builder().put("id", "crate").put("length", 1.26);
        Report.Builder post = Report.builder().put("id", "post").put("length", 0.5);
        Report report = Report.builder()
                .put("moved", List.of(crate.build(), post.build()))
                .build();
        Frames none = new FrameRecorder(25, List.of()).frames();
        Run run = new Run(Scenes.room(), "there", Outcome.FOUND, report, none, List.of(), List.of());
        assertEquals("Moves crate over 1.3 m, then post over 0.5 m.", PlanWords.moves(run, new Texts(Locale.ENGLISH)));
        assertEquals("搬移crate（1.3 公尺），再搬移post（0.5 公尺）。", PlanWords.moves(run, new Texts(Locale.TRADITIONAL_CHINESE)));
    }

    @Test
    void saysHowAnEncounterEnded() throws SceneException, IOException {
        Scene scene = SceneXml.read(Path.of("scenes/risk/crossing.xml")).scene();
        FrameRecorder frames = new FrameRecorder(2, List.of());
        for (int k = 0; k <= 5; k++) {
            frames.append(new double[0]);
        }
        Texts english = new Texts(Locale.ENGLISH);
        Report.Builder report = Report.builder().put("collisions", 0L).put("smallest_gap", 0.204);
        assertEquals(
                List.of("Arrived after 2.5 s", "nearest gap 0.20 m", "no contact"),
                PlanWords.encounter(ended(scene, Outcome.FOUND, report, frames), english));
        Report.Builder struck = Report.builder().put("collisions", 2L).put("smallest_gap", -0.01);
        assertEquals(
                List.of("Gave up after 2.5 s", "contacts: 2"),
                PlanWords.encounter(ended(scene, Outcome.EXHAUSTED, struck, frames), english));
        assertEquals(
                List.of("抵達，歷時 2.5 秒"),
                PlanWords.encounter(
                        ended(scene, Outcome.FOUND, Report.builder(), frames), new Texts(Locale.TRADITIONAL_CHINESE)));
        Outcome none = new Outcome.Infeasible("no way");
        assertEquals(List.of(), PlanWords.encounter(ended(scene, none, report, frames), english));
    }

    private static Run ended(Scene scene, Outcome outcome, Report.Builder report, FrameRecorder frames) {
        return new Run(scene, "cross", outcome, report.build(), frames.frames(), List.of(), List.of());
    }

    @Test
    void saysNothingOfWalking() throws SceneException, IOException {
        assertEquals(
                "", PlanWords.flips(explainWithoutMoving("two-ways.xml", "to-the-hall"), new Texts(Locale.ENGLISH)));
    }
}
