package troupe.app;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SocketChannel;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Tells whether an X display answers, before the window toolkit is asked: when the toolkit fails once, the
 * process can neither open windows nor draw pictures any more.
 */
final class XDisplay {
    private static final Pattern NAME = Pattern.compile("([^:/]*):([0-9]{1,5})(\\.[0-9]+)?");
    private static final int FIRST_PORT = 6_000;
    private static final int PATIENCE_MS = 2_000;

    private XDisplay() {}

    /**
     * Tells whether somebody listens at a display.
     *
     * @param name as in the environment variable {@code DISPLAY}; a name of another form is believed
     * @param sockets the folder of the sockets of local displays
     */
    static boolean answers(String name, Path sockets) {
        Matcher parts = NAME.matcher(name);
        if (!parts.matches()) {
            return true;
        }
        int number = Integer.parseInt(parts.group(2));
        String host = parts.group(1);
        return host.isEmpty() || host.equals("unix")
                ? local(sockets.resolve("X" + number)) || remote("localhost", FIRST_PORT + number)
                : remote(host, FIRST_PORT + number);
    }

    private static boolean local(Path socket) {
        try (SocketChannel channel = SocketChannel.open(StandardProtocolFamily.UNIX)) {
            return channel.connect(UnixDomainSocketAddress.of(socket));
        } catch (IOException | UnsupportedOperationException e) {
            return false;
        }
    }

    private static boolean remote(String host, int port) {
        if (port > 0xffff) {
            return false;
        }
        try (Socket socket = new Socket()) {
            socket.connect(new InetSocketAddress(host, port), PATIENCE_MS);
            return true;
        } catch (IOException e) {
            return false;
        }
    }
}
