package troupe.app;

import java.util.List;
import java.util.Locale;
import java.util.function.BiFunction;
import troupe.app.command.Commands;
import troupe.app.document.Arranging;
import troupe.app.document.SceneDocument;
import troupe.app.document.SceneEdits;
import troupe.app.look.Look;
import troupe.app.session.Session;
import troupe.scene.Scene;

/** Adds the commands that align, spread and order what is selected. */
final class ArrangeCommands {
    private final Session session;
    private final Look look;

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
