package troupe.app.play;

import troupe.app.document.EventThread;
import troupe.app.document.Listeners;

/**
 * Holds the moment of a run that is shown, and how it goes on: playing or not, speed, loop. It has no
 * clock of its own; {@link #advance} is told how much time has passed. Belongs to the event thread.
 */
public final class Playback {
    /** The slowest speed, in seconds of the run per second. */
    public static final double MIN_SPEED = 0.1;

    /** The fastest speed, in seconds of the run per second. */
    public static final double MAX_SPEED = 100;

    /** The speeds that are offered. */
    private static final double[] SPEEDS = {0.1, 0.25, 0.5, 1, 2, 4, 10, 25, 100};

    private final Listeners<Playback> listeners = new Listeners<>();
    private double duration;
    private double rate = 25;
    private double time;
    private double speed = 1;
    private boolean playing;
    private boolean loop;
    private boolean growing;

    /** Returns the observers, told after each change. */
    public Listeners<Playback> listeners() {
        return listeners;
    }

    /** Returns the moment shown, in seconds from 0 to {@link #duration()}. */
    public double time() {
        return time;
    }

    /** Returns the length of the run in seconds, 0 if there is none. */
    public double duration() {
        return duration;
    }

    /** Returns seconds of the run per second. */
    public double speed() {
        return speed;
    }

    /** Tells whether it plays. */
    public boolean isPlaying() {
        return playing;
    }

    /** Tells whether it begins anew at the end. */
    public boolean isLooping() {
        return loop;
    }

    /**
     * Takes another run: its length in seconds and its frames per second, above 0. The moment shown
     * stays, as far as the run has it; one that plays goes on playing.
     */
    public void load(double seconds, double framesPerSecond) {
        load(seconds, framesPerSecond, false);
    }

    /** Takes another run that may grow still: where it ends now, playing waits for more instead of stopping. */
    public void load(double seconds, double framesPerSecond, boolean mayGrow) {
        EventThread.require();
        growing = mayGrow;
        duration = Math.max(0, seconds);
        rate = framesPerSecond;
        time = Math.min(time, duration);
        playing &= duration > 0 || growing;
        listeners.tell(this);
    }

    /** Plays from the moment shown, or from the beginning if that is the end. */
    public void play() {
        EventThread.require();
        if (duration > 0) {
            time = time >= duration && !growing ? 0 : time;
            playing = true;
            listeners.tell(this);
        }
    }

    /** Stops at the moment shown. */
    public void pause() {
        EventThread.require();
        playing = false;
        listeners.tell(this);
    }

    /** Plays if it does not, else stops. */
    public void toggle() {
        if (playing) {
            pause();
        } else {
            play();
        }
    }

    /** Shows another moment, in seconds; one outside the run becomes its nearer end. */
    public void seek(double seconds) {
        EventThread.require();
        time = Math.max(0, Math.min(duration, seconds));
        listeners.tell(this);
    }

    /** Stops, and shows the moment {@code frames} frames later, earlier if negative. */
    public void step(int frames) {
        playing = false;
        seek((Math.rint(time * rate) + frames) / rate);
    }

    /** Goes on or off beginning anew at the end. */
    public void setLooping(boolean on) {
        EventThread.require();
        loop = on;
        listeners.tell(this);
    }

    /**
     * Changes the speed.
     *
     * @throws IllegalArgumentException if it is outside {@link #MIN_SPEED} to {@link #MAX_SPEED}
     */
    public void setSpeed(double factor) {
        EventThread.require();
        if (!(factor >= MIN_SPEED && factor <= MAX_SPEED)) {
            throw new IllegalArgumentException(
                    "speed " + factor + "; needs a number from " + MIN_SPEED + " to " + MAX_SPEED);
        }
        speed = factor;
        listeners.tell(this);
    }

    /** Returns the speeds that are offered, the slowest first; a new array. */
    public static double[] speeds() {
        return SPEEDS.clone();
    }

    /** Lets {@code seconds} of real time pass, at least 0; does nothing while it does not play. */
    public void advance(double seconds) {
        EventThread.require();
        if (!playing) {
            return;
        }
        double next = time + seconds * speed;
        if (next >= duration && growing) {
            next = duration;
        } else if (next >= duration) {
            next = loop ? next % duration : duration;
            playing = loop;
        }
        time = next;
        listeners.tell(this);
    }
}
