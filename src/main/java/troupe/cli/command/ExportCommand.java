package troupe.cli.command;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import troupe.cli.report.Pictures;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.exchange.Formats;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.Exporter;
import troupe.paint.Theme;
import troupe.run.Run;
import troupe.run.file.RunException;
import troupe.run.file.RunFile;
import troupe.run.view.Overlay;
import troupe.work.view.Fields;

/** Writes a saved run in another format. */
public final class ExportCommand implements Command {

    @Override
    public String name() {
        return "export";
    }

    @Override
    public String usage() {
        return "FILE.run --format F -o FILE [--at T] [--width N] [--rate N] [--show A,B] [--view solid] [--dark]";
    }

    @Override
    public String summary() {
        return "write a saved run in another format";
    }

    @Override
    public List<Option> options() {
        return List.of(
                Option.of("--format", "F", "the format, see below; without it the one that FILE's ending names"),
                Option.of("-o", "FILE", "where to write, - for standard output"),
                Option.of("--at", "T", "the time in seconds of a single picture; without it the end"),
                Option.of("--width", "N", "width of a picture in pixels"),
                Option.of("--rate", "N", "pictures for each second of an animation"),
                Option.of("--show", "A,B,C", "views to lay over the scene in pictures, as in troupe fields"),
                Pictures.VIEW,
                Pictures.TURN,
                Option.flag("--dark", "pictures in the dark theme"));
    }

    @Override
    public List<String> notes() {
        List<String> lines = new ArrayList<>();
        for (Exporter exporter : Formats.exporters()) {
            lines.add(exporter.name() + ": " + exporter.about());
        }
        return lines;
    }

    @Override
    public int run(Arguments arguments, Terminal terminal)
            throws UsageException, RunException, ExchangeException, IOException {
        String target = arguments.needed("-o", "FILE");
        Exporter exporter = exporter(arguments, target);
        try (InputFile file = InputFile.of(arguments.only("FILE.run"), terminal)) {
            export(RunFile.read(file.path()), exporter, target, arguments, terminal);
        }
        return ExitCode.OK;
    }

    private static void export(Run run, Exporter exporter, String target, Arguments arguments, Terminal terminal)
            throws UsageException, ExchangeException, IOException {
        ExportSettings settled = settings(run, arguments).until(terminal.interrupted());
        Pictures.export(exporter, run, settled.with(views(run, arguments, terminal)), target, terminal);
    }

    private static Exporter exporter(Arguments arguments, String target) throws UsageException {
        Optional<String> format = arguments.value("--format");
        try {
            if (format.isPresent()) {
                return Formats.exporter(format.get());
            }
        } catch (IllegalArgumentException e) {
            throw new UsageException(e.getMessage(), e);
        }
        return Formats.exporterFor(Arguments.path(target))
                .orElseThrow(() -> new UsageException("needs --format; there are "
                        + String.join(
                                ", ",
                                Formats.exporters().stream().map(Exporter::name).toList())));
    }

    private static List<Overlay> views(Run run, Arguments arguments, Terminal terminal)
            throws UsageException, IOException {
        if (!arguments.has("--show")) {
            return List.of();
        }
        return Fields.of(run.scene(), run.task(), FieldsCommand.keys(arguments), Map.of(), terminal.interrupted())
                .overlays()
                .stream()
                .flatMap(List::stream)
                .toList();
    }

    private static ExportSettings settings(Run run, Arguments arguments) throws UsageException {
        ExportSettings settings = ExportSettings.DEFAULT.at(run.frames().duration());
        try {
            Optional<Double> at = arguments.number("--at");
            Optional<Long> width = arguments.whole("--width", 1, Integer.MAX_VALUE);
            Optional<Double> rate = arguments.number("--rate");
            settings = at.isPresent() ? settings.at(at.get()) : settings;
            settings = width.isPresent() ? settings.wide(width.get().intValue()) : settings;
            settings = rate.isPresent() ? settings.every(rate.get()) : settings;
        } catch (IllegalArgumentException e) {
            throw new UsageException(e.getMessage(), e);
        }
        settings = Pictures.seen(settings, arguments);
        return arguments.has("--dark") ? settings.in(Theme.DARK) : settings;
    }
}
