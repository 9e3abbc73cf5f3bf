package troupe.cli.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.UsageException;
import troupe.exchange.picture.PngFile;
import troupe.paint.Theme;
import troupe.paint.motion.Track;
import troupe.paint.picture.Picture;
import troupe.paint.picture.StripPainter;
import troupe.risk.EncounterViews;
import troupe.run.Run;
import troupe.run.view.Overlay;
import troupe.scene.Encounter;

/** Draws what the actor of an encounter expected at a time of a saved run. */
public final class EncounterPictures {
    /** Which views are drawn. */
    public static final Option SHOW =
            Option.of("--show", "KEYS", "of an encounter: probability, risk, expected-path, plan-before, plan");
    /** How far ahead views look. */
    public static final Option AHEAD =
            Option.of("--ahead", "S", "the seconds beyond --at that probability and risk are shown for");
    /** Where the strip over time goes. */
    public static final Option STRIP =
            Option.of("--strip", "FILE", "of an encounter: how likely the plan meets whom, over time");

    private static final int WIDTH = 900;
    private static final double MOST_AHEAD = 3_600;

    private EncounterPictures() {}

    /** Tells whether such pictures are asked for. */
    public static boolean areMeant(Arguments arguments) {
        return arguments.has(SHOW.name()) || arguments.has(STRIP.name());
    }

    /** Draws the views named by {@code --show} over the run into {@code --png}, and the strip into {@code --strip}. */
    public static void write(Run run, double time, Arguments arguments) throws UsageException, IOException {
        if (!(run.scene().task(run.task()).orElse(null) instanceof Encounter)
                || run.frames().count() == 0) {
            throw new UsageException("--show and --strip show runs of encounters that have frames");
        }
        EncounterViews views = new EncounterViews(run);
        int frame = Track.frameAt(run.frames(), time);
        Optional<String> strip = arguments.value(STRIP.name());
        if (strip.isPresent()) {
            PngFile.write(new StripPainter(views.strip(frame), Theme.LIGHT), WIDTH, Arguments.path(strip.get()));
        }
        if (arguments.has("--png")) {
            List<Overlay> shown = chosen(views, frame, arguments);
            Path file = Arguments.path(arguments.needed("--png", "FILE"));
            PngFile.write(Picture.of(run, time).with(shown), WIDTH, file);
        }
    }

    private static List<Overlay> chosen(EncounterViews views, int frame, Arguments arguments) throws UsageException {
        double ahead = arguments.number(AHEAD.name()).orElse(0.0);
        if (!(ahead >= 0 && ahead <= MOST_AHEAD)) {
            throw new UsageException("--ahead " + ahead + "; needs seconds from 0");
        }
        List<Overlay> all = views.overlays(frame, ahead);
        List<Overlay> shown = new ArrayList<>();
        Optional<String> keys = arguments.value(SHOW.name());
        for (String key : keys.map(k -> Arrays.asList(k.split(","))).orElse(List.of())) {
            shown.add(all.stream()
                    .filter(o -> o.key().equals(key.strip()))
                    .findFirst()
                    .orElseThrow(() -> new UsageException("--show " + key + "; there are "
                            + String.join(", ", all.stream().map(Overlay::key).toList()))));
        }
        return shown;
    }
}
