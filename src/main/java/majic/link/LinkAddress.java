package majic.link;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * The address of one robot, which makes a link for each of its connections. All of them are to the same device: behind
 * the first link to a serial port, the others are to the same adapter, whatever its port is called by then.
 * Thread-safe.
 */
public final class LinkAddress {
    private final String text;
    private final Optional<SerialAddress> serial;
    private final Supplier<Link> links;

    private LinkAddress(String text, Optional<SerialAddress> serial, Supplier<Link> links) {
        this.text = text;
        this.serial = serial;
        this.links = links;
    }

    /**
     * Reads the address of a robot.
     *
     * @param address what follows the name of the robot type: {@code //host}, {@code //host:port},
     *     {@code tcp://host:port}, or the name of a serial port
     * @param defaultPort the TCP port when the address names none; 0 if it must name one
     * @param baud speed of a serial port, baud
     * @return the address; nothing is opened
     * @throws IllegalArgumentException if it is no such address; the message has an example
     */
    public static LinkAddress of(String address, int defaultPort, int baud) {
        if (address.startsWith("tcp://") || address.startsWith("//")) {
            InetSocketAddress server = Links.server(address, defaultPort);
            return new LinkAddress(
                    address, Optional.empty(), () -> new TcpLink(server.getHostString(), server.getPort()));
        }
        SerialAddress port = new SerialAddress(address, SerialPorts.system());
        return new LinkAddress(address, Optional.of(port), () -> new SerialLink(port, baud));
    }

    /**
     * Makes the link of the next connection.
     *
     * @return a link, not open
     */
    public Link newLink() {
        return links.get();
    }

    /**
     * Returns the names of the device, under which a program may keep what belongs to it, such as a calibration.
     *
     * @return for the adapter of a serial port that was opened: what identifies it, the name in this address, then its
     *     other names at that time; otherwise this address alone. Each once
     */
    public List<String> names() {
        return serial.flatMap(SerialAddress::opened)
                .map(port -> Stream.of(port.adapter(), text, port.name(), port.device())
                        .filter(name -> !name.isEmpty())
                        .distinct()
                        .toList())
                .orElse(List.of(text));
    }
}
