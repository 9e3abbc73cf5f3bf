package troupe.bench;

import java.util.Locale;

/** Draws the flow through a door against its width, beside the published flow of people. */
final class FlowPlot {
    private static final double PUBLISHED = 1.3;
    private static final double LEFT = 60;
    private static final double BOTTOM = 270;
    private static final String GREY = "#68727f";

    private FlowPlot() {}

    /** Returns the plot of persons per second for door widths in metres. */
    static String svg(double[] widths, double[] flows) {
        StringBuilder out = new StringBuilder(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 520 320\""
                        + " font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"520\" height=\"320\" fill=\"#ffffff\"/>\n");
        for (int flow = 0; flow <= 4; flow++) {
            add(out, "<path d=\"M%.0f %.1fH490\" stroke=\"#dfe2e7\"/>", LEFT, y(flow));
            text(out, LEFT - 8, y(flow) + 4, "end", GREY, Integer.toString(flow));
        }
        for (int w = 0; w < widths.length; w += 2) {
            text(out, x(widths[w]), BOTTOM + 18, "middle", GREY, String.format(Locale.ROOT, "%.1f", widths[w]));
        }
        double from = widths[0] - 0.1;
        double to = widths[widths.length - 1] + 0.1;
        add(
                out,
                "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"" + GREY + "\" stroke-dasharray=\"5 4\" fill=\"none\"/>",
                x(from),
                y(PUBLISHED * from),
                x(to),
                y(PUBLISHED * to));
        text(out, x(to) - 4, y(PUBLISHED * to) + 16, "end", GREY, PUBLISHED + " persons/(m s)");
        StringBuilder line = new StringBuilder();
        for (int w = 0; w < widths.length; w++) {
            line.append(String.format(Locale.ROOT, "%s%.1f %.1f", w == 0 ? "M" : "L", x(widths[w]), y(flows[w])));
            add(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"#0072b2\"/>", x(widths[w]), y(flows[w]));
        }
        add(out, "<path d=\"" + line + "\" stroke=\"#0072b2\" stroke-width=\"2\" fill=\"none\"/>");
        text(out, 275, 308, "middle", "#1d232b", "door width [m]");
        text(out, LEFT, 20, "start", "#1d232b", "flow [persons/s], 500 agents");
        return out.append("</svg>\n").toString();
    }

    private static double x(double width) {
        return LEFT + (width - 0.6) * 215;
    }

    private static double y(double flow) {
        return BOTTOM - flow * 53.33;
    }

    private static void add(StringBuilder out, String element, Object... values) {
        out.append(String.format(Locale.ROOT, element, values)).append('\n');
    }

    private static void text(StringBuilder out, double x, double y, String anchor, String colour, String words) {
        add(out, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>", x, y, anchor, colour, words);
    }
}
