package troupe.paint.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.field.CategoryLook;
import troupe.paint.field.ColourMap;
import troupe.paint.field.OverlayPainter;
import troupe.paint.motion.Moved;
import troupe.paint.motion.RunPainter;
import troupe.paint.scene.ObstacleLook;
import troupe.paint.scene.ScenePainter;
import troupe.run.Run;
import troupe.run.view.Overlay;
import troupe.scene.Ability;

/**
 * Explains the lines, colours and patterns of a picture: a card of samples with words, in rows. Immutable.
 */
public final class Legend {
    /** The words as they are, with longer ones for moving. */
    public static final UnaryOperator<String> ENGLISH = word -> switch (word) {
        case "move" -> "move an obstacle";
        case "moved-from" -> "where it stood";
        case "triggers" -> "trigger points";
        case "bars-path" -> "bars the expected path";
        default -> word.replace('-', ' ');
    };

    private static final int ROW = 22;
    private static final int PAD_X = 12;
    private static final int PAD_Y = 4;
    private static final int GAP = 16;
    private static final int SAMPLE = 30;
    private static final int BAR = 110;
    private static final int SAMPLE_GAP = 8;
    private static final int MOST_CATEGORIES = 8;

    private final Theme theme;
    private final List<Entry> entries;

    /** One sample with its words. */
    private record Entry(Sample sample, int width, String text, boolean category) {
        Entry(Sample sample, int width, String text) {
            this(sample, width, text, false);
        }
    }

    /** Draws a sample of a given width, its middle at {@code (0, 0)} on its left edge. */
    private interface Sample {
        void draw(Graphics2D g);
    }

    private Legend(Theme theme, List<Entry> entries) {
        this.theme = theme;
        this.entries = List.copyOf(entries);
    }

    /**
     * Makes the legend of a run (null for none) and of overlays.
     *
     * @param filled whether fields of numbers are filled, as in {@link OverlayPainter}
     * @param words turns a key ({@code walk}, {@code clearance}, …) into what is to be read
     */
    public static Legend of(
            Run run, List<? extends Overlay> overlays, boolean filled, Theme theme, UnaryOperator<String> words) {
        List<Entry> entries = new ArrayList<>();
        if (run != null) {
            for (Ability ability : Ability.values()) {
                if (run.legs().stream().anyMatch(leg -> leg.ability().equals(ability.key()))) {
                    BasicStroke stroke = Theme.stroke(ability, Theme.PATH_WIDTH);
                    entries.add(line(theme.color(ability), stroke, words.apply(ability.key())));
                }
            }
        }
        if (run != null && Moved.any(run)) {
            entries.add(trace(theme, words.apply("moved-from")));
        }
        for (Overlay overlay : overlays) {
            List<Entry> more = new ArrayList<>();
            addOverlay(more, overlay, filled, theme, words);
            // the layers of one view say the same
            more.removeIf(e -> entries.stream().anyMatch(known -> known.text().equals(e.text())));
            entries.addAll(more);
        }
        return new Legend(theme, shortened(entries));
    }

    private static Entry line(Color colour, BasicStroke stroke, String text) {
        Sample sample = g -> {
            g.setColor(colour);
            g.setStroke(stroke);
            g.draw(new Line2D.Double(2, 0, SAMPLE - 2, 0));
        };
        return new Entry(sample, SAMPLE, text);
    }

    /** Returns what is left of a moved obstacle: its trace, and the way that leads from there. */
    private static Entry trace(Theme theme, String text) {
        Sample sample = g -> {
            Path2D box = new Path2D.Double(new Rectangle2D.Double(2, -7, 15, 14));
            ScenePainter.paintTrace(g, theme, ObstacleLook.Trace.LEFT, box, theme.color(Tone.WOOD), -0.35);
            g.setColor(theme.color(Tone.MOVE));
            g.setStroke(RunPainter.wayStroke());
            g.draw(new Line2D.Double(9.5, 0, SAMPLE - 1, 0));
        };
        return new Entry(sample, SAMPLE, text);
    }

    private static void addOverlay(
            List<Entry> entries, Overlay overlay, boolean filled, Theme theme, UnaryOperator<String> words) {
        String name = words.apply(overlay.key());
        if (overlay instanceof Overlay.Lines) {
            entries.add(line(
                    theme.color(OverlayPainter.lineTone(overlay.key())),
                    OverlayPainter.lineStroke(overlay.key()),
                    name));
        } else if (overlay instanceof Overlay.Points) {
            entries.add(new Entry(g -> OverlayPainter.paintPoint(g, theme, 6, 0), 12, name));
        } else if (overlay instanceof Overlay.Field f && f.scale() instanceof Overlay.Continuous c) {
            String each =
                    c.contour() > 0 ? ", " + words.apply("every") + " " + number(c.contour()) + " " + c.unit() : "";
            if (filled || c.contour() <= 0) {
                entries.add(bar(theme, overlay.key(), c, name, words));
                if (c.contour() > 0) {
                    entries.add(line(theme.color(Tone.TEXT, 0.45), Theme.line(1), each.substring(2)));
                }
            } else {
                entries.add(line(theme.color(Tone.CONTOUR), Theme.line(1.4f), name + each));
            }
        } else if (overlay instanceof Overlay.Field f && f.scale() instanceof Overlay.Categories c) {
            boolean[] used = used(f, c.words().size());
            CategoryLook[] looks = CategoryLook.of(c.words(), theme);
            for (int i = 0; i < looks.length; i++) {
                if (used[i] && looks[i].pattern() != CategoryLook.Pattern.NONE) {
                    entries.add(swatch(theme, looks[i], words.apply(c.words().get(i))));
                }
            }
        }
    }

    /** Leaves the first categories and the number of those that follow. */
    private static List<Entry> shortened(List<Entry> entries) {
        List<Entry> all =
                new ArrayList<>(entries.stream().filter(Entry::category).toList());
        if (all.size() <= MOST_CATEGORIES) {
            return entries;
        }
        List<Entry> more = all.subList(MOST_CATEGORIES, all.size());
        List<Entry> kept = new ArrayList<>(entries);
        kept.set(kept.indexOf(more.get(0)), new Entry(g -> {}, 0, "+ " + more.size()));
        kept.removeAll(more);
        return kept;
    }

    private static boolean[] used(Overlay.Field field, int words) {
        boolean[] used = new boolean[words];
        for (float value : field.values()) {
            if (value >= 0 && value < words) {
                used[(int) value] = true;
            }
        }
        return used;
    }

    private static Entry bar(
            Theme theme, String key, Overlay.Continuous scale, String name, UnaryOperator<String> words) {
        ColourMap map = ColourMap.of(key, theme);
        String unit = scale.unit().isEmpty() ? "" : " " + scale.unit();
        String text = name + ", " + number(scale.min()) + " " + words.apply("to") + " " + number(scale.max()) + unit;
        BufferedImage colours = new BufferedImage(BAR, 1, BufferedImage.TYPE_INT_ARGB);
        for (int x = 0; x < BAR; x++) {
            colours.setRGB(x, 0, map.argb(x / (BAR - 1.0)));
        }
        Sample sample = g -> {
            g.drawImage(colours, new AffineTransform(1, 0, 0, 10, 0, -5), null);
            g.setColor(theme.color(Tone.LINE));
            g.setStroke(Theme.line(1));
            g.draw(new Rectangle2D.Double(-0.5, -5.5, BAR + 1, 11));
        };
        return new Entry(sample, BAR, text);
    }

    private static Entry swatch(Theme theme, CategoryLook look, String name) {
        BufferedImage tile = new BufferedImage(24, 12, BufferedImage.TYPE_INT_ARGB);
        for (int y = 0; y < 12; y++) {
            for (int x = 0; x < 24; x++) {
                tile.setRGB(x, y, look.argb(x, y));
            }
        }
        Sample sample = g -> {
            g.drawImage(tile, new AffineTransform(1, 0, 0, 1, 0, -6), null);
            g.setColor(theme.color(Tone.DIM, 0.6));
            g.setStroke(Theme.line(1));
            g.draw(new Rectangle2D.Double(-0.5, -6.5, 25, 13));
        };
        return new Entry(sample, 24, name, true);
    }

    private static String number(double value) {
        double size = Math.abs(value);
        String text = String.format(Locale.ROOT, size >= 100 ? "%.0f" : size >= 10 ? "%.1f" : "%.2f", value);
        return text.contains(".") ? text.replaceAll("\\.?0+$", "") : text;
    }

    /** Tells whether there is nothing to explain. */
    public boolean isEmpty() {
        return entries.isEmpty();
    }

    /** Returns the texts, in order, for those who cannot see the samples. */
    public List<String> texts() {
        return entries.stream().map(Entry::text).toList();
    }

    /** Returns the size in pixels of the card when it may be {@code most} pixels wide; empty: 0 by 0. */
    public Dimension size(Graphics2D g, int most) {
        if (entries.isEmpty()) {
            return new Dimension(0, 0);
        }
        int[][] places = places(g, most);
        FontMetrics metrics = g.getFontMetrics(font());
        int right = 0;
        for (int i = 0; i < places.length; i++) {
            right = Math.max(right, places[i][0] + width(metrics, g, entries.get(i)));
        }
        int rows = places[places.length - 1][1] + 1;
        return new Dimension(right + PAD_X, rows * ROW + 2 * PAD_Y);
    }

    private static Font font() {
        return Theme.font(12);
    }

    private static int width(FontMetrics metrics, Graphics2D g, Entry entry) {
        return entry.width()
                + SAMPLE_GAP
                + (int) Math.ceil(metrics.getStringBounds(entry.text(), g).getWidth());
    }

    /** Returns x in pixels and row of each entry. */
    private int[][] places(Graphics2D g, int most) {
        FontMetrics metrics = g.getFontMetrics(font());
        int[][] places = new int[entries.size()][];
        int x = PAD_X;
        int row = 0;
        for (int i = 0; i < places.length; i++) {
            int width = width(metrics, g, entries.get(i));
            if (x > PAD_X && x + width + PAD_X > most) {
                x = PAD_X;
                row++;
            }
            places[i] = new int[] {x, row};
            x += width + GAP;
        }
        return places;
    }

    /** Paints the card with its upper left corner at {@code (x, y)}, at most {@code most} pixels wide. */
    public void paint(Graphics2D graphics, int x, int y, int most) {
        if (entries.isEmpty()) {
            return;
        }
        Graphics2D g = Shapes.smooth(graphics);
        g.translate(x, y);
        Dimension size = size(g, most);
        RoundRectangle2D card = new RoundRectangle2D.Double(0.5, 0.5, size.width - 1, size.height - 1, 16, 16);
        g.setColor(theme.color(Tone.PANEL));
        g.fill(card);
        g.setColor(theme.color(Tone.LINE));
        g.setStroke(Theme.line(1));
        g.draw(card);
        int[][] places = places(g, most);
        Font font = font();
        FontMetrics metrics = g.getFontMetrics(font);
        for (int i = 0; i < places.length; i++) {
            Entry entry = entries.get(i);
            int middle = PAD_Y + places[i][1] * ROW + ROW / 2;
            Graphics2D sample = (Graphics2D) g.create();
            sample.translate(places[i][0], middle);
            entry.sample().draw(sample);
            sample.dispose();
            g.setFont(font);
            g.setColor(theme.color(Tone.TEXT));
            float base = middle + (metrics.getAscent() - metrics.getDescent()) / 2f;
            g.drawString(entry.text(), places[i][0] + entry.width() + SAMPLE_GAP, base);
        }
        g.dispose();
    }

    @Override
    public String toString() {
        return "Legend" + Arrays.toString(texts().toArray());
    }
}
