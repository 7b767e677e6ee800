package majic.link;

import java.lang.System.Logger;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Creates links from addresses, and lists the open ones. */
public final class Links {
    static final Logger LOG = System.getLogger(Links.class.getName());

    private static final Pattern HOST_AND_PORT =
            Pattern.compile("(\\[[0-9a-fA-F:.]+(?:%[\\w.-]+)?]|[^/:?#@\\s\\[\\]]+)(?::(\\d{1,5}))?");
    private static final int LARGEST_PORT = 65_535;
    private static final Set<Link> OPEN = ConcurrentHashMap.newKeySet();

    private Links() {}

    /**
     * Creates the link of a robot's address, without opening it. A robot that is connected more than once needs a
     * {@link LinkAddress}.
     *
     * @param address what follows the name of the robot type: {@code //host}, {@code //host:port},
     *     {@code tcp://host:port}, or the name of a serial port
     * @param defaultPort the TCP port when the address names none; 0 if it must name one
     * @param baud speed of a serial port, baud
     * @return a link, not open
     * @throws IllegalArgumentException if it is no such address; the message has an example
     */
    public static Link of(String address, int defaultPort, int baud) {
        return LinkAddress.of(address, defaultPort, baud).newLink();
    }

    /**
     * Creates a link over TLS (RFC 8446), without opening it. The server's certificate must be trusted by this Java and
     * be issued for the host.
     *
     * @param host the server's name or address
     * @param port its TCP port, 1 to 65535
     * @return a link, not open; {@link Link#open} throws an {@link javax.net.ssl.SSLException} if the server uses no
     *     TLS or is not trusted
     */
    public static Link secure(String host, int port) {
        return new TcpLink(host, port, new TcpConnector(host, port), new TlsLayer(host, port));
    }

    /**
     * Reads host and port from a network address.
     *
     * @param address {@code //host}, {@code //host:port} or {@code tcp://host:port}; an IPv6 address is in square
     *     brackets
     * @param defaultPort the port when the address names none; 0 if it must name one
     * @return both, the host's name not looked up
     * @throws IllegalArgumentException if it is no such address; the message has an example
     */
    public static InetSocketAddress server(String address, int defaultPort) {
        String hostAndPort = address.replaceFirst("^(tcp:)?//", "");
        Matcher form = HOST_AND_PORT.matcher(hostAndPort);
        int port = form.matches() ? port(form.group(2), defaultPort) : 0;
        if (port < 1 || port > LARGEST_PORT) {
            throw new IllegalArgumentException("//" + hostAndPort + ": not an address; it looks like //192.168.1.20:"
                    + (defaultPort == 0 ? 4001 : defaultPort) + " with a port from 1 to 65535");
        }
        return InetSocketAddress.createUnresolved(form.group(1), port);
    }

    private static int port(@Nullable String digits, int defaultPort) {
        return digits == null ? defaultPort : Integer.parseInt(digits);
    }

    /**
     * The traffic of all open links of this program. A link that has ended by itself is included until its reader
     * thread has handled the end and ended too.
     *
     * @return a snapshot
     */
    public static List<Traffic> traffic() {
        List<Traffic> traffic = new ArrayList<>();
        for (Link link : OPEN) {
            Traffic counts = link.traffic();
            if (counts.open()) {
                traffic.add(counts);
            } else {
                OPEN.remove(link);
            }
        }
        return traffic;
    }

    static void register(Link link) {
        tidy();
        OPEN.add(link);
    }

    /** Removes links that are no longer open. */
    static void tidy() {
        OPEN.removeIf(link -> !link.traffic().open());
    }
}
