package troupe.paint;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.stream.LongStream;
import javax.imageio.ImageIO;

/**
 * Compares pictures with stored ones. They are painted without text, since fonts differ between machines, and may
 * differ a little, since smoothing differs between versions of Java. With {@code -Dtroupe.pictures=record} they are
 * stored anew after an intended change; look at them then.
 */
public final class StoredPictures {
    /** A channel that differs by more levels than this, of 255, counts as another colour. */
    private static final int PLAIN = 60;

    /** One pixel in so many may be plainly another colour. */
    private static final int RARE = 2_000;

    /** The side in pixels of the squares that are compared one by one, so that small things count as well. */
    private static final int SQUARE = 8;

    /** How many levels of 255 the channels of a square may differ by, on the mean. */
    private static final double LOCAL = 6;

    private static final File FOLDER = new File("src/test/resources/pictures");

    private StoredPictures() {}

    /** Fails unless a picture looks like the one stored under a name; leaves it in {@code target/pictures} then. */
    public static void assertLooksLike(String name, BufferedImage now) throws IOException {
        File file = new File(FOLDER, name + ".png");
        if ("record".equals(System.getProperty("troupe.pictures"))) {
            FOLDER.mkdirs();
            ImageIO.write(now, "png", file);
        }
        assertTrue(file.isFile(), "no stored picture " + file);
        double difference = difference(ImageIO.read(file), now);
        File actual = new File("target/pictures/" + name + ".png");
        if (difference > 1) {
            actual.getParentFile().mkdirs();
            ImageIO.write(now, "png", actual);
        }
        assertTrue(difference <= 1, "differs by " + difference + ", see " + actual);
    }

    /**
     * Returns how far two pictures are apart: 0 if equal, above 1 if the mean difference of a channel exceeds one
     * level, or six levels in a square of eight by eight pixels, or if one pixel in two thousand is plainly another
     * colour.
     */
    public static double difference(BufferedImage a, BufferedImage b) {
        if (a.getWidth() != b.getWidth() || a.getHeight() != b.getHeight()) {
            return Double.POSITIVE_INFINITY;
        }
        int across = a.getWidth() / SQUARE + 1;
        long[] squares = new long[across * (a.getHeight() / SQUARE + 1)];
        int plain = 0;
        for (int y = 0; y < a.getHeight(); y++) {
            for (int x = 0; x < a.getWidth(); x++) {
                int most = 0;
                for (int shift = 0; shift <= 16; shift += 8) {
                    int apart = Math.abs((a.getRGB(x, y) >> shift & 255) - (b.getRGB(x, y) >> shift & 255));
                    squares[y / SQUARE * across + x / SQUARE] += apart;
                    most = Math.max(most, apart);
                }
                plain += most > PLAIN ? 1 : 0;
            }
        }
        double pixels = a.getWidth() * (double) a.getHeight();
        double mean = LongStream.of(squares).sum() / (3 * pixels);
        double worst = LongStream.of(squares).max().orElseThrow() / (3.0 * SQUARE * SQUARE);
        return Math.max(Math.max(mean, worst / LOCAL), plain / pixels * RARE);
    }
}
