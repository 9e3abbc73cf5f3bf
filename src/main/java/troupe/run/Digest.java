package troupe.run;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import troupe.run.frame.Channel;
import troupe.run.frame.FrameLayout;
import troupe.run.frame.Frames;

/**
 * Takes the fingerprint of frames: SHA-256 over the channels (name, unit, type, owner, width), the rate, the
 * number of frames and every value, in the layout of run files. Report and times take no part, so that
 * equal scene, settings and seed give equal digests on any machine.
 */
public final class Digest {
    private Digest() {}

    /** Returns the digest as 64 lower-case hexadecimal digits. Cost O(values). */
    public static String of(Frames frames) {
        MessageDigest digest = begin(frames.channels(), frames.rate(), frames.count());
        FrameLayout layout = new FrameLayout(frames.channels());
        byte[] bytes = new byte[layout.bytes()];
        for (int frame = 0; frame < frames.count(); frame++) {
            layout.copy(frames, frame, bytes, 0);
            digest.update(bytes);
        }
        return HexFormat.of().formatHex(digest.digest());
    }

    /** Returns the digest of some bytes as 64 lower-case hexadecimal digits. */
    public static String of(byte[] bytes) {
        return HexFormat.of().formatHex(sha256().digest(bytes));
    }

    /** Begins a digest that wants the bytes of every frame in order. */
    public static MessageDigest begin(List<Channel> all, double rate, int count) {
        StringBuilder channels = new StringBuilder();
        for (Channel c : all) {
            channels.append(c.name()).append('\0').append(c.unit()).append('\0');
            channels.append(c.type()).append('\0').append(c.owner()).append('\0');
            channels.append(c.width()).append('\n');
        }
        MessageDigest digest = sha256();
        digest.update(channels.toString().getBytes(StandardCharsets.UTF_8));
        digest.update(ByteBuffer.allocate(12)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putDouble(rate)
                .putInt(count)
                .array());
        return digest;
    }

    /** Begins an empty SHA-256. */
    public static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("this Java lacks SHA-256, which every Java must have", e);
        }
    }
}
