package troupe.app;

import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.Action;
import troupe.app.canvas.Canvas;
import troupe.app.command.Command;
import troupe.app.command.Commands;
import troupe.app.compare.RunCommands;
import troupe.app.document.Listeners;
import troupe.app.export.ExportDialog;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.play.Playback;
import troupe.app.session.OverlayChoice;
import troupe.app.session.Session;
import troupe.app.solid.SolidMode;
import troupe.app.tool.Editing;
import troupe.app.tool.Hits;
import troupe.app.tool.MeasureTool;
import troupe.app.tool.PanTool;
import troupe.app.tool.Tool;
import troupe.app.tool.draw.DrawAvatarTool;
import troupe.app.tool.draw.DrawBoxTool;
import troupe.app.tool.draw.DrawGroupTool;
import troupe.app.tool.draw.DrawJourneyTool;
import troupe.app.tool.draw.DrawPolygonTool;
import troupe.app.tool.draw.PlaceTool;
import troupe.app.tool.select.SelectTool;
import troupe.exchange.format.ExportSettings;
import troupe.paint.Theme;

/** Makes the one list of everything a person can do in a window, and the tools among it. */
final class StudioCommands implements AutoCloseable {
    private static final double ZOOM = 1.25;

    private final StudioWindow window;
    private final Session session;
    private final Look look;
    private final Canvas canvas;
    private final Commands commands;
    private final Map<Command, Tool> tools = new LinkedHashMap<>();
    private final Listeners<Tool> toolTaken = new Listeners<>();
    private final List<Runnable> leave = new ArrayList<>();

    StudioCommands(StudioWindow window, Look look, Canvas canvas) {
        this.window = window;
        this.session = window.session();
        this.look = look;
        this.canvas = canvas;
        this.commands = new Commands(look.texts());
        addFile();
        addEdit();
        addView();
        addTools();
        ArrangeCommands arrange = new ArrangeCommands(session, look);
        arrange.add(commands);
        leave.add(arrange::close);
        addPlan();
        addRun();
        new HelpCommands(window, look).add(commands);
        take(commands.get("select"));
    }

    /** Returns the list. */
    Commands commands() {
        return commands;
    }

    /** Returns the commands that take a tool in hand. */
    List<Action> tools() {
        return List.copyOf(tools.keySet());
    }

    /** Tells an observer the tool in hand, now and whenever it changes. */
    void onTool(Consumer<Tool> observer) {
        toolTaken.add(observer);
        observer.accept(canvas.tool());
    }

    private void addFile() {
        FileDialogs files = new FileDialogs(window.frame(), session, look);
        commands.add("file", "startpage", window.pages()::showStart);
        commands.add("file", "new", () -> NewSceneDialog.show(window, window.pages()));
        commands.add("file", "open", files::open);
        commands.separate();
        commands.add("file", "save", files::save);
        commands.add("file", "saveas", files::saveAs);
        commands.separate();
        commands.add("file", "import", () -> files.importScene(canvas::fit));
        Command export = commands.add("file", "export", this::export);
        Consumer<Playback> able = now -> export.setEnabled(session.run().isPresent());
        able.accept(session.playback());
        leave.add(session.playback().listeners().add(able));
        leave.add(session.plans().add(plan -> able.accept(session.playback())));
        commands.separate();
        commands.add("file", "quit", window::close);
    }

    /** Asks how the run that is shown is to be written, and writes it. */
    private void export() {
        session.run().ifPresent(run -> {
            Path scene = session.document().file().orElse(Path.of(run.task())).toAbsolutePath();
            String of = session.document().file().isPresent()
                    ? scene.getFileName().toString().replaceFirst("\\.xml$", "") + "-"
                    : "";
            ExportSettings first = ExportSettings.DEFAULT
                    .at(session.playback().time())
                    .in(look.theme())
                    .from(window.eye().angle());
            ExportDialog.show(
                    window.frame(), look, run, first, scene.resolveSibling(of + run.task()), EventQueue::invokeLater);
        });
    }

    private void addEdit() {
        EditCommands edits = new EditCommands(session, look, canvas);
        leave.add(edits::close);
        edits.addHistory(commands);
        edits.addClipboard(commands);
        edits.addSelection(commands);
        commands.add("edit", "search", window::search);
        commands.separate();
        commands.add("edit", "preferences", window::preferences);
    }

    private void addView() {
        commands.add("view", "zoomin", () -> canvas.zoom(ZOOM));
        commands.add("view", "zoomout", () -> canvas.zoom(1 / ZOOM));
        commands.add("view", "fit", canvas::fit);
        commands.separate();
        OverlayChoice overlays = session.overlays();
        commands.addChoice(
                "view", "legend", overlays.shows(OverlayChoice.LEGEND), on -> overlays.show(OverlayChoice.LEGEND, on));
        commands.add("view", "nextpanel", () -> PanelFocus.move(window.frame(), true));
        commands.add("view", "previouspanel", () -> PanelFocus.move(window.frame(), false));
        commands.addChoice("view", "outline", true, window::wantOutline);
        commands.addChoice("view", "inspector", true, window::wantInspector);
        commands.addChoice("view", "timeline", true, window::wantTimeline);
        commands.addChoice("view", "history", window.wantsHistory(), window::wantHistory);
        commands.separate();
        for (SolidMode mode : List.of(SolidMode.INSET, SolidMode.BESIDE, SolidMode.ALONE)) {
            commands.addChoice(
                    "view", "solid." + mode.key(), false, on -> window.wantSolid(on ? mode : SolidMode.HIDDEN));
        }
        commands.separate();
        commands.addChoice(
                "view", "dark", look.theme() == Theme.DARK, on -> window.show(on ? Theme.DARK : Theme.LIGHT));
        commands.addChoice(
                "view",
                "chinese",
                look.texts().locale().equals(Locale.TRADITIONAL_CHINESE),
                on -> window.show(new Texts(on ? Locale.TRADITIONAL_CHINESE : Locale.ENGLISH)));
    }

    private void addTools() {
        Editing editing = new Editing(
                session.document(),
                session.selection(),
                look.scaled(1),
                canvas::view,
                () -> take(commands.get("select")));
        addTool(new SelectTool(editing));
        addTool(new DrawPolygonTool(editing, false));
        addTool(new DrawBoxTool(editing, false));
        addTool(new DrawBoxTool(editing, true));
        addTool(new DrawPolygonTool(editing, true));
        addTool(new DrawJourneyTool(editing, false));
        addTool(new DrawJourneyTool(editing, true));
        addTool(new DrawAvatarTool(editing));
        addTool(new DrawGroupTool(editing));
        addTool(new PlaceTool(editing, Hits.End.START));
        addTool(new PlaceTool(editing, Hits.End.GOAL));
        addTool(new MeasureTool(look));
        addTool(new PanTool((dx, dy) -> canvas.show(canvas.view().panned(dx, dy))));
    }

    private void addTool(Tool tool) {
        Command command = commands.addChoice("scene", tool.key(), false, on -> take(commands.get(tool.key())));
        tools.put(command, tool);
    }

    private void take(Command chosen) {
        Tool tool = tools.get(chosen);
        canvas.take(tool);
        tools.keySet().forEach(command -> command.setOn(command == chosen));
        toolTaken.tell(tool);
    }

    private void addPlan() {
        commands.addChoice("plan", "live", session.isLive(), session::setLive);
        commands.add("plan", "plannow", session::planNow);
        commands.add("plan", "cancel", session.planner()::cancel);
    }

    private void addRun() {
        Playback playback = session.playback();
        Command play = commands.addChoice("run", "play", playback.isPlaying(), on -> playback.toggle());
        commands.add("run", "first", () -> playback.seek(0));
        commands.add("run", "back", () -> playback.step(-1));
        commands.add("run", "forward", () -> playback.step(1));
        commands.separate();
        commands.addChoice("run", "loop", playback.isLooping(), playback::setLooping);
        commands.add("run", "faster", () -> speed(1));
        commands.add("run", "slower", () -> speed(-1));
        commands.separate();
        RunCommands runs = new RunCommands(window.frame(), session, look, EventQueue::invokeLater);
        runs.add(commands, window.pages()::unlessUnsaved);
        leave.add(runs::close);
        leave.add(session.plans().add(plan -> commands.get("live").setOn(session.isLive())));
        Consumer<Playback> show = now -> {
            play.setOn(now.isPlaying());
            play.putValue(
                    Action.LARGE_ICON_KEY,
                    (now.isPlaying() ? troupe.app.look.Icons.PAUSE : troupe.app.look.Icons.PLAY).icon(19));
            for (String id : List.of("play", "first", "back", "forward")) {
                commands.get(id).setEnabled(now.duration() > 0);
            }
        };
        show.accept(playback);
        leave.add(playback.listeners().add(show));
    }

    private void speed(int by) {
        double[] speeds = Playback.speeds();
        int at = 0;
        for (int i = 0; i < speeds.length; i++) {
            at = speeds[i] <= session.playback().speed() ? i : at;
        }
        session.playback().setSpeed(speeds[Math.max(0, Math.min(speeds.length - 1, at + by))]);
    }

    @Override
    public void close() {
        leave.forEach(Runnable::run);
    }
}
