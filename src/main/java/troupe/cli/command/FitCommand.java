package troupe.cli.command;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import troupe.cli.terminal.Arguments;
import troupe.cli.terminal.Command;
import troupe.cli.terminal.ExitCode;
import troupe.cli.terminal.Option;
import troupe.cli.terminal.Terminal;
import troupe.cli.terminal.UsageException;
import troupe.risk.forecast.Blur;
import troupe.risk.study.Calibration;
import troupe.scene.Avatar;
import troupe.scene.Encounter;
import troupe.scene.Encounter.Growth;
import troupe.scene.Encounter.Quantity;
import troupe.scene.xml.SceneException;

/** Fits the blur of predictions to recorded tracks, and tells how well predictions are calibrated. */
public final class FitCommand implements Command {

    @Override
    public String name() {
        return "fit";
    }

    @Override
    public String usage() {
        return "TRACKS.csv [--judge OTHER.csv] [--growth G] [--history N]";
    }

    @Override
    public String summary() {
        return "fit the blur of predictions to recorded tracks, and tell how well they are calibrated";
    }

    @Override
    public List<Option> options() {
        return List.of(
                Option.of("--judge", "OTHER.csv", "judges the fit on other tracks, too"),
                Option.of("--growth", "G", "linear, root or constant; without it linear"),
                Option.of("--history", "N", "earlier positions that a prediction looks at; without it 8"));
    }

    @Override
    public List<String> notes() {
        return List.of(
                "TRACKS.csv holds frame,id,x,y in metres, and a line '# fps=25'. The table tells, for each time ahead,",
                "which share of the true positions lay inside the predicted discs of 50 and 90 percent.");
    }

    @Override
    public int run(Arguments arguments, Terminal terminal) throws UsageException, SceneException, IOException {
        Growth growth = growth(arguments.value("--growth").orElse("linear"));
        int history = arguments.whole("--history", 1, 64).map(Long::intValue).orElse((int) Quantity.HISTORY.usual());
        String file = arguments.only("TRACKS.csv");
        Calibration tracks = calibration(file, history);
        Blur fitted;
        try {
            fitted = tracks.fit(growth);
        } catch (IllegalArgumentException e) {
            terminal.say(file + ": " + e.getMessage());
            return ExitCode.FAILED;
        }
        Blur usual = new Blur(Quantity.SIGMA.usual(), Growth.LINEAR, Avatar.DEFAULT_MOBILITY);
        terminal.out()
                .printf(
                        Locale.ROOT,
                        "fitted to %s: sigma=%.4f m, growth=%s, mobility=%.4f%n",
                        file,
                        fitted.sigma(),
                        word(growth),
                        fitted.mobility());
        table(terminal, file, tracks, usual, fitted);
        Optional<String> other = arguments.value("--judge");
        if (other.isPresent()) {
            table(terminal, other.get(), calibration(other.get(), history), usual, fitted);
        }
        return ExitCode.OK;
    }

    private static Calibration calibration(String file, int history)
            throws UsageException, SceneException, IOException {
        return Calibration.of(EncounterBatches.tracks(Arguments.input(file)), history, Avatar.DEFAULT_SPEED);
    }

    private static String word(Growth growth) {
        return growth.name().toLowerCase(Locale.ROOT);
    }

    private static Growth growth(String word) throws UsageException {
        return Arrays.stream(Encounter.Growth.values())
                .filter(g -> word(g).equals(word))
                .findFirst()
                .orElseThrow(() -> new UsageException("--growth " + word + "; known are linear, root, constant"));
    }

    private static void table(Terminal terminal, String file, Calibration tracks, Blur usual, Blur fitted) {
        List<String> lines = new ArrayList<>();
        lines.add(file + ":");
        lines.add(String.format(
                "%8s %8s %10s | %10s %10s | %10s %10s",
                "ahead s", "cases", "error m", "usual 50%", "usual 90%", "fitted 50%", "fitted 90%"));
        for (double ahead : Calibration.AHEAD) {
            if (tracks.count(ahead) > 0) {
                lines.add(String.format(
                        Locale.ROOT,
                        "%8.1f %8d %10.3f | %10.3f %10.3f | %10.3f %10.3f",
                        ahead,
                        tracks.count(ahead),
                        tracks.median(ahead),
                        tracks.insideHalf(usual, ahead),
                        tracks.insideNineTenths(usual, ahead),
                        tracks.insideHalf(fitted, ahead),
                        tracks.insideNineTenths(fitted, ahead)));
            }
        }
        lines.forEach(terminal.out()::println);
    }
}
