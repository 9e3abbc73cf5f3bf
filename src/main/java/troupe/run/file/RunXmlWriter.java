package troupe.run.file;

import java.util.List;
import java.util.Map;
import java.util.StringJoiner;
import troupe.run.Report;
import troupe.run.Run;
import troupe.run.frame.Channel;
import troupe.scene.setting.XmlText;
import troupe.search.Outcome;

/** Writes {@code run.xml}: one element per line, attributes in the order of the schema. Used once. */
final class RunXmlWriter {
    private final StringBuilder out = new StringBuilder();
    private int depth;

    private RunXmlWriter() {}

    /**
     * Returns the text of a manifest.
     *
     * @throws IllegalArgumentException if a text holds a character that XML cannot
     */
    static String write(RunManifest manifest) {
        RunXmlWriter writer = new RunXmlWriter();
        writer.out.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        writer.run(manifest);
        return writer.out.toString();
    }

    private void run(RunManifest m) {
        open(
                "run",
                "xmlns",
                RunManifest.NAMESPACE,
                "version",
                RunManifest.VERSION,
                "program",
                m.program(),
                "task",
                m.task(),
                "seed",
                m.seed());
        m.settings().forEach((key, value) -> empty("setting", "key", key, "value", value));
        outcome(m.outcome());
        report("report", null, m.report());
        empty("scene", "sha256", m.sceneHash());
        open("frames", "rate", m.rate(), "count", m.count(), "digest", m.digest());
        for (Channel c : m.channels()) {
            empty(
                    "channel", "owner", c.owner(), "name", c.name(), "unit", c.unit(), "type", c.type(), "width",
                    c.width());
        }
        for (String hash : m.partHashes()) {
            empty("part", "sha256", hash);
        }
        close("frames");
        for (Run.Leg leg : m.legs()) {
            leg(leg);
        }
        for (Run.Input input : m.inputs()) {
            empty("input", "step", input.step(), "key", input.key(), "value", input.value());
        }
        close("run");
    }

    private void outcome(Outcome outcome) {
        if (outcome instanceof Outcome.Infeasible infeasible) {
            empty("outcome", "word", outcome.word(), "reason", infeasible.reason());
        } else {
            empty("outcome", "word", outcome.word());
        }
    }

    private void leg(Run.Leg leg) {
        StringJoiner points = new StringJoiner(" ");
        for (double[] p : leg.points()) {
            points.add(number(p[0]) + "," + number(p[1]) + "," + number(p[2]));
        }
        empty(
                "leg",
                "actor",
                leg.actor(),
                "ability",
                leg.ability(),
                "what",
                leg.what(),
                "begin",
                leg.begin(),
                "end",
                leg.end(),
                "energy",
                leg.energy(),
                "points",
                points);
    }

    private void report(String element, String name, Report report) {
        openNamed(element, name);
        for (Map.Entry<String, Object> entry : report.values().entrySet()) {
            value(entry.getKey(), entry.getValue());
        }
        close(element);
    }

    private void value(String name, Object value) {
        if (value instanceof Report report) {
            report("report", name, report);
        } else if (value instanceof List<?> list) {
            openNamed("list", name);
            list.forEach(v -> value(null, v));
            close("list");
        } else {
            String kind = value instanceof Boolean
                    ? "truth"
                    : value instanceof Long ? "whole" : value instanceof Double ? "number" : "text";
            if (name == null) {
                empty(kind, "value", value);
            } else {
                empty(kind, "name", name, "value", value);
            }
        }
    }

    private void openNamed(String element, String name) {
        if (name == null) {
            open(element);
        } else {
            open(element, "name", name);
        }
    }

    private void open(String element, Object... attributes) {
        tag(element, attributes);
        out.append(">\n");
        depth++;
    }

    private void empty(String element, Object... attributes) {
        tag(element, attributes);
        out.append("/>\n");
    }

    private void close(String element) {
        depth--;
        out.append("  ".repeat(depth)).append("</").append(element).append(">\n");
    }

    private void tag(String element, Object... attributes) {
        out.append("  ".repeat(depth)).append('<').append(element);
        for (int i = 0; i < attributes.length; i += 2) {
            out.append(' ').append(attributes[i]).append("=\"");
            Object value = attributes[i + 1];
            XmlText.escape(value instanceof Double d ? number(d) : value.toString(), out);
            out.append('"');
        }
    }

    private static String number(double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException("number " + value + " in a run; needs a finite one");
        }
        return Double.toString(value);
    }
}
