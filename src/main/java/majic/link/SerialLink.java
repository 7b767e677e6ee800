package majic.link;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;
import majic.link.SerialPorts.Port;
import org.jspecify.annotations.Nullable;

/**
 * A serial port, 8 data bits, no parity, one stop bit, no flow control.
 *
 * <p>jSerialComm ignores its own write time-out, rounds its read time-outs up to 100 ms, and keeps {@code isOpen()}
 * true after the adapter was unplugged. So reading has no time-out and is woken by closing, the deadline of a write is
 * enforced here, and a negative count means a dead line.
 */
final class SerialLink implements Link {
    /** A quarter of a kilobyte at 9600 baud takes no longer. */
    private static final long LONGEST_OUTPUT_NANOS = TimeUnit.MILLISECONDS.toNanos(300);

    /** The time from a write until it is out, where the system does not tell what is outstanding. */
    private static final long UNTOLD_OUTPUT_NANOS = TimeUnit.MILLISECONDS.toNanos(100);

    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(1);

    /** The devices that this program has open or is opening. */
    private static final Set<String> IN_USE = ConcurrentHashMap.newKeySet();

    private final SerialAddress address;
    private final int baud;
    private final TrafficCounter counter = new TrafficCounter();
    private final ReentrantLock writing = new ReentrantLock();
    private volatile String name;
    private volatile String device;
    private volatile @Nullable SerialPort port;
    private volatile long writtenNanos = System.nanoTime() - UNTOLD_OUTPUT_NANOS;
    private boolean closed;

    SerialLink(SerialAddress address, int baud) {
        this.address = address;
        this.name = address.name();
        this.device = name;
        this.baud = baud;
    }

    @Override
    public void open(int timeoutMs) throws IOException {
        Port found = address.find();
        name = address.nameOf(found);
        SerialOpenError.check(name, found.device(), PortUsers.system());
        if (!IN_USE.add(found.device())) {
            throw SerialOpenError.usedHere(name);
        }
        device = found.device();
        try {
            openHere(found, timeoutMs);
        } finally {
            if (port == null) {
                IN_USE.remove(found.device());
            }
        }
    }

    private void openHere(Port found, int timeoutMs) throws IOException {
        SerialPort opening = library(found.device());
        opening.setComPortParameters(baud, 8, SerialPort.ONE_STOP_BIT, SerialPort.NO_PARITY);
        opening.setFlowControl(SerialPort.FLOW_CONTROL_DISABLED);
        opening.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, 0, 0);
        if (!open(opening, timeoutMs)) {
            throw SerialOpenError.of(name, found.device(), opening.getLastErrorCode());
        }
        address.opened(found);
        counter.opened();
        Links.register(this);
        SerialShutdownDelay.opened(this);
    }

    /** May take seconds: a Bluetooth port opens when the radio has found the robot. */
    private boolean open(SerialPort opening, int timeoutMs) throws IOException {
        try {
            return TimedCall.call("opening " + name, timeoutMs, () -> opening.openPort() && keep(opening));
        } catch (TimeoutException e) {
            end();
            throw new IOException(
                    "the serial port " + name + " did not open within " + timeoutMs / 1000.0
                            + " s; is the robot on and in reach?",
                    e);
        }
    }

    /** Keeps an opened port, unless the link was closed meanwhile. */
    private boolean keep(SerialPort opened) {
        synchronized (this) {
            if (!closed) {
                port = opened;
                return true;
            }
        }
        opened.closePort();
        return false;
    }

    private SerialPort library(String device) throws IOException {
        SerialLibrary.load();
        try {
            return SerialPort.getCommPort(device);
        } catch (SerialPortInvalidPortException e) {
            Throwable missing = new NoSuchFileException(name).initCause(e);
            throw new IOException("there is no serial port " + name + "; is the adapter plugged in?", missing);
        }
    }

    @Override
    public int read(byte[] buffer) throws IOException {
        counter.readerIsBack();
        SerialPort open = port;
        int count = 0;
        while (open != null && port != null && count == 0) {
            count = open.readBytes(buffer, buffer.length);
            if (count == 0 && open.bytesAvailable() < 0) {
                count = -1;
            }
        }
        if (count <= 0) {
            counter.readerAtEnd();
            return -1;
        }
        counter.handedOut(count);
        return count;
    }

    @Override
    public void write(byte[] message) throws IOException {
        SerialPort open = port;
        if (open == null) {
            throw new IOException("the serial port " + name + " is closed");
        }
        WriteDeadline.write(this, writing, "the serial port " + name, () -> {
            counter.writing(message.length);
            if (open.writeBytes(message, message.length) != message.length) {
                throw new IOException("the serial port " + name + " is gone");
            }
            writtenNanos = System.nanoTime();
        });
    }

    @Override
    public void close() {
        SerialPort open = port;
        if (open != null) {
            waitForOutput(open);
        }
        end();
    }

    /**
     * Waits for the output, such as a stop, because the library discards the buffer of a port when it closes the port.
     * Pseudo-terminals, and with them many ports behind a network, report none outstanding.
     */
    private void waitForOutput(SerialPort open) {
        long deadlineNanos = System.nanoTime() + LONGEST_OUTPUT_NANOS;
        while ((open.bytesAwaitingWrite() > 0 || System.nanoTime() - writtenNanos < UNTOLD_OUTPUT_NANOS)
                && System.nanoTime() < deadlineNanos) {
            LockSupport.parkNanos(LOOK_NANOS);
        }
    }

    private void end() {
        SerialPort open;
        synchronized (this) {
            open = port;
            port = null;
            closed = true;
        }
        if (open != null) {
            counter.closed();
            Links.tidy();
            open.closePort();
            IN_USE.remove(device);
        }
        SerialShutdownDelay.closed(this);
    }

    @Override
    public void abort() {
        SerialPort open = port;
        if (open != null) {
            open.flushIOBuffers();
        }
        end();
    }

    @Override
    public boolean setBaud(int rate) throws IOException {
        SerialPort open = port;
        if (open == null || !open.setBaudRate(rate)) {
            throw new IOException("the serial port " + name + " cannot be set to " + rate + " baud");
        }
        return true;
    }

    @Override
    public String address() {
        return "serial:" + name;
    }

    @Override
    public Traffic traffic() {
        return counter.traffic(device, device);
    }
}
