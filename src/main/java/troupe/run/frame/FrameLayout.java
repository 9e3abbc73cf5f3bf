package troupe.run.frame;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.List;

/**
 * Lays the values of one frame out in bytes: the channels in order, the values of a channel in order,
 * each little-endian, without padding. The same layout serves memory, run files and digests.
 * Immutable, safe for any thread.
 */
public final class FrameLayout {
    private static final VarHandle F64 = MethodHandles.byteArrayViewVarHandle(double[].class, ByteOrder.LITTLE_ENDIAN);
    private static final VarHandle F32 = MethodHandles.byteArrayViewVarHandle(float[].class, ByteOrder.LITTLE_ENDIAN);
    private static final VarHandle I32 = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    /** The most bytes of one frame, so that sizes stay exact in {@code int}. */
    public static final int MAX_FRAME_BYTES = 1 << 24;

    private final List<Channel> channels;
    private final int[] offsets;
    private final int bytes;
    private final int slots;

    /**
     * Lays the given channels out.
     *
     * @throws IllegalArgumentException if a frame would take more than {@link #MAX_FRAME_BYTES}
     */
    public FrameLayout(List<Channel> channels) {
        this.channels = List.copyOf(channels);
        offsets = new int[channels.size()];
        long size = 0;
        int values = 0;
        for (int i = 0; i < offsets.length; i++) {
            Channel channel = channels.get(i);
            offsets[i] = (int) size;
            size += (long) channel.width() * channel.type().bytes();
            if (size > MAX_FRAME_BYTES) {
                throw new IllegalArgumentException(
                        "frame of more than " + MAX_FRAME_BYTES + " bytes from channel '" + channel.name() + "' on");
            }
            values += channel.width();
        }
        bytes = (int) size;
        slots = values;
    }

    /** Returns the channels in their order. */
    public List<Channel> channels() {
        return channels;
    }

    /** Returns the bytes of a frame. */
    public int bytes() {
        return bytes;
    }

    /** Returns the values of a frame over all channels. */
    public int slots() {
        return slots;
    }

    /** Reads value {@code k} of a channel from the frame that begins at {@code at}. */
    public double get(byte[] source, int at, int channel, int k) {
        Channel c = channels.get(channel);
        if (k < 0 || k >= c.width()) {
            throw new IndexOutOfBoundsException(
                    "value " + k + " of channel '" + c.name() + "'; needs 0 to " + (c.width() - 1));
        }
        int place = at + offsets[channel] + k * c.type().bytes();
        return switch (c.type()) {
            case F64 -> (double) F64.get(source, place);
            case F32 -> (float) F32.get(source, place);
            case I32 -> (int) I32.get(source, place);
            case U8 -> source[place] & 0xff;
        };
    }

    /**
     * Writes value {@code k} of a channel into the frame that begins at {@code at}. Every NaN is written
     * with the same bits, and -0 as it is.
     *
     * @throws IllegalArgumentException if a channel of whole numbers cannot hold the value exactly
     */
    public void put(byte[] target, int at, int channel, int k, double value) {
        Channel c = channels.get(channel);
        int place = at + offsets[channel] + k * c.type().bytes();
        switch (c.type()) {
            case F64 -> F64.set(target, place, Double.isNaN(value) ? Double.NaN : value);
            case F32 -> F32.set(target, place, Double.isNaN(value) ? Float.NaN : (float) value);
            case I32 -> I32.set(target, place, whole(c, value, Integer.MIN_VALUE, Integer.MAX_VALUE));
            case U8 -> target[place] = (byte) whole(c, value, 0, 255);
        }
    }

    private static int whole(Channel channel, double value, int least, int most) {
        if (!(value >= least && value <= most) || value != Math.rint(value)) {
            throw new IllegalArgumentException("channel '" + channel.name() + "' = " + value
                    + "; needs a whole number from " + least + " to " + most);
        }
        return (int) value;
    }

    /** Writes a frame of any implementation into {@code target} from {@code at} on. */
    public void copy(Frames frames, int frame, byte[] target, int at) {
        for (int c = 0; c < offsets.length; c++) {
            int width = channels.get(c).width();
            for (int k = 0; k < width; k++) {
                put(target, at, c, k, frames.value(frame, c, k));
            }
        }
    }
}
