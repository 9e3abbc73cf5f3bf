package troupe.risk;

import java.util.Arrays;
import java.util.List;
import troupe.scene.Avatar;

/**
 * Tells where an avatar is at any time: its script or recording as straight lines between knots; one that is
 * steered goes to where it was sent last, and stands there. Metres and seconds. Used by one thread at a time.
 */
public final class Course {
    private final double[] times;
    private final double[] xs;
    private final double[] ys;
    private final boolean recorded;
    private boolean steered;
    private double toX;
    private double toY;

    private Course(int knots, boolean recorded) {
        this.times = new double[knots];
        this.xs = new double[knots];
        this.ys = new double[knots];
        this.recorded = recorded;
    }

    /** Works out the course of an avatar. Cost O(knots). */
    public static Course of(Avatar avatar) {
        if (avatar.motion() instanceof Avatar.Recording recording) {
            return recorded(recording.fixes());
        }
        if (avatar.motion() instanceof Avatar.Script script) {
            return scripted(script);
        }
        Avatar.Pointer pointer = (Avatar.Pointer) avatar.motion();
        Course course = new Course(1, false);
        course.set(0, 0, pointer.start().x(), pointer.start().y());
        course.steered = true;
        course.toX = course.xs[0];
        course.toY = course.ys[0];
        return course;
    }

    private static Course recorded(List<Avatar.Fix> fixes) {
        Course course = new Course(fixes.size(), true);
        for (int k = 0; k < fixes.size(); k++) {
            course.set(k, fixes.get(k).time(), fixes.get(k).x(), fixes.get(k).y());
        }
        return course;
    }

    /** Works out when a script turns: at the time of the next goal, or where the goal before it is reached. */
    private static Course scripted(Avatar.Script script) {
        List<Avatar.Head> heads = script.heads();
        Course all = new Course(2 * heads.size() + 1, false);
        all.set(0, 0, script.start().x(), script.start().y());
        int last = 0;
        for (int k = 0; k < heads.size(); k++) {
            double at = heads.get(k).at().orElse(all.times[last]);
            if (at > all.times[last]) {
                // it stood there until the new goal came
                all.set(last + 1, at, all.xs[last], all.ys[last]);
                last++;
            }
            double dx = heads.get(k).to().x() - all.xs[last];
            double dy = heads.get(k).to().y() - all.ys[last];
            double way = Math.sqrt(dx * dx + dy * dy);
            double takes = way / script.pace();
            double next = k + 1 < heads.size()
                    ? heads.get(k + 1).at().orElse(Double.POSITIVE_INFINITY)
                    : Double.POSITIVE_INFINITY;
            double walked = Math.min(takes, next - all.times[last]);
            if (walked > 0) {
                double share = walked / takes;
                all.set(last + 1, all.times[last] + walked, all.xs[last] + share * dx, all.ys[last] + share * dy);
                last++;
            }
        }
        Course course = new Course(last + 1, false);
        for (int k = 0; k <= last; k++) {
            course.set(k, all.times[k], all.xs[k], all.ys[k]);
        }
        return course;
    }

    private void set(int k, double time, double x, double y) {
        times[k] = time;
        xs[k] = x;
        ys[k] = y;
    }

    /** Returns the time in seconds of the last turn; from then on the avatar stands, or is gone. */
    public double end() {
        return times[times.length - 1];
    }

    /** Sends a steered avatar to another x. */
    void sendToX(double x) {
        toX = x;
    }

    /** Sends a steered avatar to another y. */
    void sendToY(double y) {
        toY = y;
    }

    /** Lets a steered avatar go on for some seconds, straight to where it was sent; others do so by themselves. */
    void goOn(double seconds) {
        if (!steered) {
            return;
        }
        double dx = toX - xs[0];
        double dy = toY - ys[0];
        double way = Math.sqrt(dx * dx + dy * dy);
        double share = Math.min(1, Avatar.STEERED_PACE * seconds / Math.max(way, 1e-9));
        xs[0] += share * dx;
        ys[0] += share * dy;
    }

    /** Tells whether the avatar is there at a time. */
    public boolean isThere(double time) {
        return !recorded || time >= times[0] - 1e-9 && time <= times[times.length - 1] + 1e-9;
    }

    /** Returns the x in metres at a time, NaN if it is not there. */
    public double x(double time) {
        return at(xs, time);
    }

    /** Returns the y in metres at a time, NaN if it is not there. */
    public double y(double time) {
        return at(ys, time);
    }

    private double at(double[] values, double time) {
        if (!isThere(time)) {
            return Double.NaN;
        }
        int k = Arrays.binarySearch(times, time);
        k = k >= 0 ? k : -k - 2;
        if (k < 0 || k + 1 >= times.length) {
            return values[Math.max(0, Math.min(k, times.length - 1))];
        }
        double share = (time - times[k]) / (times[k + 1] - times[k]);
        return values[k] + share * (values[k + 1] - values[k]);
    }
}
