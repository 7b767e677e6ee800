package majic.link;

import java.lang.System.Logger;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Makes links from addresses, and knows those that are open. */
public final class Links {
    static final Logger LOG = System.getLogger(Links.class.getName());

    private static final Set<Link> OPEN = ConcurrentHashMap.newKeySet();

    private Links() {}

    /**
     * Makes the link for a robot's address, without opening it.
     *
     * @param address what stands behind the robot type's name: {@code //host}, {@code //host:port},
     *     {@code tcp://host:port}, or the name of a serial port
     * @param defaultPort the TCP port when the address names none; 0 if it must name one
     * @param baud speed of a serial port, baud
     * @return a link, not open
     * @throws IllegalArgumentException if it is no such address; the message says what one looks like
     */
    public static Link of(String address, int defaultPort, int baud) {
        if (address.startsWith("tcp://")) {
            return tcp(address.substring("tcp://".length()), defaultPort);
        }
        if (address.startsWith("//")) {
            return tcp(address.substring(2), defaultPort);
        }
        return new SerialLink(address, baud);
    }

    private static Link tcp(String hostAndPort, int defaultPort) {
        int colon = hostAndPort.lastIndexOf(':');
        boolean ipv6WithoutPort = hostAndPort.endsWith("]");
        String host = colon < 0 || ipv6WithoutPort ? hostAndPort : hostAndPort.substring(0, colon);
        int port = colon < 0 || ipv6WithoutPort ? defaultPort : port(hostAndPort.substring(colon + 1));
        if (host.isEmpty() || port < 1 || port > 65_535 || host.contains("/")) {
            throw new IllegalArgumentException("//" + hostAndPort + ": not an address; it looks like //192.168.1.20:"
                    + (defaultPort == 0 ? 4001 : defaultPort) + " with a port from 1 to 65535");
        }
        return new TcpLink(host, port);
    }

    private static int port(String text) {
        return text.matches("\\d{1,5}") ? Integer.parseInt(text) : -1;
    }

    /**
     * The traffic of all links that are open in this program. One that came to its end by itself is among them until its
     * reader has done what follows from that, and ended too.
     *
     * @return a snapshot
     */
    public static List<Traffic> traffic() {
        tidy();
        return OPEN.stream().map(Link::traffic).toList();
    }

    static void register(Link link) {
        tidy();
        OPEN.add(link);
    }

    /** Forgets those that are no longer open. */
    static void tidy() {
        OPEN.removeIf(link -> !link.traffic().open());
    }
}
