package troupe.run.file;

import java.io.EOFException;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Arrays;
import java.util.Optional;
import troupe.run.Digest;

/**
 * One record of a journal: a kind, the length of its content as a little-endian 32-bit number, the SHA-256 of
 * both and the content, and the content ({@code docs/run-format.md}).
 *
 * @param kind one of the constants
 * @param content not to be changed
 */
record JournalRecord(byte kind, byte[] content) {
    /** What every journal begins with. */
    static final byte[] MAGIC = "troupe journal 1\n".getBytes(StandardCharsets.US_ASCII);

    static final byte SCENE = 'S';
    static final byte MANIFEST = 'R';
    static final byte INPUT = 'I';
    static final byte FRAMES = 'F';
    /** Bytes of a record before its content. */
    static final int HEAD = 1 + 4 + 32;

    /** Returns the bytes of the record. */
    ByteBuffer bytes() {
        ByteBuffer buffer = ByteBuffer.allocate(HEAD + content.length).order(ByteOrder.LITTLE_ENDIAN);
        buffer.put(kind).putInt(content.length);
        MessageDigest digest = Digest.sha256();
        digest.update(buffer.array(), 0, 5);
        digest.update(content);
        return buffer.put(digest.digest()).put(content).flip();
    }

    /**
     * Reads the record at the place where the file stands, and leaves the file behind it; nothing if it is cut
     * off, damaged, or claims more than {@code most} bytes of content.
     */
    static Optional<JournalRecord> read(RandomAccessFile file, int most) throws IOException {
        byte[] head = new byte[HEAD];
        try {
            file.readFully(head);
            int length = ByteBuffer.wrap(head).order(ByteOrder.LITTLE_ENDIAN).getInt(1);
            if (length < 0 || length > most || length > file.length() - file.getFilePointer()) {
                return Optional.empty();
            }
            byte[] content = new byte[length];
            file.readFully(content);
            MessageDigest digest = Digest.sha256();
            digest.update(head, 0, 5);
            digest.update(content);
            boolean whole = Arrays.equals(digest.digest(), 0, 32, head, 5, HEAD);
            return whole ? Optional.of(new JournalRecord(head[0], content)) : Optional.empty();
        } catch (EOFException e) {
            return Optional.empty();
        }
    }
}
