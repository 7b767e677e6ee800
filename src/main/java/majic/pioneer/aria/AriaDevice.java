package majic.pioneer.aria;

import com.mobilerobots.Aria.ArDeviceConnection;
import com.mobilerobots.Aria.ArSerialConnection;
import com.mobilerobots.Aria.ArTcpConnection;
import java.util.function.IntSupplier;
import java.util.function.Supplier;

/**
 * One of ARIA's own connections to a robot, made when it is opened. Kept as long as ARIA uses it, because ARIA's
 * wrapper keeps no reference to it. For one thread.
 */
final class AriaDevice {
    private static final String SERIAL = "serial:";

    private final String address;
    private final Supplier<Opened> opener;

    /**
     * A connection of ARIA and the result of opening it.
     *
     * @param connection open if the result is 0
     * @param result as {@code open} returns it
     */
    record Opened(ArDeviceConnection connection, int result) {}

    AriaDevice(String address, Supplier<Opened> opener) {
        this.address = address;
        this.opener = opener;
    }

    /**
     * Makes a device; opens nothing.
     *
     * @param address {@code tcp:host:port} or {@code serial:/dev/ttyS0}
     */
    static AriaDevice of(String address) {
        if (address.startsWith(SERIAL)) {
            String port = address.substring(SERIAL.length());
            return new AriaDevice(address, () -> {
                ArSerialConnection serial = new ArSerialConnection();
                return opened(serial, () -> serial.open(port));
            });
        }
        int colon = address.lastIndexOf(':');
        String host = address.substring(address.indexOf(':') + 1, colon);
        int port = Integer.parseInt(address.substring(colon + 1));
        return new AriaDevice(address, () -> {
            ArTcpConnection tcp = new ArTcpConnection();
            return opened(tcp, () -> tcp.open(host, port));
        });
    }

    private static Opened opened(ArDeviceConnection connection, IntSupplier open) {
        return new Opened(connection, open.getAsInt());
    }

    String address() {
        return address;
    }

    Opened open() {
        return opener.get();
    }
}
