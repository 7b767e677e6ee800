package majic.link;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.NoSuchFileException;
import java.util.List;
import java.util.Optional;
import majic.link.SerialPorts.Port;
import org.jspecify.annotations.Nullable;

/**
 * The serial port of one robot. After the first connection it is the port of that adapter, whatever the system calls it
 * by then, so that a robot never becomes another one because names have changed. Thread-safe.
 */
final class SerialAddress {
    private final String name;
    private final SerialPorts ports;

    /** The port when it was opened last; null before. */
    private volatile @Nullable Port opened;

    SerialAddress(String name, SerialPorts ports) {
        this.name = name;
        this.ports = ports;
    }

    /** As the user gave it. */
    String name() {
        return name;
    }

    /** What messages call a port: the name that the user gave, unless that is another port now. */
    String nameOf(Port port) {
        return ports.device(name).equals(ports.device(port.device())) ? name : port.device();
    }

    /** The port when it was opened last; empty before. */
    Optional<Port> opened() {
        return Optional.ofNullable(opened);
    }

    void opened(Port port) {
        opened = port;
    }

    /**
     * Finds the port to open now.
     *
     * @throws IOException if there is none, or it may be another adapter than before; the message says which, and what
     *     to do
     */
    Port find() throws IOException {
        Optional<Port> here = ports.find(name);
        Port before = opened;
        if (before == null || ports.isSocket(name)) {
            return here.orElseThrow(this::missing);
        }
        return before.numbered() ? sameNumber(before, here) : sameKind(before, here);
    }

    /** An adapter with a serial number is found under whatever name. */
    private Port sameNumber(Port before, Optional<Port> here) throws IOException {
        Optional<Port> back = ports.list().stream()
                .filter(port -> port.numbered() && port.adapter().equals(before.adapter()))
                .findFirst();
        if (back.isPresent()) {
            return back.get();
        }
        Port there = here.orElseThrow(this::missing);
        throw other("the adapter that this robot had (" + before.adapter() + ") is not plugged in; " + name
                + " is another one now" + (there.adapter().isEmpty() ? "" : " (" + there.adapter() + ")"));
    }

    /** An adapter without a serial number may be another one, unless there was only one of its kind. */
    private Port sameKind(Port before, Optional<Port> here) throws IOException {
        Port there = here.orElseThrow(this::missing);
        if (there.numbered() || !there.kind().equals(before.kind())) {
            throw other(name + " is an adapter of another kind now");
        }
        if (ports.hadSeveral(before.kind())) {
            throw other(name + " may be another adapter now, since there are or were several of its kind without serial"
                    + " numbers and this name does not stay"
                    + (there.stays() ? "; that of its socket does (" + there.name() + ")" : ""));
        }
        return there;
    }

    private IOException other(String what) {
        return new IOException(
                what + "; to use it all the same, add it \"as\" the robot's number",
                new FileAlreadyExistsException(name));
    }

    private IOException missing() {
        Throwable missing = new NoSuchFileException(name);
        return new IOException("there is no serial port " + name + others() + "; is the adapter plugged in?", missing);
    }

    private String others() {
        try {
            List<String> names = ports.list().stream().map(Port::name).toList();
            return names.isEmpty() ? "" : " (there are " + String.join(", ", names) + ")";
        } catch (IOException e) {
            return "";
        }
    }
}
