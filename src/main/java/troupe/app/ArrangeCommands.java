package troupe.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BiFunction;
import troupe.app.command.Command;
import troupe.app.command.Commands;
import troupe.app.document.Arranging;
import troupe.app.document.CrowdEdits;
import troupe.app.document.Parts;
import troupe.app.document.SceneDocument;
import troupe.app.document.SceneEdits;
import troupe.app.look.Look;
import troupe.app.session.Session;
import troupe.scene.Crowd;
import troupe.scene.Scene;

/** Adds the commands that align, spread and order what is selected. */
final class ArrangeCommands implements AutoCloseable {
    private final Session session;
    private final Look look;
    private final List<Runnable> leave = new ArrayList<>();

    ArrangeCommands(Session session, Look look) {
        this.session = session;
        this.look = look;
    }

    void add(Commands commands) {
        for (Arranging.Side side : Arranging.Side.values()) {
            String id = "align" + side.name().toLowerCase(Locale.ROOT);
            commands.add("arrange", id, () -> commit("edit.align", (s, ids) -> Arranging.aligned(s, ids, side)));
        }
        commands.separate();
        commands.add("arrange", "spreadx", () -> commit("edit.spread", (s, ids) -> Arranging.spread(s, ids, true)));
        commands.add("arrange", "spready", () -> commit("edit.spread", (s, ids) -> Arranging.spread(s, ids, false)));
        commands.separate();
        for (Arranging.Order order : Arranging.Order.values()) {
            String id = "order" + order.name().toLowerCase(Locale.ROOT);
            commands.add("arrange", id, () -> commit("edit.order", (s, ids) -> Arranging.ordered(s, ids, order)));
        }
        commands.separate();
        Command join = commands.add("arrange", "join", this::join);
        Command part = commands.add("arrange", "part", this::part);
        Runnable able = () -> {
            Scene scene = session.document().scene();
            List<String> ids = session.selection().ids();
            join.setEnabled(CrowdEdits.canJoin(scene, ids));
            part.setEnabled(ids.size() == 1
                    && Parts.group(scene, ids.get(0))
                            .filter(g -> !g.parts().isEmpty())
                            .isPresent());
        };
        able.run();
        leave.add(session.selection().listeners().add(s -> able.run()));
        leave.add(session.document().listeners().add(c -> able.run()));
    }

    /** Makes the groups of a crowd that are selected parts of a new one. */
    private void join() {
        Scene scene = session.document().scene();
        List<String> ids = session.selection().ids();
        Crowd crowd = (Crowd) Parts.task(scene, ids.get(0)).orElseThrow();
        String id = CrowdEdits.freeId(scene, crowd);
        long families = crowd.allGroups().filter(g -> !g.parts().isEmpty()).count();
        String label = look.texts().format("new.family", families + 1);
        session.document()
                .commit(look.texts().format("edit.join", ids.size()), CrowdEdits.joined(scene, ids, id, label));
        session.selection().set(List.of(Parts.id(crowd.id(), id)));
    }

    /** Puts the parts of the group that is selected in its place. */
    private void part() {
        Scene scene = session.document().scene();
        String id = session.selection().ids().get(0);
        session.document()
                .commit(look.texts().format("edit.part", SceneEdits.name(scene, id)), CrowdEdits.parted(scene, id));
    }

    @Override
    public void close() {
        leave.forEach(Runnable::run);
    }

    private void commit(String key, BiFunction<Scene, List<String>, Scene> change) {
        SceneDocument document = session.document();
        List<String> ids = session.selection().ids();
        String what = ids.size() == 1
                ? SceneEdits.name(document.scene(), ids.get(0))
                : look.texts().format("edit.things", ids.size());
        document.commit(look.texts().format(key, what), change.apply(document.scene(), ids));
    }
}
