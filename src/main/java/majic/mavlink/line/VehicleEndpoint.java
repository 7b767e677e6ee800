package majic.mavlink.line;

import java.util.Locale;
import java.util.function.Supplier;
import majic.link.Link;
import majic.link.LinkAddress;
import majic.link.UdpLink;

/**
 * Where vehicles are reached. Two endpoints with the same key are one: robots of both share its connection. Immutable.
 *
 * @param key the same for the same port
 * @param title for messages: {@code UDP port 14550}, {@code 10.0.0.5 port 5760}, {@code /dev/ttyUSB0}
 * @param isTcp whether it is a TCP connection
 * @param baud the speed of a serial port; 0 for others
 * @param links makes the link of a connection
 */
public record VehicleEndpoint(String key, String title, boolean isTcp, int baud, Supplier<Link> links) {
    /**
     * A UDP port of this computer that vehicles send to, or one of a vehicle that waits to be spoken to.
     *
     * @param host of the vehicle; empty to wait for vehicles
     * @param port 1 to 65535
     */
    public static VehicleEndpoint udp(String host, int port) {
        return new VehicleEndpoint(
                "udp://" + host.toLowerCase(Locale.ROOT) + ":" + port,
                host.isEmpty() ? "UDP port " + port : host + " UDP port " + port,
                false,
                0,
                () -> new UdpLink(host, port));
    }

    /**
     * A TCP server.
     *
     * @param host its name or address
     * @param port 1 to 65535
     */
    public static VehicleEndpoint tcp(String host, int port) {
        LinkAddress address = LinkAddress.of("//" + host + ":" + port, port, 0);
        return new VehicleEndpoint(
                "tcp://" + host.toLowerCase(Locale.ROOT) + ":" + port,
                host + " port " + port,
                true,
                0,
                address::newLink);
    }

    /**
     * A serial port of this computer.
     *
     * @param name of the port
     * @param baud its speed
     */
    public static VehicleEndpoint serial(String name, int baud) {
        LinkAddress address = LinkAddress.of(name, 0, baud);
        return new VehicleEndpoint("serial:" + name, name, false, baud, address::newLink);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof VehicleEndpoint endpoint && key.equals(endpoint.key);
    }

    @Override
    public int hashCode() {
        return key.hashCode();
    }
}
