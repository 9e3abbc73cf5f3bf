package troupe.paint;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.function.Function;
import troupe.scene.Ability;

/** Writes the words of abilities into pills beside a path, clear of the path and of other text. */
public final class Pills {
    private static final double HEIGHT = 19;
    private static final double PADDING = 9;
    private static final double[] DISTANCES = {14, 24, 38, 54};
    private static final int DIRECTIONS = 12;

    private final Graphics2D g;
    private final Theme theme;
    private final Labels labels;
    private final List<double[]> path;
    private final Function<Ability, String> words;
    private final Font font = Theme.font(12);

    /** Makes pills that keep off {@code path}, points in pixels, and say {@code words}. */
    public Pills(Graphics2D g, Theme theme, Labels labels, List<double[]> path, Function<Ability, String> words) {
        this.g = g;
        this.theme = theme;
        this.labels = labels;
        this.path = path;
        this.words = words;
    }

    /** Paints the pill of a stretch at its middle, or nothing if there is no room near it. */
    public void paint(Ability ability, List<double[]> stretch) {
        if (stretch.isEmpty()) {
            return;
        }
        double[] at = stretch.get(stretch.size() / 2);
        Rectangle2D text = Labels.around(g, font, words.apply(ability), 0, 0);
        double width = text.getWidth() + 2 * PADDING;
        Rectangle2D best = null;
        int fewest = Integer.MAX_VALUE;
        for (double distance : DISTANCES) {
            for (int k = 0; k < DIRECTIONS; k++) {
                double angle = 2 * Math.PI * k / DIRECTIONS + Math.PI / DIRECTIONS;
                double x = at[0] + Math.cos(angle) * (distance + width / 2);
                double y = at[1] + Math.sin(angle) * (distance + HEIGHT / 2);
                Rectangle2D place = new Rectangle2D.Double(x - width / 2, y - HEIGHT / 2, width, HEIGHT);
                int met = meets(place);
                if (met < fewest && labels.free(place)) {
                    best = place;
                    fewest = met;
                }
            }
            if (fewest == 0) {
                break;
            }
        }
        if (best != null) {
            paint(ability, best);
        }
    }

    private int meets(Rectangle2D place) {
        Rectangle2D grown = new Rectangle2D.Double(
                place.getX() - 5, place.getY() - 5, place.getWidth() + 10, place.getHeight() + 10);
        return (int) path.stream().filter(p -> grown.contains(p[0], p[1])).count();
    }

    private void paint(Ability ability, Rectangle2D place) {
        RoundRectangle2D pill =
                new RoundRectangle2D.Double(place.getX(), place.getY(), place.getWidth(), HEIGHT, HEIGHT, HEIGHT);
        g.setColor(theme.color(Tone.PANEL));
        g.fill(pill);
        g.setColor(theme.color(ability));
        g.setStroke(Theme.line(1.2f));
        g.draw(pill);
        Rectangle2D text = Labels.around(g, font, words.apply(ability), place.getCenterX(), place.getCenterY());
        labels.draw(g, font, words.apply(ability), text, theme.color(Tone.TEXT));
        labels.take(place);
    }
}
