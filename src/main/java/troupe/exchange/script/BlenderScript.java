package troupe.exchange.script;

import java.awt.Color;
import java.util.Locale;
import troupe.exchange.format.Decimals;
import troupe.geometry.Polygon;

/**
 * Writes Python for Blender 2.93 to 5. The samples of a solid stand in one text, a line each, so that long runs
 * stay quick to read in; frame 0 is the first sample.
 */
public final class BlenderScript implements SceneScript {
    private static final String FUNCTIONS = """
            import math
            import bpy

            scene = bpy.context.scene
            stage = bpy.data.collections.new("troupe")
            scene.collection.children.link(stage)
            paints = {}
            things = {}


            def paint(colour):
                if colour not in paints:
                    material = bpy.data.materials.new("troupe %02x%02x%02x" % colour)
                    material.diffuse_color = tuple((c / 255) ** 2.2 for c in colour) + (1.0,)
                    material.use_nodes = True
                    shader = next((n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED"), None)
                    if shader is not None:
                        shader.inputs["Base Color"].default_value = material.diffuse_color
                    paints[colour] = material
                return paints[colour]


            def solid(name, corners, bottom, height, colour):
                n = len(corners)
                points = [(x, y, bottom) for x, y in corners] + [(x, y, bottom + height) for x, y in corners]
                sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
                mesh = bpy.data.meshes.new(name)
                mesh.from_pydata(points, [], [tuple(reversed(range(n))), tuple(range(n, 2 * n))] + sides)
                mesh.materials.append(paint(colour))
                thing = bpy.data.objects.new(name, mesh)
                stage.objects.link(thing)
                # by the name in the scene: Blender changes one that is taken
                things[name] = thing


            def curve(thing, path, index):
                data = thing.animation_data or thing.animation_data_create()
                if data.action is None:
                    data.action = bpy.data.actions.new(thing.name)
                if hasattr(data.action, "fcurve_ensure_for_datablock"):
                    return data.action.fcurve_ensure_for_datablock(thing, path, index=index)
                return data.action.fcurves.find(path, index=index) or data.action.fcurves.new(path, index=index)


            def keys(thing, path, index, first, values, constant=False):
                points = curve(thing, path, index).keyframe_points
                old = len(points)
                places = [0.0] * (2 * old)
                points.foreach_get("co", places)
                for k, value in enumerate(values):
                    places += (first + k, value)
                points.add(len(values))
                points.foreach_set("co", places)
                for k in range(old, len(points)):
                    points[k].interpolation = "CONSTANT" if constant else "LINEAR"


            def move(thing, first, samples):
                rows = [tuple(map(float, line.split())) for line in samples.split("\\n") if line]
                for index in range(3):
                    keys(thing, "location", index, first, [row[index] for row in rows])
                keys(thing, "rotation_euler", 2, first, [math.radians(row[3]) for row in rows])


            def show(thing, frame, shown):
                for path in ("hide_viewport", "hide_render"):
                    keys(thing, path, 0, frame, [0.0 if shown else 1.0], constant=True)


            """;

    private final StringBuilder out = new StringBuilder();
    private double rate;
    private int frames;
    private boolean moving;

    /** Makes an empty script. */
    public BlenderScript() {}

    @Override
    public void begin(String title, double perSecond, int count) {
        rate = perSecond;
        frames = count;
        out.append("# ").append(SceneScript.plain(title)).append('\n');
        out.append("# Made by Troupe for Blender: blender --python FILE, or the text editor. Metres, frame 0 first.\n");
        out.append(FUNCTIONS);
    }

    @Override
    public void solid(String id, Polygon outline, double bottom, double height, Color colour) {
        out.append("solid(\"").append(escaped(id)).append("\", [");
        for (int i = 0; i < outline.size(); i++) {
            out.append(i == 0 ? "(" : ", (").append(Decimals.trimmed(outline.x(i)));
            out.append(", ").append(Decimals.trimmed(outline.y(i))).append(')');
        }
        out.append("], ").append(Decimals.trimmed(bottom)).append(", ").append(Decimals.trimmed(height));
        out.append(", (").append(colour.getRed()).append(", ").append(colour.getGreen());
        out.append(", ").append(colour.getBlue()).append("))\n");
    }

    @Override
    public void beginKeys(String id) {
        out.append("thing = things[\"").append(escaped(id)).append("\"]\n");
    }

    private static String escaped(String id) {
        StringBuilder text = new StringBuilder();
        for (char c : id.toCharArray()) {
            boolean plain = c < 128 && (Character.isLetterOrDigit(c) || c == '_' || c == '-' || c == '.');
            text.append(plain ? String.valueOf(c) : String.format(Locale.ROOT, "\\u%04x", (int) c));
        }
        return text.toString();
    }

    @Override
    public void key(int frame, double x, double y, double z, double degrees) {
        if (!moving) {
            out.append("move(thing, ").append(frame).append(", \"\"\"\n");
            moving = true;
        }
        out.append(Decimals.trimmed(x)).append(' ').append(Decimals.trimmed(y)).append(' ');
        out.append(Decimals.trimmed(z)).append(' ').append(Decimals.trimmed(degrees));
        out.append('\n');
    }

    @Override
    public void shown(int frame, boolean shown) {
        endKeys();
        out.append("show(thing, ").append(frame).append(", ").append(shown ? "True" : "False");
        out.append(")\n");
    }

    @Override
    public void endKeys() {
        if (moving) {
            out.append("\"\"\")\n");
            moving = false;
        }
    }

    @Override
    public void end() {
        long whole = Math.max(1, Math.round(rate));
        out.append("scene.frame_start = 0\nscene.frame_end = ").append(Math.max(0, frames - 1));
        out.append("\nscene.render.fps = ").append(whole).append("\nscene.render.fps_base = ");
        out.append(Decimals.trimmed(whole / rate)).append('\n');
    }

    @Override
    public String take() {
        String text = out.toString();
        out.setLength(0);
        return text;
    }
}
