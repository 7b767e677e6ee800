package majic.link;

import com.fazecast.jSerialComm.SerialPort;
import java.io.File;
import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * The serial ports of this computer, and the adapters behind them. The system numbers ports in the order in which
 * adapters are found, so {@code /dev/ttyUSB0} can be another adapter after each start. Names that stay are: on Linux
 * the links that udev makes, {@code /dev/serial/by-id} with the adapter's serial number and {@code /dev/serial/by-path}
 * with its socket; elsewhere {@code usb:} with the serial number of a USB adapter. Thread-safe.
 */
public final class SerialPorts {
    /** The beginning of a name that is the serial number of a USB adapter. */
    private static final String USB = "usb:";

    /** What jSerialComm returns for a property that the system does not have. */
    private static final Set<String> NOTHING = Set.of("", "Unknown", "0-0");

    /** Shorter words at the end of a link are part of the model. */
    private static final int SHORTEST_SERIAL_NUMBER = 4;

    private static final Pattern NUMBERED = Pattern.compile("(?:.*/)?(tty(?:USB|ACM))\\d+");

    private static volatile SerialPorts system = new SerialPorts(Path.of("/dev"), SerialPorts::found);

    private final Path devices;
    private final Source source;

    private volatile List<Port> last = List.of();

    /** How many adapters of a kind were found at once, at most. */
    private final Map<String, Integer> mostOfKind = new ConcurrentHashMap<>();

    /**
     * A serial port.
     *
     * @param name what to open it by; stays the same adapter's if the system has such a name
     * @param device the system's name for it now: {@code COM3}, {@code /dev/ttyUSB0}
     * @param description the system's description, for users; may be empty
     * @param adapter identifies the adapter under whatever name, by its serial number or else by its socket; empty if
     *     the system gives neither
     * @param numbered whether it is the serial number that identifies the adapter
     * @param kind make and model of the adapter; empty if unknown
     */
    public record Port(String name, String device, String description, String adapter, boolean numbered, String kind) {
        /**
         * Returns whether the name stays the same adapter's.
         *
         * @return false for a number that the system gives in the order of appearance
         */
        public boolean stays() {
            return !name.equals(device);
        }

        /** As a list shows it. */
        @Override
        public String toString() {
            String details = description.isBlank() || description.equals(device) ? "" : description;
            if (stays()) {
                details += (details.isEmpty() ? "now " : ", now ") + device;
            }
            return details.isEmpty() ? name : name + " – " + details;
        }
    }

    /**
     * A port as the system describes it.
     *
     * @param device its name in the system
     * @param description for users
     * @param kind make and model of a USB adapter; empty if unknown
     * @param serialNumber that of a USB adapter; empty if it has none
     * @param socket where it is plugged in; empty if unknown
     */
    record Found(String device, String description, String kind, String serialNumber, String socket) {}

    /** Lists the ports of the system. */
    @FunctionalInterface
    interface Source {
        List<Found> list() throws IOException;
    }

    /**
     * Creates a view of serial ports.
     *
     * @param devices the folder of devices with the links to them; does not exist on Windows
     * @param source lists the ports
     */
    SerialPorts(Path devices, Source source) {
        this.devices = devices;
        this.source = source;
    }

    /**
     * Returns the ports of this computer.
     *
     * @return the same object at every call
     */
    public static SerialPorts system() {
        return system;
    }

    /** Replaces the ports of this computer, for tests. */
    static void system(SerialPorts other) {
        system = other;
    }

    private static List<Found> found() throws IOException {
        SerialLibrary.load();
        return Arrays.stream(SerialPort.getCommPorts())
                .filter(port -> !isDialInTwin(port.getSystemPortPath()))
                .map(port -> new Found(
                        port.getSystemPortPath(),
                        text(port.getDescriptivePortName()),
                        port.getVendorID() <= 0
                                ? ""
                                : String.format(Locale.ROOT, "%04x:%04x", port.getVendorID(), port.getProductID()),
                        text(port.getSerialNumber()),
                        text(port.getPortLocation())))
                .toList();
    }

    /** Whether a name is that of macOS for incoming calls, which the port has beside {@code /dev/cu.}. */
    private static boolean isDialInTwin(String device) {
        return device.startsWith("/dev/tty.") && new File(device.replace("/dev/tty.", "/dev/cu.")).exists();
    }

    private static String text(String property) {
        return property == null || NOTHING.contains(property.strip()) ? "" : property.strip();
    }

    /**
     * Lists the ports. Takes up to seconds on some systems: not to be called on the event dispatch thread.
     *
     * @return the ports in the order of their devices; empty if there are none
     * @throws IOException if they cannot be listed; the message has the cause and the remedy
     */
    public List<Port> list() throws IOException {
        Map<String, Path> byId = links("by-id");
        Map<String, Path> byPath = links("by-path");
        List<Found> found = devices(byId, byPath);
        List<Port> ports =
                found.stream().map(port -> port(port, found, byId, byPath)).toList();
        ports.stream()
                .collect(Collectors.groupingBy(Port::kind, Collectors.summingInt(port -> 1)))
                .forEach((kind, number) -> mostOfKind.merge(kind, number, Math::max));
        last = ports;
        return ports;
    }

    /** The ports of the system, and those to which only a link leads. A device that is listed twice is one port. */
    private List<Found> devices(Map<String, Path> byId, Map<String, Path> byPath) throws IOException {
        Map<String, Found> all = new TreeMap<>();
        for (Found port : source.list()) {
            String device = real(port.device());
            all.merge(
                    device,
                    completed(port, device, nameOf(byId.get(device))),
                    (one, other) -> one.kind().isEmpty() ? other : one);
        }
        Stream.concat(byId.keySet().stream(), byPath.keySet().stream())
                .forEach(device -> all.computeIfAbsent(
                        device,
                        missing -> completed(new Found(device, "", "", "", ""), device, nameOf(byId.get(device)))));
        return List.copyOf(all.values());
    }

    /**
     * Takes what the system does not give from the names. A kind of adapter whose ports are numbered in the order of
     * their appearance is recognised by them.
     */
    private static Found completed(Found port, String device, String idLink) {
        if (!port.kind().isEmpty()) {
            return new Found(device, port.description(), port.kind(), port.serialNumber(), port.socket());
        }
        Matcher numbered = NUMBERED.matcher(port.device());
        return new Found(
                device, port.description(), numbered.matches() ? numbered.group(1) : "", serialNumberIn(idLink), "");
    }

    private Port port(Found found, List<Found> all, Map<String, Path> byId, Map<String, Path> byPath) {
        Path idLink = byId.get(found.device());
        Path pathLink = byPath.get(found.device());
        List<Found> sameNumber = all.stream()
                .filter(other -> other.serialNumber().equals(found.serialNumber())
                        && other.kind().equals(found.kind()))
                .toList();
        boolean identified = !found.serialNumber().isEmpty()
                && (sameNumber.size() == 1 || sameNumber.stream().allMatch(other -> byId.containsKey(other.device())));
        String name = found.device();
        String adapter = found.socket().isEmpty() ? "" : found.kind() + " at " + found.socket();
        if (identified) {
            name = idLink == null ? USB + found.serialNumber() : idLink.toString();
            adapter = idLink == null ? USB + found.serialNumber() : nameOf(idLink);
        } else if (pathLink != null) {
            name = pathLink.toString();
            adapter = nameOf(pathLink);
        }
        return new Port(name, found.device(), found.description(), adapter, identified, found.kind());
    }

    private static String nameOf(@Nullable Path link) {
        return link == null ? "" : link.getFileName().toString();
    }

    /**
     * Reads the links to devices in a folder of {@code serial}; by what each leads to. Of several links to a device, as
     * the newer names of udev beside its older ones, the first by name counts.
     */
    private Map<String, Path> links(String folder) {
        Map<String, Path> links = new TreeMap<>();
        try (DirectoryStream<Path> all =
                Files.newDirectoryStream(devices.resolve("serial").resolve(folder))) {
            List<Path> sorted = new ArrayList<>();
            all.forEach(sorted::add);
            sorted.sort(Comparator.naturalOrder());
            sorted.stream().filter(Files::exists).forEach(link -> links.putIfAbsent(real(link.toString()), link));
        } catch (IOException e) {
            return links;
        }
        return links;
    }

    /**
     * Finds the serial number in the name of a link that udev has made, {@code usb-MAKE_MODEL_NUMBER-if00-port0}, for a
     * device about which the system gives nothing else; empty if it may have none.
     */
    private static String serialNumberIn(String link) {
        String[] words = link.replaceFirst("-if\\d+(-port\\d+)?$", "").split("_");
        String last = words[words.length - 1];
        boolean isNumber = words.length > 2
                && last.length() >= SHORTEST_SERIAL_NUMBER
                && last.matches("[A-Za-z0-9]*\\d[A-Za-z0-9]*");
        return isNumber ? last : "";
    }

    /**
     * Returns the names that stay, without asking the system for its ports.
     *
     * @return the links to devices that are plugged in now; on systems without such links the names that {@link #list}
     *     found last
     */
    public List<String> namesThatStay() {
        List<String> numbers = last.stream()
                .map(Port::name)
                .filter(name -> name.startsWith(USB))
                .toList();
        return Stream.concat(links().stream(), numbers.stream()).toList();
    }

    private List<String> links() {
        Map<String, Path> byPath = links("by-path");
        Map<String, Path> byId = links("by-id");
        return Stream.concat(
                        byId.values().stream()
                                .filter(link -> !serialNumberIn(nameOf(link)).isEmpty()),
                        byPath.entrySet().stream()
                                .filter(link -> serialNumberIn(nameOf(byId.get(link.getKey())))
                                        .isEmpty())
                                .map(Map.Entry::getValue))
                .map(Path::toString)
                .toList();
    }

    /**
     * Finds what a name stands for at present.
     *
     * @param name as in an address: a device with or without its folder, a link to one, or {@code usb:} with a serial
     *     number
     * @return the port; without description and adapter for a device about which the system gives nothing; empty if
     *     there is none
     * @throws IOException if the ports cannot be listed, or several adapters have that serial number
     */
    public Optional<Port> find(String name) throws IOException {
        List<Port> all = list();
        if (name.startsWith(USB)) {
            return byNumber(name, all);
        }
        String device = real(name);
        Optional<Port> listed =
                all.stream().filter(port -> port.device().equals(device)).findFirst();
        return listed.isPresent() || !new File(device).exists()
                ? listed
                : Optional.of(new Port(device, device, "", "", false, ""));
    }

    private static Optional<Port> byNumber(String name, List<Port> all) throws IOException {
        String number = name.substring(USB.length());
        List<Port> named = all.stream()
                .filter(port -> port.adapter().equals(name)
                        || serialNumberIn(port.adapter()).equals(number))
                .toList();
        if (named.size() > 1) {
            throw new IOException("the serial number " + number + " has several ports: "
                    + String.join(", ", named.stream().map(Port::name).toList()) + "; which one is it?");
        }
        return named.stream().findFirst();
    }

    /**
     * Returns the device that a name stands for, without asking the system for its ports.
     *
     * @param name as in an address
     * @return the device's own name where the name is a link to it; otherwise the name itself, on Windows in upper case
     */
    public String device(String name) {
        return real(name);
    }

    private String real(String name) {
        if (name.startsWith(USB)) {
            return name;
        }
        if (File.separatorChar == '\\') {
            return name.replaceFirst("^\\\\\\\\\\.\\\\", "").toUpperCase(Locale.ROOT);
        }
        Path path = name.contains("/") ? Path.of(home(name)) : devices.resolve(name);
        try {
            return path.toRealPath().toString();
        } catch (IOException e) {
            return path.toString();
        }
    }

    private static String home(String name) {
        return name.startsWith("~/") ? System.getProperty("user.home") + name.substring(1) : name;
    }

    /** Whether a name is one of a socket, which stays. */
    boolean isSocket(String name) {
        return Path.of(name).startsWith(devices.resolve("serial").resolve("by-path"));
    }

    /** Whether several adapters of a kind were plugged in at once since the start of the program. */
    boolean hadSeveral(String kind) {
        return !kind.isEmpty() && mostOfKind.getOrDefault(kind, 0) > 1;
    }
}
