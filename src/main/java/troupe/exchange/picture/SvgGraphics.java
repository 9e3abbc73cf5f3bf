package troupe.exchange.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics;
import java.awt.Image;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.PathIterator;
import java.awt.image.BufferedImage;
import java.awt.image.ImageObserver;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/**
 * Writes what is drawn as SVG elements: shapes as paths, texts as texts held to their measured width, so
 * that another font keeps the layout, images as embedded PNG. Numbers have at most two decimals.
 */
public final class SvgGraphics extends PlainGraphics {
    private final Output output;

    /** What all copies of one graphics write into. */
    private static final class Output {
        private final StringBuilder elements = new StringBuilder();
        private final Map<String, Integer> clips = new LinkedHashMap<>();
    }

    /** Makes an empty drawing. */
    public SvgGraphics() {
        output = new Output();
    }

    private SvgGraphics(SvgGraphics other) {
        super(other);
        output = other.output;
    }

    @Override
    public Graphics create() {
        return new SvgGraphics(this);
    }

    @Override
    public void dispose() {
        // holds nothing but its output
    }

    /** Returns the whole document, shown {@code width x height} pixels large, its units {@code scale} to a pixel. */
    public String document(String title, int width, int height, double scale) {
        StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        text.append("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"").append(width);
        text.append("\" height=\"").append(height).append("\" viewBox=\"0 0 ");
        text.append(number(width * scale))
                .append(' ')
                .append(number(height * scale))
                .append("\">\n");
        text.append("<title>").append(escaped(title)).append("</title>\n");
        for (Map.Entry<String, Integer> clip : output.clips.entrySet()) {
            text.append("<clipPath id=\"clip").append(clip.getValue()).append("\"><path d=\"");
            text.append(clip.getKey()).append("\"/></clipPath>\n");
        }
        return text.append(output.elements).append("</svg>\n").toString();
    }

    @Override
    public void fill(Shape shape) {
        String path = path(getTransform().createTransformedShape(shape).getPathIterator(null));
        if (path.isEmpty()) {
            return;
        }
        begin("path").append(" d=\"").append(path).append('"');
        if (shape.getPathIterator(null).getWindingRule() == PathIterator.WIND_EVEN_ODD) {
            output.elements.append(" fill-rule=\"evenodd\"");
        }
        colour("fill");
        end("/>");
    }

    @Override
    public void draw(Shape shape) {
        if (!(getStroke() instanceof BasicStroke stroke)) {
            fill(getStroke().createStrokedShape(shape));
            return;
        }
        String path = path(getTransform().createTransformedShape(shape).getPathIterator(null));
        if (path.isEmpty()) {
            return;
        }
        double scale = Math.sqrt(Math.abs(getTransform().getDeterminant()));
        begin("path").append(" d=\"").append(path).append("\" fill=\"none\"");
        colour("stroke");
        StringBuilder text = output.elements;
        text.append(" stroke-width=\"")
                .append(number(stroke.getLineWidth() * scale))
                .append('"');
        text.append(stroke.getEndCap() == BasicStroke.CAP_ROUND ? " stroke-linecap=\"round\"" : "");
        text.append(stroke.getLineJoin() == BasicStroke.JOIN_ROUND ? " stroke-linejoin=\"round\"" : "");
        if (stroke.getDashArray() != null) {
            text.append(" stroke-dasharray=\"");
            for (int i = 0; i < stroke.getDashArray().length; i++) {
                text.append(i == 0 ? "" : " ").append(number(stroke.getDashArray()[i] * scale));
            }
            text.append('"');
        }
        end("/>");
    }

    @Override
    public void drawString(String string, float x, float y) {
        if (string.isBlank()) {
            return;
        }
        double width = getFontMetrics(getFont()).getStringBounds(string, this).getWidth();
        begin("text").append(" transform=\"").append(matrix(getTransform())).append('"');
        StringBuilder text = output.elements;
        text.append(" x=\"").append(number(x)).append("\" y=\"").append(number(y));
        text.append("\" font-family=\"sans-serif\" font-size=\"")
                .append(number(getFont().getSize2D()));
        text.append(getFont().isBold() ? "\" font-weight=\"bold" : "");
        text.append("\" textLength=\"").append(number(width)).append("\" lengthAdjust=\"spacingAndGlyphs\"");
        colour("fill");
        end(">" + escaped(string) + "</text>");
    }

    @Override
    public boolean drawImage(Image image, AffineTransform place, ImageObserver observer) {
        if (!(image instanceof BufferedImage picture)) {
            throw new UnsupportedOperationException("vector graphics hold no image but buffered ones");
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            ImageExport.write(picture, bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        AffineTransform all = getTransform();
        all.concatenate(place);
        begin("image").append(" transform=\"").append(matrix(all));
        output.elements.append("\" width=\"").append(picture.getWidth());
        output.elements.append("\" height=\"").append(picture.getHeight());
        output.elements.append("\" style=\"image-rendering:pixelated\" href=\"data:image/png;base64,");
        output.elements
                .append(Base64.getEncoder().encodeToString(bytes.toByteArray()))
                .append('"');
        end("/>");
        return true;
    }

    /** Begins an element, inside a group that holds the clip, since an element's own transform would move it. */
    private StringBuilder begin(String element) {
        if (outputClip() != null) {
            String clip = path(outputClip().getPathIterator(null));
            Integer id = output.clips.get(clip);
            if (id == null) {
                id = output.clips.size() + 1;
                output.clips.put(clip, id);
            }
            output.elements.append("<g clip-path=\"url(#clip").append(id).append(")\">");
        }
        return output.elements.append('<').append(element);
    }

    private void end(String rest) {
        output.elements.append(rest).append(outputClip() == null ? "\n" : "</g>\n");
    }

    private void colour(String attribute) {
        Color c = getColor();
        String rgb = String.format(Locale.ROOT, "#%06x", c.getRGB() & 0xffffff);
        output.elements.append(' ').append(attribute).append("=\"").append(rgb).append('"');
        double opacity = c.getAlpha() / 255.0 * opacity();
        if (opacity < 1) {
            output.elements.append(' ').append(attribute).append("-opacity=\"");
            output.elements.append(String.format(Locale.ROOT, "%.3f", opacity)).append('"');
        }
    }

    private static String path(PathIterator it) {
        StringBuilder text = new StringBuilder();
        double[] at = new double[6];
        for (; !it.isDone(); it.next()) {
            int kind = it.currentSegment(at);
            int numbers = new int[] {2, 2, 4, 6, 0}[kind];
            text.append("MLQCZ".charAt(kind));
            for (int i = 0; i < numbers; i++) {
                text.append(i == 0 ? "" : " ").append(number(at[i]));
            }
        }
        return text.toString();
    }

    private static String matrix(AffineTransform t) {
        return "matrix(" + exact(t.getScaleX()) + ' ' + exact(t.getShearY()) + ' ' + exact(t.getShearX()) + ' '
                + exact(t.getScaleY()) + ' ' + exact(t.getTranslateX()) + ' ' + exact(t.getTranslateY()) + ')';
    }

    private static String exact(double value) {
        return String.format(Locale.ROOT, "%.6f", value);
    }

    /** Returns a number with at most two decimals, without needless zeros. */
    public static String number(double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException("a drawing holds the number " + value);
        }
        long hundredths = Math.round(value * 100);
        String sign = hundredths < 0 ? "-" : "";
        long whole = Math.abs(hundredths) / 100;
        long rest = Math.abs(hundredths) % 100;
        String decimals = rest == 0 ? "" : rest % 10 == 0 ? "." + rest / 10 : rest < 10 ? ".0" + rest : "." + rest;
        return sign + whole + decimals;
    }

    /** Returns text for an XML document: marks escaped, characters that XML does not know left out. */
    static String escaped(String text) {
        StringBuilder safe = new StringBuilder();
        text.codePoints().forEach(c -> {
            switch (c) {
                case '<' -> safe.append("&lt;");
                case '>' -> safe.append("&gt;");
                case '&' -> safe.append("&amp;");
                case '"' -> safe.append("&quot;");
                default -> {
                    boolean known = c == '\t'
                            || c == '\n'
                            || c >= 0x20 && c <= 0xd7ff
                            || c >= 0xe000 && c <= 0xfffd
                            || c >= 0x10000;
                    if (known) {
                        safe.appendCodePoint(c);
                    }
                }
            }
        });
        return safe.toString();
    }
}
