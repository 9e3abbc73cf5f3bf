package troupe.exchange.picture;

import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import troupe.exchange.format.ExchangeException;
import troupe.exchange.format.ExportSettings;
import troupe.exchange.format.Instants;
import troupe.exchange.format.StreamExporter;
import troupe.paint.picture.Animation;
import troupe.run.Run;

/**
 * Writes all of a run as an animated GIF that repeats: one palette for all pictures, and of each picture
 * only the rectangle that differs from the one before. Delays are whole hundredths of a second whose sum
 * keeps to the run's time; the last picture stays for a second.
 */
public final class GifExport implements StreamExporter {
    private static final String FORMAT = "javax_imageio_gif_image_1.0";
    private static final int LAST_DELAY = 100;
    private static final int MAX_PIXELS = 1 << 24;

    /** Makes the exporter. */
    public GifExport() {}

    @Override
    public String name() {
        return "gif";
    }

    @Override
    public String extension() {
        return "gif";
    }

    @Override
    public String about() {
        return "an animation of the whole run, for slides and web pages";
    }

    @Override
    public void write(Run run, ExportSettings settings, OutputStream out) throws IOException, ExchangeException {
        double[] instants = Instants.of(run, settings);
        Animation animation = new Animation(settings.picture(run), settings.width(), settings.density());
        BufferedImage first = animation.image(0);
        if ((long) first.getWidth() * first.getHeight() > MAX_PIXELS
                || Math.max(first.getWidth(), first.getHeight()) > 65_535) {
            throw new ExchangeException(
                    "the animation", 0, 0, first.getWidth() + " x " + first.getHeight() + " pixels", "lower the width");
        }
        settings.proceed();
        Palette palette = new Palette(first, animation.image(run.frames().duration() / 2));
        ImageWriter writer = ImageIO.getImageWritersByFormatName("gif").next();
        try (MemoryCacheImageOutputStream sink = new MemoryCacheImageOutputStream(out)) {
            writer.setOutput(sink);
            writer.prepareWriteSequence(null);
            BufferedImage before = null;
            for (int k = 0; k < instants.length; k++) {
                settings.proceed();
                BufferedImage now = palette.indexed(animation.image(instants[k]));
                int delay = k + 1 < instants.length
                        ? (int) (Math.round(100 * instants[k + 1]) - Math.round(100 * instants[k]))
                        : LAST_DELAY;
                writeFrame(writer, before, now, delay);
                before = now;
            }
            writer.endWriteSequence();
        } finally {
            writer.dispose();
        }
    }

    private static void writeFrame(ImageWriter writer, BufferedImage before, BufferedImage now, int delay)
            throws IOException {
        int[] box = changed(before, now);
        BufferedImage part = part(now, box);
        IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(now), null);
        IIOMetadataNode root = new IIOMetadataNode(FORMAT);
        root.appendChild(node(
                "ImageDescriptor",
                "imageLeftPosition",
                box[0],
                "imageTopPosition",
                box[1],
                "imageWidth",
                box[2],
                "imageHeight",
                box[3],
                "interlaceFlag",
                "FALSE"));
        root.appendChild(node(
                "GraphicControlExtension",
                "disposalMethod",
                "doNotDispose",
                "userInputFlag",
                "FALSE",
                "transparentColorFlag",
                "FALSE",
                "delayTime",
                delay,
                "transparentColorIndex",
                0));
        if (before == null) {
            IIOMetadataNode all = new IIOMetadataNode("ApplicationExtensions");
            IIOMetadataNode loop =
                    node("ApplicationExtension", "applicationID", "NETSCAPE", "authenticationCode", "2.0");
            loop.setUserObject(new byte[] {1, 0, 0});
            all.appendChild(loop);
            root.appendChild(all);
        }
        metadata.mergeTree(FORMAT, root);
        writer.writeToSequence(new IIOImage(part, null, metadata), null);
    }

    /** Copies a rectangle: the writer takes the pixels of a subimage from the wrong place. */
    private static BufferedImage part(BufferedImage image, int[] box) {
        BufferedImage part = new BufferedImage(
                box[2], box[3], BufferedImage.TYPE_BYTE_INDEXED, (IndexColorModel) image.getColorModel());
        part.getRaster()
                .setDataElements(
                        0, 0, box[2], box[3], image.getRaster().getDataElements(box[0], box[1], box[2], box[3], null));
        return part;
    }

    private static IIOMetadataNode node(String name, Object... attributes) {
        IIOMetadataNode node = new IIOMetadataNode(name);
        for (int i = 0; i < attributes.length; i += 2) {
            node.setAttribute(String.valueOf(attributes[i]), String.valueOf(attributes[i + 1]));
        }
        return node;
    }

    /** Returns left, top, width and height of the least rectangle that holds every changed pixel; at least 1 by 1. */
    public static int[] changed(BufferedImage before, BufferedImage now) {
        int width = now.getWidth();
        int height = now.getHeight();
        if (before == null) {
            return new int[] {0, 0, width, height};
        }
        int left = width;
        int right = -1;
        int top = height;
        int bottom = -1;
        int[] a = new int[width];
        int[] b = new int[width];
        for (int y = 0; y < height; y++) {
            before.getRaster().getSamples(0, y, width, 1, 0, a);
            now.getRaster().getSamples(0, y, width, 1, 0, b);
            int from = Arrays.mismatch(a, b);
            if (from >= 0) {
                int to = width - 1;
                while (a[to] == b[to]) {
                    to--;
                }
                left = Math.min(left, from);
                right = Math.max(right, to);
                top = Math.min(top, y);
                bottom = y;
            }
        }
        return right < 0 ? new int[] {0, 0, 1, 1} : new int[] {left, top, right - left + 1, bottom - top + 1};
    }
}
