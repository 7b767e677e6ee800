package majic.link;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Serial ports in a temporary folder in place of those of the computer, with USB adapters that are plugged in and out.
 */
public final class TestPorts implements AutoCloseable {
    private static final String KIND = "0403:6001";

    private final SerialPorts before = SerialPorts.system();
    private final List<SerialPorts.Found> found = new CopyOnWriteArrayList<>();
    private final Path folder;
    private final SerialPorts all;

    /**
     * Replaces the ports of the computer, until this is closed.
     *
     * @param temporary where the devices are
     */
    public TestPorts(Path temporary) {
        try {
            folder = Files.createTempDirectory(temporary.toRealPath(), "dev");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        all = new SerialPorts(folder, () -> List.copyOf(found));
        SerialPorts.system(all);
    }

    SerialPorts all() {
        return all;
    }

    /** Plugs an adapter in whose device is a file. */
    void plug(String device, String serialNumber, @Nullable String id, @Nullable String socket) throws IOException {
        Files.createFile(folder.resolve(device));
        add(device(device), serialNumber, id, socket);
    }

    /**
     * Plugs an adapter in.
     *
     * @param terminal a pseudo-terminal, as which it is opened
     * @param device what the system calls it now, such as {@code ttyUSB0}
     * @param serialNumber the number of the adapter
     */
    public void plug(String terminal, String device, String serialNumber) throws IOException {
        Files.createSymbolicLink(folder.resolve(device), Path.of(terminal));
        add(terminal, serialNumber, "usb-FTDI_FT232R_USB_UART_" + serialNumber + "-if00-port0", null);
    }

    /**
     * Plugs an adapter in about which the system gives nothing.
     *
     * @param target the device to which the name that is listed is a link
     */
    void plugUnknown(String target, String device, @Nullable String id) throws IOException {
        Files.createSymbolicLink(folder.resolve(device), Path.of(target));
        link("by-id", id, target);
        found.add(new SerialPorts.Found(device(device), "PTY Device", "", "", ""));
    }

    private void add(String device, String serialNumber, @Nullable String id, @Nullable String socket)
            throws IOException {
        link("by-id", id, device);
        link("by-path", socket, device);
        found.add(new SerialPorts.Found(device, "USB adapter", KIND, serialNumber, socket == null ? "" : socket));
    }

    private void link(String kind, @Nullable String name, String device) throws IOException {
        if (name != null) {
            Path link = Files.createDirectories(folder.resolve("serial").resolve(kind))
                    .resolve(name);
            Files.deleteIfExists(link);
            Files.createSymbolicLink(link, Path.of(device));
        }
    }

    /** Pulls all adapters out. */
    public void unplugAll() throws IOException {
        found.clear();
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                if (!file.equals(folder)) {
                    Files.delete(file);
                }
            }
        }
    }

    /** The name of a device with its folder. */
    public String device(String name) {
        return folder.resolve(name).toString();
    }

    String byId(String name) {
        return folder.resolve("serial").resolve("by-id").resolve(name).toString();
    }

    /** The name of the adapter with a serial number, which stays. */
    public String named(String serialNumber) {
        return byId("usb-FTDI_FT232R_USB_UART_" + serialNumber + "-if00-port0");
    }

    String byPath(String name) {
        return folder.resolve("serial").resolve("by-path").resolve(name).toString();
    }

    @Override
    public void close() {
        SerialPorts.system(before);
    }
}
