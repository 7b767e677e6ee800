package majic.link;

import com.fazecast.jSerialComm.SerialPort;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/** The serial ports of this computer. */
public final class SerialPorts {
    private SerialPorts() {}

    /**
     * A serial port that was found.
     *
     * @param name what to open it by: {@code COM3}, {@code /dev/ttyUSB0}
     * @param description the system's name for it, for users; may be the same as the name
     */
    public record Port(String name, String description) {
        /** As a list shows it. */
        @Override
        public String toString() {
            return description.isBlank() || description.equals(name) ? name : name + " – " + description;
        }
    }

    /**
     * Lists them. Takes up to seconds on some systems: not to be called on the event dispatch thread.
     *
     * @return the ports in the order of their names; empty if there are none
     */
    public static List<Port> list() {
        SerialLibrary.load();
        return Arrays.stream(SerialPort.getCommPorts())
                .map(port -> new Port(port.getSystemPortPath(), describe(port)))
                .sorted(Comparator.comparing(Port::name))
                .toList();
    }

    private static String describe(SerialPort port) {
        String descriptive = port.getDescriptivePortName();
        return descriptive == null ? "" : descriptive.strip();
    }
}
