package troupe.app.help;

import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;

/** Reads the pages of {@code docs/} that the program brings along. Safe on any thread but the event thread. */
final class GuidePages {
    /** The page to begin with. */
    static final String FIRST = "guide.md";

    private static final String FOLDER = "/docs/";
    private static final int WIDEST = 600;

    private final Locale language;
    private final double scale;

    /** A page and the pictures in it, by their places. */
    record Read(Markdown.Page page, Map<URL, Image> pictures) {}

    /** Makes the pages in a language, with pictures at a scale. */
    GuidePages(Locale language, double scale) {
        this.language = language;
        this.scale = scale;
    }

    /** Tells whether there is a page of that name. */
    static boolean has(String name) {
        return !name.contains("/") && name.endsWith(".md") && GuidePages.class.getResource(FOLDER + name) != null;
    }

    /**
     * Reads a page, in the language where it is there in that, and its pictures, no wider than the page.
     *
     * @throws IOException if the program does not bring it along
     */
    Read read(String name) throws IOException {
        String own = name.replace(".md", "." + language.toLanguageTag() + ".md");
        String there = has(own) ? own : name;
        Map<URL, Image> pictures = new LinkedHashMap<>();
        try (InputStream stream = GuidePages.class.getResourceAsStream(FOLDER + there)) {
            if (stream == null) {
                throw new IOException("the program brings no page " + there + " along");
            }
            String text = new String(stream.readAllBytes(), StandardCharsets.UTF_8);
            return new Read(Markdown.page(text, path -> picture(path, pictures)), pictures);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    private Optional<String> picture(String path, Map<URL, Image> pictures) {
        URL url = GuidePages.class.getResource(FOLDER + path);
        if (url == null) {
            return Optional.empty();
        }
        try {
            pictures.put(url, fitting(ImageIO.read(url)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return Optional.of("<img src=\"" + url + "\">");
    }

    private Image fitting(BufferedImage whole) {
        int width = (int) Math.min(whole.getWidth() * scale, WIDEST * scale);
        int height = (int) Math.round((double) whole.getHeight() * width / whole.getWidth());
        BufferedImage made = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = made.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
        g.drawImage(whole, 0, 0, width, height, null);
        g.dispose();
        return made;
    }
}
