package troupe.exchange.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import troupe.exchange.format.ExchangeException;
import troupe.scene.Journey;
import troupe.scene.Place;

/**
 * Reads MovingAI scenario files: a version line, then one problem a line, {@code bucket map width height
 * startX startY goalX goalY length}, in tabs or blanks, origin top left. At most {@value #MAX_PROBLEMS}
 * problems are taken.
 */
public final class MovingAiProblems {
    /** The most problems that a file may hold. */
    public static final int MAX_PROBLEMS = 500_000;

    private static final int MAX_BYTES = 1 << 26;
    private static final int MAX_SIDE = 1 << 16;
    private static final int COLUMNS = 9;

    private MovingAiProblems() {}

    /**
     * One problem: cells counted from the top left, and the length of a shortest way in cells (straight
     * steps 1, diagonal steps √2), rounded as in the file.
     */
    public record Problem(
            int bucket,
            String map,
            int width,
            int height,
            int startX,
            int startY,
            int goalX,
            int goalY,
            double length) {

        /** Returns the start as a place of the map's scene: metres, y up. */
        public Place start() {
            return Place.of(startX + 0.5, height - startY - 0.5);
        }

        /** Returns the goal as a place of the map's scene: metres, y up. */
        public Place goal() {
            return Place.of(goalX + 0.5, height - goalY - 0.5);
        }

        /** Returns the name of the map without the folder, which often does not exist. */
        public String mapName() {
            return map.substring(Math.max(map.lastIndexOf('/'), map.lastIndexOf('\\')) + 1);
        }

        /** Returns this problem as a task of the map's actor. */
        public Journey journey(String id) {
            return Journey.of(id, MovingAiMap.ACTOR, start(), goal());
        }
    }

    /**
     * Reads a scenario file. Cost O(bytes).
     *
     * @throws ExchangeException if a line is not a problem, or there are too many
     */
    public static List<Problem> read(Path file) throws IOException, ExchangeException {
        try (InputStream in = Files.newInputStream(file)) {
            return read(in, String.valueOf(file.getFileName()));
        }
    }

    /** Reads problems from a stream, which stays open; {@code name} names it in messages. */
    public static List<Problem> read(InputStream in, String name) throws IOException, ExchangeException {
        TextLines lines = TextLines.read(in, name, MAX_BYTES);
        String version = lines.require("'version 1'");
        if (!version.strip().matches("version\\s+1(\\.0*)?")) {
            throw lines.wrong(1, "found " + ExchangeException.quoted(version), "a file begins with 'version 1'");
        }
        List<Problem> problems = new ArrayList<>();
        for (String line = lines.next(); line != null; line = lines.next()) {
            if (line.isBlank()) {
                continue;
            }
            if (problems.size() == MAX_PROBLEMS) {
                throw lines.wrong(0, "more than " + MAX_PROBLEMS + " problems", "split the file");
            }
            problems.add(problem(lines, line.strip()));
        }
        return List.copyOf(problems);
    }

    private static Problem problem(TextLines lines, String line) throws ExchangeException {
        String[] words = line.split(line.indexOf('\t') >= 0 ? "\\s*\t\\s*" : "\\s+", 2 * COLUMNS);
        if (words.length < COLUMNS) {
            throw lines.wrong(
                    0, words.length + " columns", "give 9: bucket map width height startX startY goalX goalY length");
        }
        int last = words.length - 1;
        String map = String.join(" ", Arrays.copyOfRange(words, 1, last - 6));
        int width = lines.whole(words[last - 6], "width", 1, MAX_SIDE);
        int height = lines.whole(words[last - 5], "height", 1, MAX_SIDE);
        return new Problem(
                lines.whole(words[0], "bucket", 0, Integer.MAX_VALUE),
                map,
                width,
                height,
                lines.whole(words[last - 4], "startX", 0, width - 1),
                lines.whole(words[last - 3], "startY", 0, height - 1),
                lines.whole(words[last - 2], "goalX", 0, width - 1),
                lines.whole(words[last - 1], "goalY", 0, height - 1),
                length(lines, words[last]));
    }

    private static double length(TextLines lines, String word) throws ExchangeException {
        if (!word.matches("\\d{1,15}(\\.\\d{0,20})?([eE][-+]?\\d{1,2})?")) {
            throw lines.wrong(0, "length is " + ExchangeException.quoted(word), "give a number from 0");
        }
        return Double.parseDouble(word);
    }
}
