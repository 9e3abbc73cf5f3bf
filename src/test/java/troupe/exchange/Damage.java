package troupe.exchange;

import java.util.Arrays;
import java.util.Random;

/** Damages valid files: flips, overwrites, cuts out, doubles and swaps bytes. */
public final class Damage {
    private Damage() {}

    /** Returns a copy with one to four damages. */
    public static byte[] done(byte[] whole, Random random) {
        byte[] bytes = whole;
        for (int n = 1 + random.nextInt(4); n > 0; n--) {
            bytes = once(bytes, random);
        }
        return bytes;
    }

    private static byte[] once(byte[] whole, Random random) {
        if (whole.length == 0) {
            return whole;
        }
        int at = random.nextInt(whole.length);
        int length = Math.min(whole.length - at, 1 + random.nextInt(40));
        byte[] bytes = whole.clone();
        switch (random.nextInt(6)) {
            case 0 -> bytes[at] ^= (byte) (1 << random.nextInt(8));
            case 1 -> bytes[at] = (byte) random.nextInt(256);
            case 2 -> bytes[at] = (byte) "0123456789-.\n\teE@".charAt(random.nextInt(17));
            case 3 -> bytes = Arrays.copyOf(bytes, at);
            case 4 -> {
                System.arraycopy(whole, at + length, bytes, at, whole.length - at - length);
                bytes = Arrays.copyOf(bytes, whole.length - length);
            }
            default -> {
                bytes = Arrays.copyOf(whole, whole.length + length);
                System.arraycopy(whole, at, bytes, at + length, whole.length - at);
            }
        }
        return bytes;
    }
}
