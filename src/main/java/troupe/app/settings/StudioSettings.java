package troupe.app.settings;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.BinaryOperator;
import java.util.prefs.BackingStoreException;
import java.util.prefs.Preferences;
import troupe.app.look.Texts;
import troupe.app.solid.SolidMode;
import troupe.paint.Theme;

/**
 * Remembers a person's choices from one start to the next: theme, language, scale, live planning, snapping, what
 * is opened first, and which files were opened last.
 */
public final class StudioSettings {
    /** The scales that are offered, in percent. */
    public static final List<Integer> SCALES = List.of(100, 125, 150, 175, 200, 250, 300);

    /** The most files that are remembered. */
    public static final int RECENT = 8;

    private static final String THEME = "theme";
    private static final String LANGUAGE = "language";
    private static final String SCALE = "scale";
    private static final String LIVE = "live";
    private static final String SNAPPING = "snapping";
    private static final String OPENING = "opening";
    private static final String SOLID = "solid";
    private static final String FILES = "recent";
    private static final String TOUR = "tour";
    private static final String RECOVERY = "recovery";

    private final BinaryOperator<String> read;
    private final BiConsumer<String, String> write;

    /** Makes settings over a store: {@code read} is given a key and a default, {@code write} a key and a value. */
    public StudioSettings(BinaryOperator<String> read, BiConsumer<String, String> write) {
        this.read = read;
        this.write = write;
    }

    /** Returns the settings of the person who is logged in; each change is written at once, in the background. */
    public static StudioSettings ofPerson() {
        Preferences node = Preferences.userRoot().node("troupe/app");
        return new StudioSettings(node::get, (key, value) -> {
            node.put(key, value);
            CompletableFuture.runAsync(() -> flush(node));
        });
    }

    private static void flush(Preferences node) {
        try {
            node.flush();
        } catch (BackingStoreException e) {
            // the choice holds until the studio is closed; there is nowhere to keep it
            System.getLogger(StudioSettings.class.getName()).log(System.Logger.Level.DEBUG, "not kept", e);
        }
    }

    /** Returns the theme; the light one if none was chosen. */
    public Theme theme() {
        return read.apply(THEME, Theme.LIGHT.key()).equals(Theme.DARK.key()) ? Theme.DARK : Theme.LIGHT;
    }

    /** Remembers a theme. */
    public void setTheme(Theme theme) {
        write.accept(THEME, theme.key());
    }

    /** Returns the language; that of the system if none was chosen. */
    public Locale language() {
        return Texts.closest(
                Locale.forLanguageTag(read.apply(LANGUAGE, Locale.getDefault().toLanguageTag())));
    }

    /** Remembers a language. */
    public void setLanguage(Locale language) {
        write.accept(LANGUAGE, language.toLanguageTag());
    }

    /** Returns where the view in three dimensions is shown; in the corner if nothing was chosen. */
    public SolidMode solid() {
        return SolidMode.of(read.apply(SOLID, SolidMode.INSET.key()));
    }

    /** Remembers where the view in three dimensions is shown. */
    public void setSolid(SolidMode mode) {
        write.accept(SOLID, mode.key());
    }

    /** Returns how large everything is shown, in percent, one of {@link #SCALES}; 100 if nothing was chosen. */
    public int scale() {
        String kept = read.apply(SCALE, "100");
        return SCALES.stream()
                .filter(s -> String.valueOf(s).equals(kept))
                .findFirst()
                .orElse(100);
    }

    /**
     * Remembers a scale in percent.
     *
     * @throws IllegalArgumentException if it is none of {@link #SCALES}
     */
    public void setScale(int percent) {
        if (!SCALES.contains(percent)) {
            throw new IllegalArgumentException("scale " + percent + "; known are " + SCALES);
        }
        write.accept(SCALE, String.valueOf(percent));
    }

    /** Tells whether a studio plans live when it is opened. */
    public boolean live() {
        return Boolean.parseBoolean(read.apply(LIVE, "true"));
    }

    /** Remembers whether to plan live. */
    public void setLive(boolean on) {
        write.accept(LIVE, String.valueOf(on));
    }

    /** Tells whether drawing and dragging snap. */
    public boolean snapping() {
        return Boolean.parseBoolean(read.apply(SNAPPING, "true"));
    }

    /** Remembers whether to snap. */
    public void setSnapping(boolean on) {
        write.accept(SNAPPING, String.valueOf(on));
    }

    /** Returns what is shown when no file is named. */
    public Opening opening() {
        return Opening.of(read.apply(OPENING, Opening.SAMPLE.key()));
    }

    /** Remembers what to show when no file is named. */
    public void setOpening(Opening opening) {
        write.accept(OPENING, opening.key());
    }

    /** Tells whether the tour was taken, or declined, before. */
    public boolean isTourTaken() {
        return Boolean.parseBoolean(read.apply(TOUR, "false"));
    }

    /** Remembers that the tour was taken or declined. */
    public void setTourTaken() {
        write.accept(TOUR, "true");
    }

    /** Returns the files that were opened or saved, the last first, at most {@value #RECENT}. */
    public List<Path> recent() {
        List<Path> files = new ArrayList<>();
        for (String line : read.apply(FILES, "").split("\n")) {
            try {
                if (!line.isBlank()) {
                    files.add(Path.of(line));
                }
            } catch (InvalidPathException e) {
                // written under another system; there is no such file here
                continue;
            }
        }
        return files;
    }

    /** Returns the folder in which the unsaved edits of documents without a file are kept. */
    public Path recoveryFolder() {
        Path usual = Path.of(System.getProperty("user.home"), ".troupe", "recovery");
        return Path.of(read.apply(RECOVERY, usual.toString()));
    }

    /** Remembers a file as the last one; the oldest beyond {@value #RECENT} are forgotten. */
    public void addRecent(Path file) {
        Path absolute = file.toAbsolutePath().normalize();
        List<Path> files = new ArrayList<>(recent());
        files.remove(absolute);
        files.add(0, absolute);
        keep(files);
    }

    private void keep(List<Path> files) {
        int room = Preferences.MAX_VALUE_LENGTH;
        StringBuilder lines = new StringBuilder();
        for (Path file : files.subList(0, Math.min(RECENT, files.size()))) {
            if (lines.length() + file.toString().length() + 1 <= room) {
                lines.append(file).append('\n');
            }
        }
        write.accept(FILES, lines.toString());
    }
}
