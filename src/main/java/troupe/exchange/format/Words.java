package troupe.exchange.format;

import java.util.List;
import troupe.paint.motion.Track;
import troupe.run.frame.Frames;

/**
 * Tells what a thing does in each frame in one word: its ability, or else its action (channel {@code action} of an
 * encounter), or else nothing.
 */
public final class Words {
    private final Frames frames;
    private final Track track;
    private final int action;
    private final List<String> actions;

    /** Reads the words of one owner from frames. */
    public Words(Frames frames, Track track) {
        this.frames = frames;
        this.track = track;
        this.action = frames.channel(track.owner(), "action");
        this.actions = action < 0
                ? List.of()
                : List.of(frames.channels().get(action).unit().split(","));
    }

    /** Returns the word of a frame, empty if the run does not tell. */
    public String at(int frame) {
        String ability = track.ability(frame);
        if (!ability.isEmpty() || action < 0) {
            return ability;
        }
        int code = (int) frames.value(frame, action, 0);
        return code < actions.size() ? actions.get(code) : "";
    }
}
