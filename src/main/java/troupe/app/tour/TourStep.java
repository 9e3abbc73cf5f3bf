package troupe.app.tour;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import troupe.app.document.SceneDocument;
import troupe.app.document.Version;
import troupe.app.plan.Plan;
import troupe.app.session.Session;
import troupe.geometry.Polygon;
import troupe.run.Run;
import troupe.scene.Ability;
import troupe.scene.Journey;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/**
 * One thing to do on the tour.
 *
 * @param key the word for it in the texts
 * @param parts the names of what it happens at, the first that is to be seen is marked; may be empty
 * @param element the thing of the scene that is marked instead, empty for none
 * @param command the command whose shortcut the text names, empty for none
 * @param check whether it was done
 */
record TourStep(String key, List<String> parts, String element, String command, Check check) {

    /** Tells whether what a step asks for was done. */
    interface Check {
        /** Looks at what has changed since the step began; {@code shows} tells whether a part of a name is to be seen. */
        boolean isDone(Begun begun, Session now, Predicate<String> shows);
    }

    /** What there was when a step began. */
    record Begun(Scene scene, Version version, Optional<Run> run, Set<String> views, double time) {
        static Begun of(Session session) {
            return new Begun(
                    session.document().scene(),
                    session.document().version(),
                    session.run(),
                    session.overlays().keys(),
                    session.playback().time());
        }
    }

    /** What the tour is about: the thing that bars the door of the courtyard. */
    static final String CRATE = "crate";

    /** Lists the steps. */
    static List<TourStep> all() {
        Check nothing = (begun, now, shows) -> true;
        return List.of(
                new TourStep("welcome", List.of(), "", "", nothing),
                new TourStep(
                        "crate",
                        List.of(),
                        CRATE,
                        "",
                        (begun, now, shows) -> isPlanned(begun, now)
                                && !outline(begun.scene())
                                        .equals(outline(now.document().scene()))),
                new TourStep(
                        "why",
                        List.of("preference.vault"),
                        "",
                        "",
                        (begun, now, shows) ->
                                isPlanned(begun, now) && vault(now.document().scene()) > vault(begun.scene())),
                new TourStep(
                        "undo",
                        List.of("menu.edit"),
                        "",
                        "undo",
                        (begun, now, shows) -> isChanged(begun, now)
                                && now.document().history().redoAction().isEnabled()),
                new TourStep(
                        "views", List.of("chip.potential", "chip.more"), "", "", (begun, now, shows) -> !now.overlays()
                                .keys()
                                .equals(begun.views())),
                new TourStep(
                        "play",
                        List.of("timeline.view"),
                        "",
                        "play",
                        (begun, now, shows) -> now.playback().time() != begun.time()),
                new TourStep(
                        "draw",
                        List.of("tool.rectangle"),
                        "",
                        "rectangle",
                        (begun, now, shows) ->
                                count(now) > begun.scene().obstacles().size()),
                new TourStep(
                        "height",
                        List.of("property.height"),
                        "",
                        "",
                        (begun, now, shows) ->
                                isHeightChanged(begun.scene(), now.document().scene())),
                new TourStep(
                        "search", List.of("top.search"), "", "search", (begun, now, shows) -> shows.test("search")),
                new TourStep("end", List.of("menu.help"), "", "", nothing));
    }

    /** Tells whether it only shows something, and there is nothing to be done. */
    boolean isShown() {
        return key.equals("welcome") || key.equals("end");
    }

    private static boolean isChanged(Begun begun, Session now) {
        SceneDocument document = now.document();
        return !document.isPreviewing() && !document.version().equals(begun.version());
    }

    /** Tells whether the scene was changed, and what is shown is the plan of the changed one. */
    private static boolean isPlanned(Begun begun, Session now) {
        return isChanged(begun, now)
                && now.plan()
                        .map(Plan::snapshot)
                        .filter(s -> s.version().equals(now.document().version()))
                        .isPresent();
    }

    private static Optional<Polygon> outline(Scene scene) {
        return scene.obstacle(CRATE).map(Obstacle::outline);
    }

    private static double vault(Scene scene) {
        return scene.tasks().stream()
                .filter(Journey.class::isInstance)
                .mapToDouble(t -> ((Journey) t).preferences().of(Ability.VAULT))
                .sum();
    }

    private static int count(Session now) {
        return now.document().scene().obstacles().size();
    }

    private static boolean isHeightChanged(Scene before, Scene after) {
        return after.obstacles().stream().anyMatch(o -> before.obstacle(o.id())
                .filter(b -> b.height() != o.height())
                .isPresent());
    }
}
