package troupe.exchange;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageInputStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.StreamExporter;
import troupe.exchange.picture.GifExport;
import troupe.exchange.picture.Palette;
import troupe.exchange.picture.SvgExport;
import troupe.exchange.picture.SvgGraphics;
import troupe.exchange.track.CsvExport;
import troupe.paint.Sketch;
import troupe.paint.Theme;
import troupe.paint.picture.Picture;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.run.frame.Frames;
import troupe.scene.xml.AtomicFile;
import troupe.search.Outcome;

/** Writes a run in every format and reads it back. */
class ExportTest {
    private static final ExportSettings SMALL = ExportSettings.DEFAULT.wide(240);

    @TempDir
    Path folder;

    private static byte[] bytes(StreamExporter exporter, Run run, ExportSettings settings)
            throws IOException, ExchangeException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        exporter.write(run, settings, out);
        return out.toByteArray();
    }

    /** Returns a run of one actor whose x, y and heading in each frame are given. */
    private static Run run(double[]... rows) {
        List<Channel> channels = List.of(
                new Channel("x", "m", Channel.Type.F64, "ann", 1),
                new Channel("y", "m", Channel.Type.F64, "ann", 1),
                new Channel("heading", "rad", Channel.Type.F64, "ann", 1));
        Frames frames = new Frames() {
            @Override
            public List<Channel> channels() {
                return channels;
            }

            @Override
            public double rate() {
                return 25;
            }

            @Override
            public int count() {
                return rows.length;
            }

            @Override
            public double value(int frame, int channel, int k) {
                return rows[frame][channel];
            }
        };
        Run sketch = Sketch.run();
        return new Run(sketch.scene(), sketch.task(), Outcome.FOUND, sketch.report(), frames, sketch.legs(), List.of());
    }

    @Test
    void csvHoldsARowForEachFrame() throws Exception {
        Run run = run(new double[] {1, 2.5, 0}, new double[] {-1e-9, 1.0 / 3, -Math.PI / 2}, new double[] {1e7, 0, 7});
        assertEquals(
                "frame,time,id,x,y,z,heading,ability\n"
                        + "0,0.000000,ann,1.000000,2.500000,0.000000,0.000000,\n"
                        + "1,0.040000,ann,0.000000,0.333333,0.000000,-90.000000,\n"
                        + "2,0.080000,ann,10000000.000000,0.000000,0.000000,41.070457,\n",
                new String(bytes(new CsvExport(), run, SMALL), StandardCharsets.UTF_8));
    }

    @Test
    void textIsTheSameInAnyLocale() throws Exception {
        Locale before = Locale.getDefault();
        byte[] csv = bytes(new CsvExport(), Sketch.run(), SMALL);
        byte[] svg = bytes(new SvgExport(), Sketch.run(), SMALL);
        try {
            for (String tag : List.of("de-DE", "ar-EG-u-nu-arab", "hi-IN-u-nu-deva")) {
                Locale.setDefault(Locale.forLanguageTag(tag));
                assertArrayEquals(csv, bytes(new CsvExport(), Sketch.run(), SMALL), tag);
                assertArrayEquals(svg, bytes(new SvgExport(), Sketch.run(), SMALL), tag);
            }
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void csvRefusesWhatIsNotANumberAndLeavesTheOldFile() throws Exception {
        Path target = folder.resolve("run.csv");
        Files.writeString(target, "old");
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
            Run run = run(new double[] {1, 2, 0}, new double[] {1, bad, 0});
            ExchangeException e =
                    assertThrows(ExchangeException.class, () -> new CsvExport().write(run, SMALL, target));
            assertTrue(e.getMessage().startsWith("frame 1: 'ann'"), e.getMessage());
        }
        assertEquals("old", Files.readString(target));
        assertEquals(1, files().length, "no part file is left");
    }

    private File[] files() {
        return folder.toFile().listFiles();
    }

    @Test
    void svgIsWellFormedAndHoldsPathsTextAndFields() throws Exception {
        ExportSettings settings = ExportSettings.DEFAULT.at(3.6).with(List.of(Sketch.potential()));
        Document svg = DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(bytes(new SvgExport(), Sketch.run(), settings)));
        assertEquals("svg", svg.getDocumentElement().getTagName());
        assertEquals("900", svg.getDocumentElement().getAttribute("width"));
        assertTrue(svg.getElementsByTagName("path").getLength() > 100);
        boolean vault = false;
        for (int i = 0; i < svg.getElementsByTagName("text").getLength(); i++) {
            vault |= svg.getElementsByTagName("text").item(i).getTextContent().equals("vault");
        }
        assertTrue(vault, "the pill of the vault");
        assertEquals(2, svg.getElementsByTagName("image").getLength(), "the field and its legend");
        ExportSettings both = settings.with(List.of(Sketch.potential(), Sketch.skeleton()));
        String outlined = new String(bytes(new SvgExport(), Sketch.run(), both), StandardCharsets.UTF_8);
        assertFalse(outlined.contains("<image"), "beside another view a field is shown by its contour lines");
    }

    @Test
    void svgEscapesAndRoundsAndKeepsClipsInUserSpace() throws Exception {
        SvgGraphics g = new SvgGraphics();
        Graphics2D copy = (Graphics2D) g.create();
        copy.translate(10, 0);
        copy.clipRect(0, 0, 5, 5);
        assertEquals(new java.awt.Rectangle(0, 0, 5, 5), copy.getClipBounds());
        copy.setColor(new Color(255, 0, 0, 51));
        copy.fillRect(0, 0, 20, 20);
        g.setColor(Color.BLACK);
        g.drawString("a<b & \"c\"\u0001", 1, 2);
        String text = g.document("t", 30, 20, 1);
        assertTrue(text.contains("<clipPath id=\"clip1\"><path d=\"M10 0"), text);
        assertTrue(
                text.contains("<g clip-path=\"url(#clip1)\"><path d=\"M10 0L30 0L30 20L10 20L10 0Z\" fill=\"#ff0000\""
                        + " fill-opacity=\"0.200\"/></g>"),
                text);
        assertTrue(text.contains(">a&lt;b &amp; &quot;c&quot;</text>"), text);
        assertEquals("-0.05", SvgGraphics.number(-0.046));
        assertEquals("12", SvgGraphics.number(11.999));
        assertEquals("0", SvgGraphics.number(-0.001));
        assertEquals("3.4", SvgGraphics.number(3.4));
    }

    @Test
    void pngShowsThePictureOfTheInstant() throws Exception {
        Path target = folder.resolve("run.png");
        Formats.exporter("png").write(Sketch.run(), SMALL.at(3.6).in(Theme.DARK), target);
        BufferedImage read = ImageIO.read(target.toFile());
        BufferedImage made = Picture.of(Sketch.run(), 3.6).with(Theme.DARK).image(240);
        assertArrayEquals(pixels(made), pixels(read));
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    @Test
    void numberedPicturesCoverTheWholeRun() throws Exception {
        Formats.exporter("pngs").write(Sketch.run(), SMALL.every(0.3), folder.resolve("film.png"));
        assertEquals(4, files().length, "at 0, 3.3, 6.7 and 10 seconds");
        assertTrue(Files.exists(folder.resolve("film-00000.png")));
        assertTrue(Files.exists(folder.resolve("film-00003.png")));
    }

    @Test
    void gifKeepsTimeAndShowsEachPicture() throws Exception {
        ExportSettings settings = SMALL.every(3);
        byte[] gif = bytes(new GifExport(), Sketch.run(), settings);
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(new ByteArrayInputStream(gif))) {
            reader.setInput(in);
            assertEquals(31, reader.getNumImages(true));
            int hundredths = 0;
            BufferedImage shown = reader.read(0);
            BufferedImage canvas = new BufferedImage(shown.getWidth(), shown.getHeight(), BufferedImage.TYPE_INT_RGB);
            for (int k = 0; k < 31; k++) {
                IIOMetadataNode tree =
                        (IIOMetadataNode) reader.getImageMetadata(k).getAsTree("javax_imageio_gif_image_1.0");
                IIOMetadataNode control = (IIOMetadataNode)
                        tree.getElementsByTagName("GraphicControlExtension").item(0);
                IIOMetadataNode place = (IIOMetadataNode)
                        tree.getElementsByTagName("ImageDescriptor").item(0);
                hundredths += k < 30 ? Integer.parseInt(control.getAttribute("delayTime")) : 0;
                canvas.getGraphics()
                        .drawImage(
                                reader.read(k),
                                Integer.parseInt(place.getAttribute("imageLeftPosition")),
                                Integer.parseInt(place.getAttribute("imageTopPosition")),
                                null);
            }
            assertEquals(1000, hundredths, "ten seconds");
            BufferedImage end = Picture.of(Sketch.run(), 10).image(240);
            assertTrue(meanDifference(end, canvas) < 3, "mean difference " + meanDifference(end, canvas));
            assertTrue(meanDifference(shown, canvas) > 0.05, "the actor has moved");
        } finally {
            reader.dispose();
        }
    }

    private static double meanDifference(BufferedImage a, BufferedImage b) {
        int[] p = pixels(a);
        int[] q = pixels(b);
        long sum = 0;
        for (int i = 0; i < p.length; i++) {
            for (int shift = 0; shift <= 16; shift += 8) {
                sum += Math.abs((p[i] >> shift & 255) - (q[i] >> shift & 255));
            }
        }
        return sum / (3.0 * p.length);
    }

    @Test
    void changedRectangleIsTheLeast() {
        BufferedImage a = new BufferedImage(20, 10, BufferedImage.TYPE_BYTE_GRAY);
        BufferedImage b = new BufferedImage(20, 10, BufferedImage.TYPE_BYTE_GRAY);
        assertArrayEquals(new int[] {0, 0, 20, 10}, GifExport.changed(null, b));
        assertArrayEquals(new int[] {0, 0, 1, 1}, GifExport.changed(a, b));
        b.setRGB(3, 4, 0xffffff);
        b.setRGB(7, 6, 0xffffff);
        assertArrayEquals(new int[] {3, 4, 5, 3}, GifExport.changed(a, b));
    }

    @Test
    void paletteKeepsFewColoursExactly() {
        BufferedImage image = new BufferedImage(16, 1, BufferedImage.TYPE_INT_RGB);
        for (int x = 0; x < 16; x++) {
            image.setRGB(x, 0, x * 0x0f0a07);
        }
        assertArrayEquals(pixels(image), pixels(new Palette(image).indexed(image)));
    }

    @Test
    void aFileIsWrittenWholeOrNotAtAll() throws Exception {
        Path target = folder.resolve("x.txt");
        AtomicFile.write(target, out -> out.write(65));
        assertThrows(
                IOException.class,
                () -> AtomicFile.write(target, out -> {
                    out.write(new byte[100_000]);
                    throw new IOException("disk full");
                }));
        assertEquals("A", Files.readString(target));
        assertEquals(1, files().length);
    }

    @Test
    void formatsAreFoundByNameAndEnding() {
        assertEquals(
                "gif", Formats.exporterFor(Path.of("a/b.GIF")).orElseThrow().name());
        assertFalse(Formats.exporterFor(Path.of("a.xyz")).isPresent());
        assertEquals(
                "movingai", Formats.importerFor(Path.of("x.map")).orElseThrow().name());
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, () -> Formats.exporter("mp4"));
        assertEquals("format 'mp4'; known are csv, pedpy, mel, blender, svg, png, pngs, gif", e.getMessage());
        assertThrows(IllegalArgumentException.class, () -> SMALL.every(0));
        assertThrows(IllegalArgumentException.class, () -> SMALL.wide(1_000_000));
    }
}
