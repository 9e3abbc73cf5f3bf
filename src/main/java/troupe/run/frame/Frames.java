package troupe.run.frame;

import java.util.List;

/**
 * Gives the frames of a run: equally spaced instants, frame {@code k} at {@code k / rate} seconds, each
 * with the values of every channel. Implementations are immutable and safe for any thread.
 */
public interface Frames {

    /** Returns the channels; the index of a channel in this list is its number. */
    List<Channel> channels();

    /** Returns the number of frames per second. */
    double rate();

    /** Returns the number of frames. */
    int count();

    /**
     * Returns value {@code k} of a channel in a frame; codes and whole numbers come as exact doubles.
     *
     * @throws IndexOutOfBoundsException if there is no such frame, channel or value
     */
    double value(int frame, int channel, int k);

    /** Returns the number of the named channel of an owner, or -1 if there is none. Cost O(channels). */
    default int channel(String owner, String name) {
        List<Channel> channels = channels();
        for (int i = 0; i < channels.size(); i++) {
            if (channels.get(i).owner().equals(owner) && channels.get(i).name().equals(name)) {
                return i;
            }
        }
        return -1;
    }

    /** Returns the time in seconds of the last frame, 0 if there are none. */
    default double duration() {
        return count() == 0 ? 0 : (count() - 1) / rate();
    }
}
