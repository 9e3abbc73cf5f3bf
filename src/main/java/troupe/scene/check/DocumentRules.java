package troupe.scene.check;

import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import troupe.scene.GridMemory;
import troupe.scene.Numbers;
import troupe.scene.Scene;
import troupe.scene.World;
import troupe.scene.check.SceneChecks.Findings;
import troupe.scene.setting.XmlText;

/** Checks the document as a whole: ids, the world, and whether its grid fits into memory. */
final class DocumentRules {
    private static final Pattern ID = Pattern.compile("[A-Za-z_][\\w.-]*");

    private static final Pattern COLOUR = Pattern.compile("(#[0-9a-fA-F]{6})?");

    /** The smallest edge of a cell in metres: far above the nanometre within which lengths count as equal. */
    private static final double SMALLEST_CELL = 1e-4;

    private DocumentRules() {}

    static void ids(Scene scene, Findings findings) {
        Set<String> seen = new HashSet<>();
        scene.elements().forEach(element -> {
            String id = element.id();
            idForm(id, findings);
            if (!seen.add(id)) {
                findings.error(id, "the id is used twice", "rename one of the two");
            }
        });
    }

    /** Tells whether a text may be an id. */
    static boolean isId(String text) {
        return ID.matcher(text).matches();
    }

    static void idForm(String id, Findings findings) {
        if (!isId(id)) {
            findings.error(id, "the id '" + id + "' is not allowed", "use a letter or _, then letters, digits, . _ -");
        }
    }

    static void texts(Scene scene, Findings findings) {
        text("", "the title", scene.title(), findings);
        scene.elements().forEach(element -> text(element.id(), "the label", element.label(), findings));
        scene.obstacles().forEach(o -> colour(o.id(), o.colour(), findings));
        scene.actors().forEach(a -> colour(a.id(), a.colour(), findings));
    }

    static void text(String id, String what, String text, Findings findings) {
        for (int i = 0; i < text.length(); i++) {
            if (!XmlText.isXml(text, i)) {
                findings.error(
                        id,
                        what + " holds the character U+" + Integer.toHexString(text.charAt(i)),
                        "take it away; a scene file cannot hold it");
                return;
            }
        }
    }

    static void colour(String id, String colour, Findings findings) {
        if (!COLOUR.matcher(colour).matches()) {
            findings.error(id, "the colour is '" + colour + "'", "write it as #rrggbb, or leave it out");
        }
    }

    static void world(Scene scene, Findings findings) {
        World world = scene.world();
        boolean sized = findings.number("", "the world's width", world.width(), 0, false)
                & findings.number("", "the world's depth", world.depth(), 0, false);
        if (findings.number("", "the world's cell", world.cell(), SMALLEST_CELL, true)
                && sized
                && world.cell() > Math.min(world.width(), world.depth())) {
            findings.error(
                    "",
                    "a cell of " + Numbers.text(world.cell()) + " m is larger than the world",
                    "choose a smaller cell");
        }
    }

    static void memory(Scene scene, Findings findings) {
        World world = scene.world();
        double cells = world.width() / world.cell() * (world.depth() / world.cell());
        if (!(cells > 0)) {
            return;
        }
        double most = GridMemory.mostCells();
        if (cells > most) {
            double fitting = Math.sqrt(world.width()) * Math.sqrt(world.depth()) / Math.sqrt(most) * 1.01;
            findings.error(
                    "",
                    String.format(
                            Locale.ROOT,
                            "a grid of %.3g cells needs %.3g GB; this Java may use %.3g GB",
                            cells,
                            cells * GridMemory.BYTES_PER_CELL / 1e9,
                            GridMemory.bytes() / 1e9),
                    String.format(Locale.ROOT, "a cell of %.4g m would fit", fitting));
        }
    }
}
