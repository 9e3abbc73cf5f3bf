package troupe.exchange;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import troupe.exchange.picture.SvgExport;
import troupe.paint.Sketch;
import troupe.paint.Theme;
import troupe.paint.picture.Picture;

/** Draws the SVG export by the rules of SVG, in a small reader of its own, and compares with the picture. */
class SvgOracleTest {
    private static final Pattern COMMAND = Pattern.compile("([MLQCZ])([^MLQCZ]*)");
    private static final int WIDTH = 500;

    @ParameterizedTest
    @EnumSource(Theme.class)
    void drawingShowsWhatThePictureShows(Theme theme) throws Exception {
        Picture picture = Picture.of(Sketch.run(), 3.6)
                .with(theme)
                .with(List.of(Sketch.potential(), Sketch.classes(), Sketch.skeleton(), Sketch.triggers()));
        compare(picture);
        compare(Picture.of(Sketch.haul(), 8).with(theme));
    }

    private static void compare(Picture picture) throws Exception {
        BufferedImage wanted = picture.image(WIDTH, 2);
        BufferedImage drawn = draw(SvgExport.document(picture, WIDTH), wanted.getWidth(), wanted.getHeight());
        long sum = 0;
        int plain = 0;
        for (int y = 0; y < wanted.getHeight(); y++) {
            for (int x = 0; x < wanted.getWidth(); x++) {
                int a = wanted.getRGB(x, y);
                int b = drawn.getRGB(x, y);
                int most = 0;
                for (int shift = 0; shift <= 16; shift += 8) {
                    int apart = Math.abs((a >> shift & 255) - (b >> shift & 255));
                    sum += apart;
                    most = Math.max(most, apart);
                }
                plain += most > 80 ? 1 : 0;
            }
        }
        double pixels = (double) wanted.getWidth() * wanted.getHeight();
        assertTrue(sum / (3 * pixels) < 1.5, "mean difference " + sum / (3 * pixels));
        assertTrue(plain / pixels < 0.005, "share of plainly other pixels " + plain / pixels);
    }

    private static BufferedImage draw(String text, int width, int height) throws Exception {
        Document svg = DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        children(g, svg, svg.getDocumentElement());
        g.dispose();
        return image;
    }

    private static void children(Graphics2D g, Document svg, Element parent) throws IOException {
        for (Node node = parent.getFirstChild(); node != null; node = node.getNextSibling()) {
            if (node instanceof Element element) {
                switch (element.getTagName()) {
                    case "g" -> group(g, svg, element);
                    case "path" -> path(g, element);
                    case "text" -> text(g, element);
                    case "image" -> image(g, element);
                    case "title", "clipPath" -> {}
                    default -> throw new IOException("unknown element " + element.getTagName());
                }
            }
        }
    }

    private static void group(Graphics2D g, Document svg, Element group) throws IOException {
        String id = group.getAttribute("clip-path").replaceAll("url\\(#(.*)\\)", "$1");
        Graphics2D inner = (Graphics2D) g.create();
        for (int i = 0; i < svg.getElementsByTagName("clipPath").getLength(); i++) {
            Element clip = (Element) svg.getElementsByTagName("clipPath").item(i);
            if (clip.getAttribute("id").equals(id)) {
                inner.clip(shape((Element) clip.getFirstChild()));
            }
        }
        children(inner, svg, group);
        inner.dispose();
    }

    private static Path2D shape(Element path) {
        boolean evenOdd = path.getAttribute("fill-rule").equals("evenodd");
        Path2D shape = new Path2D.Double(evenOdd ? Path2D.WIND_EVEN_ODD : Path2D.WIND_NON_ZERO);
        Matcher commands = COMMAND.matcher(path.getAttribute("d"));
        while (commands.find()) {
            double[] n = numbers(commands.group(2));
            switch (commands.group(1)) {
                case "M" -> shape.moveTo(n[0], n[1]);
                case "L" -> shape.lineTo(n[0], n[1]);
                case "Q" -> shape.quadTo(n[0], n[1], n[2], n[3]);
                case "C" -> shape.curveTo(n[0], n[1], n[2], n[3], n[4], n[5]);
                default -> shape.closePath();
            }
        }
        return shape;
    }

    private static double[] numbers(String text) {
        return text.isBlank()
                ? new double[0]
                : Arrays.stream(text.strip().split("[ ,]+"))
                        .mapToDouble(Double::parseDouble)
                        .toArray();
    }

    private static void path(Graphics2D g, Element path) {
        if (!path.getAttribute("fill").equals("none")) {
            g.setColor(colour(path, "fill"));
            g.fill(shape(path));
        }
        if (path.hasAttribute("stroke")) {
            double[] dashes = numbers(path.getAttribute("stroke-dasharray"));
            float[] lengths = new float[dashes.length];
            for (int i = 0; i < dashes.length; i++) {
                lengths[i] = (float) dashes[i];
            }
            boolean round = path.getAttribute("stroke-linecap").equals("round");
            g.setStroke(new BasicStroke(
                    Float.parseFloat(path.getAttribute("stroke-width")),
                    round ? BasicStroke.CAP_ROUND : BasicStroke.CAP_BUTT,
                    path.getAttribute("stroke-linejoin").equals("round")
                            ? BasicStroke.JOIN_ROUND
                            : BasicStroke.JOIN_MITER,
                    4,
                    lengths.length == 0 ? null : lengths,
                    0));
            g.setColor(colour(path, "stroke"));
            g.draw(shape(path));
        }
    }

    private static Color colour(Element element, String attribute) {
        Color c = Color.decode(element.getAttribute(attribute));
        String opacity = element.getAttribute(attribute + "-opacity");
        int alpha = opacity.isEmpty() ? 255 : (int) Math.round(255 * Double.parseDouble(opacity));
        return new Color(c.getRed(), c.getGreen(), c.getBlue(), alpha);
    }

    private static AffineTransform transform(Element element) {
        return new AffineTransform(
                numbers(element.getAttribute("transform").replace("matrix(", "").replace(")", "")));
    }

    private static void text(Graphics2D g, Element text) {
        Graphics2D inner = (Graphics2D) g.create();
        inner.transform(transform(text));
        inner.translate(Double.parseDouble(text.getAttribute("x")), Double.parseDouble(text.getAttribute("y")));
        inner.setFont(
                new Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont(Float.parseFloat(text.getAttribute("font-size"))));
        double natural = inner.getFontMetrics()
                .getStringBounds(text.getTextContent(), inner)
                .getWidth();
        inner.scale(Double.parseDouble(text.getAttribute("textLength")) / natural, 1);
        inner.setColor(colour(text, "fill"));
        inner.drawString(text.getTextContent(), 0, 0);
        inner.dispose();
    }

    private static void image(Graphics2D g, Element image) throws IOException {
        String data = image.getAttribute("href").replace("data:image/png;base64,", "");
        BufferedImage picture =
                ImageIO.read(new ByteArrayInputStream(Base64.getDecoder().decode(data)));
        AffineTransform place = transform(image);
        place.scale(
                Double.parseDouble(image.getAttribute("width")) / picture.getWidth(),
                Double.parseDouble(image.getAttribute("height")) / picture.getHeight());
        g.drawImage(picture, place, null);
    }
}
