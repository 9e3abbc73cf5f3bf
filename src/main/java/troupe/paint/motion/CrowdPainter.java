package troupe.paint.motion;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import troupe.paint.Labels;
import troupe.paint.Shapes;
import troupe.paint.Theme;
import troupe.paint.Tone;
import troupe.paint.Viewport;
import troupe.paint.scene.TaskPainter;
import troupe.run.frame.Frames;
import troupe.scene.Crowd;
import troupe.scene.CrowdGroup;
import troupe.scene.Place;

/**
 * Paints a crowd at a time: each agent as a disc of its radius that points where it heads, in the colour of its group
 * at a chosen level of the tree, with a trail of the last seconds; a flag at each goal. Agents far away are painted
 * as plain discs. Immutable; serves any thread.
 */
public final class CrowdPainter {
    /** The level that stands for each group's own colour. */
    public static final int DEEPEST = Integer.MAX_VALUE;

    private static final double TRAIL_SECONDS = 2;
    private static final double TRAIL_STEP = 0.2;
    /** More agents than this are painted without trails. */
    private static final int MOST_TRAILS = 2_000;

    /** Discs of a smaller radius in pixels have no sign. */
    private static final double LEAST_SIGNED = 3;

    private static final int ARRIVED = 2;
    /** Colours that differ for any colour vision: Okabe and Ito 2008, without black and yellow. */
    private static final int[] COLOURS = {0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0x56b4e9, 0xe69f00};

    private final Frames frames;
    private final Theme theme;
    private final boolean trails;
    private final List<Shown> shown = new ArrayList<>();
    private final List<Flag> flags = new ArrayList<>();

    /** A group's members: their channels, size, colour and mark. */
    private record Shown(
            int x, int y, int heading, int state, int count, double radius, Color colour, GroupMark mark) {}

    private record Flag(Place goal, Color colour) {}

    /** Paints a trail: {@code x0, y0, x1, y1, …} in pixels. */
    private interface TrailPainter {
        void paint(double[] xy, double width, Color colour);
    }

    /** Paints an agent at a pixel. */
    private interface AgentPainter {
        void paint(double x, double y, double headingRad, Color colour);
    }

    /** Makes a painter that colours by the deepest groups and shows trails. */
    public CrowdPainter(Crowd crowd, Frames frames, Theme theme) {
        this(crowd, frames, theme, DEEPEST, true);
    }

    /**
     * Makes a painter.
     *
     * @param level the depth of the groups whose colours are shown, from 1; {@link #DEEPEST} for the deepest
     * @param trails whether the last seconds of each agent's way are shown
     */
    public CrowdPainter(Crowd crowd, Frames frames, Theme theme, int level, boolean trails) {
        this.frames = frames;
        this.theme = theme;
        int[] number = new int[1];
        for (CrowdGroup group : crowd.groups()) {
            collect(group, 1, level, null, number, new int[1]);
        }
        this.trails = trails && shown.stream().mapToInt(Shown::count).sum() <= MOST_TRAILS;
    }

    /** Returns the colour of each group by its id, as {@link #DEEPEST} shows them. */
    public static Map<String, Color> colours(Crowd crowd) {
        Map<String, Color> all = new LinkedHashMap<>();
        int[] number = new int[1];
        crowd.groups().forEach(group -> collect(group, null, number, all));
        return all;
    }

    private static void collect(CrowdGroup group, Color above, int[] number, Map<String, Color> all) {
        Color colour = own(group, above, number);
        all.put(group.id(), colour);
        group.parts().forEach(part -> collect(part, colour, number, all));
    }

    private static Color own(CrowdGroup group, Color above, int[] number) {
        Color plain =
                above != null && group.colour().isEmpty() ? above : new Color(COLOURS[number[0]++ % COLOURS.length]);
        return Shapes.colour(group.colour(), plain);
    }

    private void collect(CrowdGroup group, int depth, int level, Color above, int[] number, int[] marks) {
        boolean own = depth <= level || above == null;
        Color colour = own ? own(group, above, number) : above;
        boolean last = depth >= level || group.parts().isEmpty();
        marks[0] += own && last ? 1 : 0;
        GroupMark mark = GroupMark.of(Math.max(0, marks[0] - 1));
        Color readable = theme.readable(colour);
        group.goal().ifPresent(goal -> flags.add(new Flag(goal, readable)));
        group.members().ifPresent(members -> {
            int x = frames.channel(group.id(), "x");
            if (x >= 0) {
                shown.add(new Shown(
                        x,
                        frames.channel(group.id(), "y"),
                        frames.channel(group.id(), "heading"),
                        frames.channel(group.id(), "state"),
                        members.count(),
                        members.radius(),
                        readable,
                        mark));
            }
        });
        for (CrowdGroup part : group.parts()) {
            collect(part, depth + 1, level, colour, number, marks);
        }
    }

    /** Paints flags, trails and agents at {@code time} seconds. */
    public void paint(Graphics2D graphics, Viewport view, double time) {
        paintGoals(graphics, view);
        paintAgents(graphics, view, time);
    }

    /** Paints a flag at each goal. */
    public void paintGoals(Graphics2D graphics, Viewport view) {
        Graphics2D g = Shapes.smooth(graphics);
        for (Flag flag : flags) {
            TaskPainter.paintGoal(g, theme, flag.colour(), flag.goal(), view);
        }
        g.dispose();
    }

    /** Paints trails and agents at {@code time} seconds. Cost O(agents). */
    public void paintAgents(Graphics2D graphics, Viewport view, double time) {
        if (frames.count() == 0) {
            return;
        }
        int frame = Track.frameAt(frames, time);
        Graphics2D g = Shapes.smooth(graphics);
        if (trails) {
            shown.forEach(group -> eachTrail(view, group, frame, (xy, width, colour) -> {
                g.setColor(colour);
                g.setStroke(Theme.line((float) width));
                g.draw(path(xy));
            }));
        }
        shown.forEach(group -> paintGroup(g, view, group, frame));
        g.dispose();
    }

    /**
     * Paints the same, pixel by pixel where agents are small and the graphics allow it, for windows in which thousands
     * move.
     */
    public void paintAgents(Graphics2D graphics, Viewport view, double time, AgentPixels pixels) {
        double largest = shown.stream()
                .mapToDouble(group -> discRadius(group, view))
                .max()
                .orElse(0);
        if (frames.count() == 0 || !pixels.begin(graphics) || !pixels.takes(largest)) {
            paintAgents(graphics, view, time);
            return;
        }
        int frame = Track.frameAt(frames, time);
        if (trails) {
            shown.forEach(group ->
                    eachTrail(view, group, frame, (xy, width, colour) -> pixels.line(xy, xy.length, width, colour)));
        }
        shown.forEach(group -> layGroup(pixels, view, group, frame));
        pixels.draw(graphics);
    }

    private void eachTrail(Viewport view, Shown group, int frame, TrailPainter painter) {
        int step = (int) Math.max(1, Math.round(TRAIL_STEP * frames.rate()));
        int first = (int) Math.max(0, frame - Math.round(TRAIL_SECONDS * frames.rate()));
        Color c = group.colour();
        Color pale = new Color(c.getRed(), c.getGreen(), c.getBlue(), 90);
        double width = Math.max(1, 0.3 * group.radius() * view.scale());
        double[] xy = new double[2 * ((frame - first) / step + 1)];
        for (int m = 0; m < group.count(); m++) {
            for (int k = 0; k < xy.length; k += 2) {
                xy[k] = px(view, group, frame - k / 2 * step, m);
                xy[k + 1] = py(view, group, frame - k / 2 * step, m);
            }
            painter.paint(xy, width, pale);
        }
    }

    private double px(Viewport view, Shown group, int frame, int m) {
        return view.px(frames.value(frame, group.x(), m));
    }

    private double py(Viewport view, Shown group, int frame, int m) {
        return view.py(frames.value(frame, group.y(), m));
    }

    private static Path2D path(double[] xy) {
        Path2D path = new Path2D.Double();
        path.moveTo(xy[0], xy[1]);
        for (int k = 2; k < xy.length; k += 2) {
            path.lineTo(xy[k], xy[k + 1]);
        }
        return path;
    }

    private static double discRadius(Shown group, Viewport view) {
        return Math.max(1.2, group.radius() * view.scale());
    }

    private void paintGroup(Graphics2D g, Viewport view, Shown group, int frame) {
        double r = discRadius(group, view);
        g.setStroke(Theme.line((float) Math.min(1.5, r / 5)));
        eachAgent(view, group, frame, (x, y, headingRad, colour) -> {
            g.setColor(colour);
            g.fill(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r));
            if (r >= LEAST_SIGNED) {
                g.setColor(theme.color(Tone.PANEL));
                group.mark().fill(g, x, y, r, headingRad);
            }
        });
    }

    private void layGroup(AgentPixels pixels, Viewport view, Shown group, int frame) {
        double r = discRadius(group, view);
        Color edge = theme.color(Tone.PANEL);
        pixels.size(r);
        eachAgent(view, group, frame, (x, y, headingRad, colour) -> {
            pixels.disc(x, y, colour);
            if (r >= LEAST_SIGNED) {
                pixels.sign(group.mark(), x, y, headingRad, edge);
            }
        });
    }

    private void eachAgent(Viewport view, Shown group, int frame, AgentPainter painter) {
        Color settled = Shapes.blend(group.colour(), theme.color(Tone.FLOOR), 0.45);
        for (int m = 0; m < group.count(); m++) {
            boolean arrived = frames.value(frame, group.state(), m) == ARRIVED;
            painter.paint(
                    px(view, group, frame, m),
                    py(view, group, frame, m),
                    frames.value(frame, group.heading(), m),
                    arrived ? settled : group.colour());
        }
    }

    /** Takes the room of the flags and of everybody, so that text keeps away from them. */
    public void takeRoom(Labels labels, Viewport view, double time) {
        for (Flag flag : flags) {
            double x = view.px(flag.goal().x());
            double y = view.py(flag.goal().y());
            labels.take(new Rectangle2D.Double(x - 2, y - 26, 20, 28));
        }
        if (frames.count() == 0 || Double.isNaN(time)) {
            return;
        }
        int frame = Track.frameAt(frames, time);
        for (Shown group : shown) {
            double r = Math.max(1, group.radius() * view.scale());
            for (int m = 0; m < group.count(); m++) {
                labels.take(new Rectangle2D.Double(
                        px(view, group, frame, m) - r, py(view, group, frame, m) - r, 2 * r, 2 * r));
            }
        }
    }
}
