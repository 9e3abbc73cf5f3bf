package troupe.exchange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.StreamExporter;
import troupe.exchange.picture.GifExport;
import troupe.exchange.picture.ImageExport;
import troupe.exchange.picture.ImagesExport;
import troupe.exchange.picture.SvgExport;
import troupe.exchange.track.CsvExport;
import troupe.paint.Sketch;
import troupe.run.Run;
import troupe.scene.Obstacle;
import troupe.scene.Scene;

/** Exports a run in which a crate is moved from 7 s to 9 s, and looks for the crate where it is at each time. */
class MovedExportTest {
    private static final ExportSettings SETTINGS = ExportSettings.DEFAULT.wide(500);

    /** The margin of a picture, and pixels for a metre of the sketch, which is 18 m wide. */
    private static final double MARGIN = 14;

    private static final double SCALE = (500 - 2 * MARGIN) / 18;

    @TempDir
    Path folder;

    private static byte[] bytes(StreamExporter exporter, Run run, ExportSettings settings)
            throws IOException, ExchangeException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        exporter.write(run, settings, out);
        return out.toByteArray();
    }

    /** Tells whether most of the pixels around a place are of solid wood. */
    private static boolean wood(BufferedImage image, double x, double y) {
        int column = (int) (MARGIN + x * SCALE);
        int row = (int) (MARGIN + (13 - y) * SCALE);
        int wood = 0;
        for (int k = 0; k < 25; k++) {
            Color c = new Color(image.getRGB(column + k % 5 - 2, row + k / 5 - 2));
            wood += c.getRed() < 195 && c.getRed() - c.getBlue() > 65 ? 1 : 0;
        }
        return wood > 15;
    }

    private static void assertCrate(BufferedImage image, boolean left) {
        assertEquals(!left, wood(image, 8.45, 7.15), "the crate at its first place");
        assertEquals(left, wood(image, 10.25, 8.5), "the crate at its last place");
    }

    @Test
    void csvHoldsARowForTheCrateInEachFrame() throws Exception {
        String text = new String(bytes(new CsvExport(), Sketch.haul(), SETTINGS), StandardCharsets.UTF_8);
        List<String> rows =
                text.lines().filter(line -> line.contains(",crate,")).toList();
        assertEquals(251, rows.size());
        assertEquals("0,0.000000,crate,8.150000,7.500000,0.000000,0.000000,", rows.get(0));
        assertEquals("200,8.000000,crate,9.200000,7.850000,0.000000,34.377468,", rows.get(200));
        assertEquals("250,10.000000,crate,10.250000,8.200000,0.000000,68.754935,", rows.get(250));
        assertEquals(251, text.lines().filter(line -> line.contains(",ann,")).count());
    }

    @Test
    void csvTellsTheElevationOfTheBottomOfTheCrate() throws Exception {
        Run run = Sketch.haul();
        Obstacle crate = run.scene().obstacle("crate").orElseThrow();
        Scene scene = run.scene()
                .with(new Obstacle("crate", "", crate.outline(), 0.75, 1, true, crate.mass(), crate.colour()));
        Run high = new Run(scene, run.task(), run.outcome(), run.report(), run.frames(), run.legs(), List.of());
        String text = new String(bytes(new CsvExport(), high, SETTINGS), StandardCharsets.UTF_8);
        assertTrue(text.contains("\n0,0.000000,crate,8.150000,7.500000,0.750000,0.000000,\n"), text.substring(0, 200));
    }

    @Test
    void pngShowsTheCrateWhereItIsAtTheTime() throws Exception {
        for (double time : new double[] {0, 6.9, 9, 1000}) {
            byte[] png = bytes(new ImageExport(), Sketch.haul(), SETTINGS.at(time));
            assertCrate(ImageIO.read(new ByteArrayInputStream(png)), time >= 9);
        }
    }

    @Test
    void numberedPicturesShowTheCrateWhereItIs() throws Exception {
        new ImagesExport().write(Sketch.haul(), SETTINGS.every(0.5), folder.resolve("film.png"));
        for (int k = 0; k <= 5; k++) {
            BufferedImage image =
                    ImageIO.read(folder.resolve("film-0000" + k + ".png").toFile());
            if (k != 4) {
                assertCrate(image, k == 5);
            } else {
                assertFalse(wood(image, 8.45, 7.15), "at 8 s it is under way");
                assertFalse(wood(image, 10.25, 8.5));
            }
        }
    }

    @Test
    void gifBeginsWithTheCrateAtItsFirstPlaceAndEndsWithItAtItsLast() throws Exception {
        byte[] gif = bytes(new GifExport(), Sketch.haul(), SETTINGS.every(0.5));
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(new ByteArrayInputStream(gif))) {
            reader.setInput(in);
            int count = reader.getNumImages(true);
            BufferedImage first = reader.read(0);
            BufferedImage canvas = new BufferedImage(first.getWidth(), first.getHeight(), BufferedImage.TYPE_INT_RGB);
            for (int k = 0; k < count; k++) {
                var descriptor = (org.w3c.dom.Element)
                        ((org.w3c.dom.Element) reader.getImageMetadata(k).getAsTree("javax_imageio_gif_image_1.0"))
                                .getElementsByTagName("ImageDescriptor")
                                .item(0);
                canvas.getGraphics()
                        .drawImage(
                                reader.read(k),
                                Integer.parseInt(descriptor.getAttribute("imageLeftPosition")),
                                Integer.parseInt(descriptor.getAttribute("imageTopPosition")),
                                null);
                if (k == 0) {
                    assertCrate(canvas, false);
                }
            }
            assertCrate(canvas, true);
        } finally {
            reader.dispose();
        }
    }

    @Test
    void svgHoldsTheCrateOnceAtItsTime() throws Exception {
        String before = new String(bytes(new SvgExport(), Sketch.haul(), SETTINGS), StandardCharsets.UTF_8);
        String after = new String(bytes(new SvgExport(), Sketch.haul(), SETTINGS.at(10)), StandardCharsets.UTF_8);
        List<String> first = wooden(before);
        List<String> last = wooden(after);
        assertEquals(1, first.size(), "the one movable obstacle");
        assertEquals(1, last.size());
        assertFalse(first.equals(last), "it has not moved");
    }

    /** Returns the paths that are filled with solid wood. */
    private static List<String> wooden(String svg) {
        return svg.lines()
                .filter(line -> line.contains("fill=\"#b4783c\"") && !line.contains("fill-opacity"))
                .toList();
    }
}
