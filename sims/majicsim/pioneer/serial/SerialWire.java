package majicsim.pioneer.serial;

import java.util.function.Consumer;
import majicsim.net.Line;
import majicsim.pioneer.devices.HostBaud;
import org.jspecify.annotations.Nullable;

/**
 * The controller's serial port as its line to the client (ARCOS sheet 1): it carries bytes no faster than its speed,
 * and a client at another speed reads and writes wrong bytes. In an exact lab it takes no time. It cannot be closed.
 */
public final class SerialWire implements Line {
    private static final System.Logger LOG = System.getLogger(SerialWire.class.getName());

    private final HostBaud speed;
    private final boolean takesTime;
    private final SerialPace toClient = new SerialPace(this::deliver);
    private final SerialPace toRobot;
    private final Consumer<byte[]> robot;
    private @Nullable Line plug;
    /** Whether a step has found no byte under way, and none has come since. */
    private boolean rests;

    /** Bytes from the client go to {@code robot}. */
    public SerialWire(HostBaud speed, boolean takesTime, Consumer<byte[]> robot) {
        this.speed = speed;
        this.takesTime = takesTime;
        this.robot = robot;
        this.toRobot = new SerialPace(robot);
    }

    /** Connects the client's end. */
    public void plugIn(Line line) {
        plug = line;
    }

    /** Takes bytes from the client. */
    public void arrive(byte[] bytes) {
        byte[] heard = SerialBits.heard(bytes, clientBaud(), speed.bitsPerSecond());
        if (!takesTime) {
            robot.accept(heard);
        } else if (!enter(toRobot, heard)) {
            LOG.log(System.Logger.Level.DEBUG, "pioneer: {0} bytes on the serial line were too many", heard.length);
        }
    }

    /** Whether no byte is under way. */
    public boolean isIdle() {
        return toRobot.isEmpty() && toClient.isEmpty();
    }

    private boolean enter(SerialPace direction, byte[] bytes) {
        rests = false;
        return direction.enter(bytes);
    }

    public void step(long nanos) {
        if (rests) {
            return;
        }
        rests = isIdle();
        toRobot.step(nanos, speed.bitsPerSecond());
        toClient.step(nanos, speed.bitsPerSecond());
    }

    @Override
    public String peer() {
        return plug == null ? "serial" : plug.peer();
    }

    @Override
    public void send(byte[] message) {
        if (!takesTime) {
            deliver(message);
        } else if (!enter(toClient, message)) {
            LOG.log(System.Logger.Level.DEBUG, "pioneer: the serial line is too slow for all that was asked for");
        }
    }

    @Override
    public void close() {
        // A serial line cannot be closed from this side.
    }

    @Override
    public boolean isOpen() {
        return true;
    }

    private void deliver(byte[] bytes) {
        if (plug != null) {
            plug.send(SerialBits.heard(bytes, speed.bitsPerSecond(), clientBaud()));
        }
    }

    /** A line that has no speed of its own, or does not report it, counts as equally fast. */
    private int clientBaud() {
        int baud = plug == null ? 0 : plug.baud();
        return baud == 0 ? speed.bitsPerSecond() : baud;
    }
}
