package troupe.app;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class XDisplayTest {
    @TempDir
    Path sockets;

    @Test
    void aDisplayAnswersWhileItsSocketListens() throws IOException {
        String display = ":59999";
        assertFalse(XDisplay.answers(display, sockets));
        try (ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            server.bind(UnixDomainSocketAddress.of(sockets.resolve("X59999")));
            assertTrue(XDisplay.answers(display, sockets));
            assertTrue(XDisplay.answers(display + ".0", sockets));
            assertFalse(XDisplay.answers(":59998", sockets));
        }
        assertFalse(XDisplay.answers(display, sockets), "a socket that nobody listens at is left behind");
    }

    @Test
    void namesOfAnotherFormAreBelieved() {
        assertTrue(XDisplay.answers("/private/tmp/com.apple.launchd/org.xquartz:0", sockets));
    }
}
