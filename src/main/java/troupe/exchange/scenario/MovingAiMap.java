package troupe.exchange.scenario;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import troupe.exchange.format.ExchangeException;
import troupe.geometry.Polygon;
import troupe.scene.Actor;
import troupe.scene.Obstacle;
import troupe.scene.Place;
import troupe.scene.Scene;
import troupe.scene.World;

/**
 * Holds a MovingAI grid map: free and blocked cells, columns from the left and rows from the
 * <em>top</em>, both from 0. Immutable. Free are {@code . G S}, blocked {@code @ T O W}.
 *
 * <p>Format: N. Sturtevant, Benchmarks for Grid-Based Pathfinding, IEEE TCIAIG 4(2), 2012. At most
 * {@value #MAX_CELLS} cells and {@value #MAX_WALLS} walls are taken.
 */
public final class MovingAiMap {
    /** The most cells that a map may have. */
    public static final int MAX_CELLS = 1 << 24;

    /** The most rectangles that the blocked cells of a map may need. */
    public static final int MAX_WALLS = 200_000;

    /** The id of the actor in the scene of a map. */
    public static final String ACTOR = "walker";

    private static final double WALL_HEIGHT = 3;
    private static final int MAX_SIDE = 1 << 16;

    private final String name;
    private final int width;
    private final int height;
    private final BitSet blocked;

    private MovingAiMap(String name, int width, int height, BitSet blocked) {
        this.name = name;
        this.width = width;
        this.height = height;
        this.blocked = blocked;
    }

    /**
     * Reads a map file. Cost O(cells).
     *
     * @throws ExchangeException if it is not a whole map, or too large
     */
    public static MovingAiMap read(Path file) throws IOException, ExchangeException {
        try (InputStream in = Files.newInputStream(file)) {
            return read(in, String.valueOf(file.getFileName()));
        }
    }

    /** Reads a map from a stream, which stays open; {@code name} names it in messages and in the scene. */
    public static MovingAiMap read(InputStream in, String name) throws IOException, ExchangeException {
        TextLines lines = TextLines.read(in, name, 2 * MAX_CELLS);
        String type = lines.require("'type octile'");
        if (!type.strip().matches("type\\s+\\S+")) {
            throw lines.wrong(1, "this is no map of MovingAI", "a map begins with 'type octile'");
        }
        int width = 0;
        int height = 0;
        for (String line = lines.require("'map'"); !line.strip().equals("map"); line = lines.require("'map'")) {
            String[] words = line.strip().split("\\s+");
            if (words.length == 2 && words[0].equals("width") && width == 0) {
                width = lines.whole(words[1], "width", 1, MAX_SIDE);
            } else if (words.length == 2 && words[0].equals("height") && height == 0) {
                height = lines.whole(words[1], "height", 1, MAX_SIDE);
            } else {
                throw lines.wrong(1, "the line does not belong here", "give one 'height N', one 'width N', then 'map'");
            }
        }
        if (width == 0 || height == 0 || (long) width * height > MAX_CELLS) {
            throw lines.wrong(
                    0,
                    "a map of " + width + " x " + height + " cells",
                    "give width and height with at most " + MAX_CELLS + " cells in all");
        }
        return new MovingAiMap(name, width, height, cells(lines, width, height));
    }

    private static BitSet cells(TextLines lines, int width, int height) throws ExchangeException {
        BitSet blocked = new BitSet(width * height);
        for (int y = 0; y < height; y++) {
            String row = lines.require("row " + (y + 1) + " of " + height);
            if (row.length() != width) {
                throw lines.wrong(0, "a row of " + row.length() + " cells", "give " + width + ", as the width says");
            }
            for (int x = 0; x < width; x++) {
                switch (row.charAt(x)) {
                    case '.', 'G', 'S' -> {}
                    case '@', 'T', 'O', 'W' -> blocked.set(y * width + x);
                    default ->
                        throw lines.wrong(
                                x + 1,
                                "found " + ExchangeException.quoted(row.substring(x, x + 1)),
                                "a cell is one of . G S (free) @ T O W (blocked)");
                }
            }
        }
        for (String rest = lines.next(); rest != null; rest = lines.next()) {
            if (!rest.isBlank()) {
                throw lines.wrong(1, "the line does not belong here", "end the map after " + height + " rows");
            }
        }
        return blocked;
    }

    /** Returns the name it was read under. */
    public String name() {
        return name;
    }

    /** Returns the number of columns. */
    public int width() {
        return width;
    }

    /** Returns the number of rows. */
    public int height() {
        return height;
    }

    /**
     * Tells whether the cell in column {@code x} and row {@code y} from the top is blocked.
     *
     * @throws IllegalArgumentException outside the map
     */
    public boolean blocked(int x, int y) {
        return blocked.get(index(x, y));
    }

    /** Returns the centre of a cell as a place of {@link #scene()}. */
    public Place place(int x, int y) {
        index(x, y);
        return Place.of(x + 0.5, height - y - 0.5);
    }

    private int index(int x, int y) {
        if (x < 0 || y < 0 || x >= width || y >= height) {
            throw new IllegalArgumentException("cell " + x + "," + y + "; the map has columns 0 to " + (width - 1)
                    + ", rows 0 to " + (height - 1));
        }
        return y * width + x;
    }

    /**
     * Makes the scene of the map: cells of one metre, blocked cells joined to rectangular walls of three
     * metres, and one actor {@value #ACTOR} that only walks, with radius and foot radius 0, so that the
     * free cells of the grid are exactly those of the map. Row 0 lies at the top, y up. Cost O(cells).
     *
     * @throws ExchangeException if there are more than {@value #MAX_WALLS} walls
     */
    public Scene scene() throws ExchangeException {
        List<Obstacle> walls = new ArrayList<>();
        BitSet left = (BitSet) blocked.clone();
        for (int i = left.nextSetBit(0); i >= 0; i = left.nextSetBit(i)) {
            if (walls.size() == MAX_WALLS) {
                throw new ExchangeException(
                        name, 0, 0, "needs more than " + MAX_WALLS + " rectangular walls", "give a part of the map");
            }
            walls.add(takeWall(left, i, "wall-" + (walls.size() + 1)));
        }
        return new Scene(
                name, new World(width, height, 1), walls, List.of(), List.of(Actor.walker(ACTOR, 0, 0)), List.of());
    }

    /** Takes from {@code left} the widest run at cell {@code i}, extended down as far as whole runs go. */
    private Obstacle takeWall(BitSet left, int i, String id) {
        int top = i / width;
        int begin = i % width;
        int end = Math.min(left.nextClearBit(i) - top * width, width);
        int bottom = top;
        while (bottom < height && left.nextClearBit(bottom * width + begin) >= bottom * width + end) {
            left.clear(bottom * width + begin, bottom * width + end);
            bottom++;
        }
        Polygon outline = Polygon.rectangle(begin, height - bottom, end, height - top);
        return new Obstacle(id, "", outline, 0, WALL_HEIGHT, false, Obstacle.DEFAULT_MASS, "");
    }
}
