package troupe.app.panel.timeline;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import troupe.app.look.Look;
import troupe.app.look.Texts;
import troupe.app.panel.Rows;
import troupe.app.play.Chronicle;
import troupe.paint.Theme;
import troupe.paint.Tone;

/** Paints what happened in a simulation over its time: a bar of what was done, and a curve below it. */
final class ChroniclePainter {
    private static final int TEXT_MARGIN = 14;

    private final Look look;
    private final DoubleUnaryOperator x;
    private final Rows rows;

    /** Says at which pixel rows the parts lie. */
    record Rows(int barTop, int barHeight, int plotTop, int height) {}

    /** Makes a painter; {@code x} gives the pixel column of a time in seconds. */
    ChroniclePainter(Look look, DoubleUnaryOperator x, Rows rows) {
        this.look = look;
        this.x = x;
        this.rows = rows;
    }

    private static Tone tone(String word) {
        return switch (word) {
            case "updated" -> Tone.SIDESTEP;
            case "replanned" -> Tone.MOVE;
            case "evaded" -> Tone.STRIDE;
            case "waited" -> Tone.VAULT;
            default -> Tone.WALK;
        };
    }

    /** Returns how high a mark is, as a share of the bar: what was done can be told apart without its colour. */
    private static double share(String word) {
        return switch (word) {
            case "updated" -> 0.7;
            case "waited" -> 0.45;
            case "evaded" -> 0.25;
            default -> 1;
        };
    }

    /** Paints the bar: what was done, or that something was simulated where nothing is told. */
    void paintMarks(Graphics2D g, List<Chronicle.Mark> marks, double duration) {
        FontMetrics metrics = g.getFontMetrics(look.bold());
        List<Chronicle.Mark> shown = marks.isEmpty() ? List.of(new Chronicle.Mark("simulated", 0, duration)) : marks;
        for (Chronicle.Mark mark : shown) {
            double from = x.applyAsDouble(mark.begin());
            double to = Math.max(from + 1.5, x.applyAsDouble(mark.end()));
            Color fill = look.color(tone(mark.word()));
            g.setColor(fill);
            double high = rows.barHeight() * share(mark.word());
            g.fill(new RoundRectangle2D.Double(from, rows.barTop() + rows.barHeight() - high, to - from, high, 4, 4));
            String text = look.texts().get("action." + mark.word(), mark.word());
            if (share(mark.word()) == 1 && metrics.stringWidth(text) + TEXT_MARGIN <= to - from) {
                g.setFont(look.bold());
                g.setColor(look.theme().ink(fill));
                int base = rows.barTop() + (rows.barHeight() + metrics.getAscent()) / 2 - 2;
                g.drawString(text, (float) from + 8, base);
            }
        }
        g.setFont(look.font());
    }

    /** Paints a curve with its name and its greatest value. */
    void paintCurve(Graphics2D g, Chronicle.Curve curve, double duration) {
        double bottom = rows.height() - 8.0;
        double top = rows.plotTop() + 18.0;
        if (bottom - top < 12) {
            return;
        }
        double left = x.applyAsDouble(0);
        double right = x.applyAsDouble(duration);
        g.setColor(look.color(Tone.LINE));
        g.setStroke(Theme.line(1));
        g.draw(new Line2D.Double(left, bottom, right, bottom));
        g.setColor(look.color(Tone.ACCENT));
        g.setStroke(Theme.line(1.8f));
        g.draw(line(curve, duration, top, bottom));
        g.setColor(look.color(Tone.DIM));
        String name = look.text("plot." + curve.key());
        g.drawString(name, (float) left, rows.plotTop() + 10);
        String total = Texts.number(curve.most(), 2);
        FontMetrics metrics = g.getFontMetrics();
        // a run that has only begun has no room for it beside the name
        if (right - left >= metrics.stringWidth(name) + TEXT_MARGIN + metrics.stringWidth(total)) {
            g.drawString(total, (float) right - metrics.stringWidth(total), rows.plotTop() + 10);
        }
    }

    private Path2D line(Chronicle.Curve curve, double duration, double top, double bottom) {
        double most = curve.most();
        double[] values = curve.values();
        Path2D line = new Path2D.Double();
        boolean begun = false;
        for (int k = 0; k < values.length; k++) {
            if (Double.isNaN(values[k])) {
                begun = false;
                continue;
            }
            double px = x.applyAsDouble(values.length == 1 ? 0 : duration * k / (values.length - 1));
            double py = bottom - (most > 0 ? values[k] / most : 0) * (bottom - top);
            if (begun) {
                line.lineTo(px, py);
            } else {
                line.moveTo(px, py);
            }
            begun = true;
        }
        return line;
    }
}
