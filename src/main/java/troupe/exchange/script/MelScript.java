package troupe.exchange.script;

import java.awt.Color;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import troupe.exchange.format.Decimals;
import troupe.geometry.Polygon;

/**
 * Writes MEL, the language of Maya (Crowd section 4.4). Outlines become facets that are extruded and closed; keys
 * are set in seconds, so that the frame rate of the user's scene does not matter. Units are set to metres and
 * degrees while the script runs and then put back; where y is up the whole stage is turned.
 */
public final class MelScript implements SceneScript {
    private static final String PROCEDURES = """
            global proc string troupePaint(float $r, float $g, float $b) {
                string $shader = `shadingNode -asShader lambert -name "troupePaint"`;
                setAttr ($shader + ".color") -type double3 $r $g $b;
                string $group = `sets -renderable true -noSurfaceShader true -empty -name ($shader + "SG")`;
                connectAttr -force ($shader + ".outColor") ($group + ".surfaceShader");
                return $group;
            }
            global proc string troupeRaise(string $node, float $height, string $paint, string $stage) {
                polyExtrudeFacet -constructionHistory off -localTranslateZ $height ($node + ".f[0]");
                polyCloseBorder -constructionHistory off $node;
                sets -edit -forceElement $paint $node;
                string $put[] = `parent -relative $node $stage`;
                return $put[0];
            }
            global proc troupeKey(string $node, string $time, float $x, float $y, float $z, float $turn) {
                setKeyframe -time $time -value $x -attribute "translateX" -inTangentType "linear" -outTangentType "linear" $node;
                setKeyframe -time $time -value $y -attribute "translateY" -inTangentType "linear" -outTangentType "linear" $node;
                setKeyframe -time $time -value $z -attribute "translateZ" -inTangentType "linear" -outTangentType "linear" $node;
                setKeyframe -time $time -value $turn -attribute "rotateZ" -inTangentType "linear" -outTangentType "linear" $node;
            }
            global proc troupeShow(string $node, string $time, int $shown) {
                setKeyframe -time $time -value $shown -attribute "visibility" -outTangentType "step" $node;
            }
            """;
    private static final String BEGIN = """
            string $troupeLinear = `currentUnit -query -linear`;
            string $troupeAngle = `currentUnit -query -angle`;
            currentUnit -linear "m" -angle "deg";
            string $troupeStage = `group -empty -world -name "troupe"`;
            string $troupeMade[];
            string $troupeNodes[];
            string $troupeNode;
            """;

    private final StringBuilder out = new StringBuilder();
    private final Map<String, Integer> numbers = new TreeMap<>();
    private final Set<String> taken = new TreeSet<>(Set.of("troupe", "troupepaint"));
    private final Map<Integer, String> paints = new TreeMap<>();
    private double rate;
    private int frames;

    /** Makes an empty script. */
    public MelScript() {}

    @Override
    public void begin(String title, double perSecond, int count) {
        rate = perSecond;
        frames = count;
        out.append("// ").append(SceneScript.plain(title)).append('\n');
        out.append("// Made by Troupe for Maya: File > Source Script. Metres, seconds and degrees.\n");
        out.append(PROCEDURES).append(BEGIN);
    }

    @Override
    public void solid(String id, Polygon outline, double bottom, double height, Color colour) {
        String paint = paint(colour);
        out.append("$troupeMade = `polyCreateFacet -constructionHistory off -name \"")
                .append(node(id))
                .append('"');
        for (int i = 0; i < outline.size(); i++) {
            out.append(" -point ").append(Decimals.trimmed(outline.x(i)));
            out.append(' ').append(Decimals.trimmed(outline.y(i)));
            out.append(' ').append(Decimals.trimmed(bottom));
        }
        out.append("`;\n$troupeNodes[").append(numbers.size()).append("] = troupeRaise($troupeMade[0], ");
        out.append(Decimals.trimmed(height)).append(", ").append(paint).append(", $troupeStage);\n");
        numbers.put(id, numbers.size());
    }

    private String paint(Color colour) {
        return paints.computeIfAbsent(colour.getRGB(), rgb -> {
            String name = "$troupePaint" + (paints.size() + 1);
            out.append("string ").append(name).append(" = troupePaint(");
            out.append(Decimals.trimmed(colour.getRed() / 255.0)).append(", ");
            out.append(Decimals.trimmed(colour.getGreen() / 255.0)).append(", ");
            out.append(Decimals.trimmed(colour.getBlue() / 255.0)).append(");\n");
            return name;
        });
    }

    /** Returns a name of letters, digits and underscores, unlike every other whatever the case. */
    private String node(String id) {
        String plain = id.replaceAll("[^A-Za-z0-9_]", "_");
        String name = plain;
        for (int k = 2; !taken.add(name.toLowerCase(Locale.ROOT)); k++) {
            name = plain + "_" + k;
        }
        return name;
    }

    @Override
    public void beginKeys(String id) {
        // by number: a name may be taken in the user's scene, where Maya changes it
        out.append("$troupeNode = $troupeNodes[").append(numbers.get(id)).append("];\n");
    }

    @Override
    public void key(int frame, double x, double y, double z, double degrees) {
        out.append("troupeKey($troupeNode, \"")
                .append(Decimals.trimmed(frame / rate))
                .append("sec\", ");
        out.append(Decimals.trimmed(x)).append(", ").append(Decimals.trimmed(y)).append(", ");
        out.append(Decimals.trimmed(z)).append(", ").append(Decimals.trimmed(degrees));
        out.append(");\n");
    }

    @Override
    public void shown(int frame, boolean shown) {
        out.append("troupeShow($troupeNode, \"")
                .append(Decimals.trimmed(frame / rate))
                .append("sec\", ");
        out.append(shown ? 1 : 0).append(");\n");
    }

    @Override
    public void endKeys() {
        // nothing has to be closed
    }

    @Override
    public void end() {
        String last = "\"" + Decimals.trimmed(Math.max(0, frames - 1) / rate) + "sec\"";
        out.append("playbackOptions -minTime \"0sec\" -animationStartTime \"0sec\" -maxTime ")
                .append(last);
        out.append(" -animationEndTime ").append(last).append(";\n");
        out.append("if (`upAxis -query -axis` == \"y\") setAttr ($troupeStage + \".rotateX\") -90;\n");
        out.append("currentUnit -linear $troupeLinear -angle $troupeAngle;\n");
    }

    @Override
    public String take() {
        String text = out.toString();
        out.setLength(0);
        return text;
    }
}
